#include "mesher/front/front_queue.hpp"

namespace anisofront {
namespace {

/// Bounds of the unit class in squared length. Edges of a uniform mesh have length 1 up to
/// rounding, so 1 must lie inside a class: then ties are broken by age, which keeps the front
/// compact, and not by rounding.
constexpr double kUnitLow = 0.98, kUnitHigh = 1.02;

}  // namespace

void FrontQueue::push(Index edge, Index version, double squared_metric_length,
                      double squared_length) {
  if (is_by_length()) {
    const double key = order_ == BaseOrder::metric_length ? squared_metric_length : squared_length;
    shortest_.push({key, age_++, {edge, version}});
    return;
  }
  const bool first = order_ == BaseOrder::age || squared_metric_length < kUnitLow;
  const int k = first ? 0 : squared_metric_length < kUnitHigh ? 1 : 2;
  classes_[k].entries.push_back({edge, version});
}

Index FrontQueue::pop_class(const std::vector<FrontEdge>& edges, Fifo& fifo) {
  constexpr std::size_t kCompactAt = 1024;
  while (fifo.head < fifo.entries.size()) {
    const Entry entry = fifo.entries[fifo.head++];
    if (fifo.head >= kCompactAt && 2 * fifo.head >= fifo.entries.size()) {
      fifo.entries.erase(fifo.entries.begin(),
                         fifo.entries.begin() + static_cast<std::ptrdiff_t>(fifo.head));
      fifo.head = 0;
    }
    if (edges[entry.edge].version == entry.version) return entry.edge;
  }
  fifo.entries.clear();
  fifo.head = 0;
  return kNoIndex;
}

Index FrontQueue::pop(const std::vector<FrontEdge>& edges) {
  if (!is_by_length()) {
    for (Fifo& fifo : classes_) {
      const Index edge = pop_class(edges, fifo);
      if (edge != kNoIndex) return edge;
    }
    return kNoIndex;
  }
  while (!shortest_.empty()) {
    const Entry entry = shortest_.top().entry;
    shortest_.pop();
    if (edges[entry.edge].version == entry.version) return entry.edge;
  }
  return kNoIndex;
}

}  // namespace anisofront
