#pragma once

#include <array>
#include <queue>
#include <vector>

#include "mesher/front/front_edge.hpp"

namespace anisofront {

/// Which front edge is advanced first.
enum class BaseOrder {
  metric_length,    ///< the shortest in the metric, ties by age: best where few edges span the
                    ///< grading
  metric_class,     ///< three classes of metric length (short, unit, long), oldest first in each:
                    ///< keeps the front short, so fast and best for large meshes
  physical_length,  ///< the shortest in physical space (the paper), ties by age
  age,              ///< oldest first: layer by layer from the boundary
};

/// The order in which front edges become base segments. Removal is lazy: an entry counts only while
/// the edge still has the version it was pushed with.
class FrontQueue {
 public:
  explicit FrontQueue(BaseOrder order) : order_(order) {}

  /// squared_metric_length, squared_length: of the edge, for the two orders.
  void push(Index edge, Index version, double squared_metric_length, double squared_length);

  /// The next live edge, or kNoIndex when none is left.
  Index pop(const std::vector<FrontEdge>& edges);

 private:
  struct Entry {
    Index edge;
    Index version;
  };
  /// First in, first out; the used part is dropped from time to time.
  struct Fifo {
    std::vector<Entry> entries;
    std::size_t head = 0;
  };
  struct Keyed {
    double key;
    std::uint64_t age;
    Entry entry;
    /// For std::priority_queue: the largest comes out first.
    friend bool operator<(const Keyed& x, const Keyed& y) {
      return x.key > y.key || (x.key == y.key && x.age > y.age);
    }
  };

  bool is_by_length() const {
    return order_ == BaseOrder::metric_length || order_ == BaseOrder::physical_length;
  }
  Index pop_class(const std::vector<FrontEdge>& edges, Fifo& fifo);

  BaseOrder order_;
  std::array<Fifo, 3> classes_;  ///< order age uses the first only
  std::priority_queue<Keyed> shortest_;
  std::uint64_t age_ = 0;
};

}  // namespace anisofront
