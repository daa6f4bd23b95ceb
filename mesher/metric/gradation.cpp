#include "mesher/metric/gradation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/interpolation.hpp"

namespace anisofront {

namespace {

constexpr double kTolerance = 1e-3;  // of squared lengths
constexpr int kMaxVisits = 100;

/// Vertices whose metric still has to reach their neighbours, each at most once in the queue.
class WorkQueue {
 public:
  /// Starts with all vertices, the finest first: then a graded field settles in one pass.
  explicit WorkQueue(const MetricField& field)
      : waiting_(field.size()), is_waiting_(field.size(), 1), visits_(field.size(), 0) {
    std::vector<double> density(field.size());
    std::transform(field.begin(), field.end(), density.begin(),
                   [](const Metric& m) { return determinant(m); });
    std::iota(waiting_.begin(), waiting_.end(), 0);
    std::sort(waiting_.begin(), waiting_.end(), [&density](Index a, Index b) {
      return density[a] != density[b] ? density[a] > density[b] : a < b;
    });
  }
  bool empty() const { return waiting_.empty(); }
  Index pop() {
    const Index v = waiting_.front();
    waiting_.pop_front();
    is_waiting_[v] = 0;
    ++visits_[v];
    return v;
  }
  void push(Index v) {
    if (is_waiting_[v] || visits_[v] >= kMaxVisits) return;
    is_waiting_[v] = 1;
    waiting_.push_back(v);
  }

 private:
  std::deque<Index> waiting_;
  std::vector<char> is_waiting_;
  std::vector<int> visits_;
};

/// Intersects the metric that p allows at q into m_q; false when m_q asks for that much already.
bool refine(Metric& m_q, const Metric& m_p, Vector pq, double log_ratio) {
  const double growth = 1 + length(m_p, pq) * log_ratio;
  const Metric allowed = scaled(m_p, 1 / (growth * growth));
  const SimultaneousReduction r = simultaneous_reduction(allowed, m_q);
  if (std::max(r.lambda1, r.lambda2) <= 1 + kTolerance) return false;
  m_q = std::min(r.lambda1, r.lambda2) >= 1
            ? allowed
            : metric_from_reduction(r.s1, r.s2, std::max(r.lambda1, 1.), std::max(r.lambda2, 1.));
  return true;
}

}  // namespace

void limit_gradation(const Mesh& mesh, MetricField& field, double ratio) {
  if (field.size() != mesh.points.size())
    throw InputError("the metric field has " + std::to_string(field.size()) +
                     " entries, expected one per vertex: " + std::to_string(mesh.points.size()));
  if (!(ratio > 1)) return;
  const double log_ratio = std::log(ratio);
  const VertexNeighbours neighbours = vertex_neighbours(mesh);
  WorkQueue queue(field);
  while (!queue.empty()) {
    const Index p = queue.pop();
    for (Index i = neighbours.first[p]; i < neighbours.first[static_cast<std::size_t>(p) + 1];
         ++i) {
      const Index q = neighbours.vertices[i];
      if (refine(field[q], field[p], mesh.points[q] - mesh.points[p], log_ratio)) queue.push(q);
    }
  }
}

}  // namespace anisofront
