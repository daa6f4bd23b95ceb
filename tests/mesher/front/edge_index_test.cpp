#include "mesher/front/edge_index.hpp"

#include <algorithm>
#include <random>
#include <set>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

std::vector<Index> brute_force(const std::vector<FrontEdge>& edges, const std::set<Index>& live,
                               const Box& box, Index skip) {
  std::vector<Index> found;
  for (const Index id : live) {
    const FrontEdge& e = edges[id];
    const Box b{{std::min(e.a.x, e.b.x), std::min(e.a.y, e.b.y)},
                {std::max(e.a.x, e.b.x), std::max(e.a.y, e.b.y)}};
    if (id != skip && overlap(b, box)) found.push_back(id);
  }
  return found;
}

/// Random insertions, removals and queries. Edge sizes spread over nine decades.
class Exerciser {
 public:
  Exerciser(const Box& bounds, double typical, unsigned seed)
      : bounds_(bounds), index_(bounds, typical), random_(seed) {}

  /// Queries that differ from brute force.
  int run(int steps, double beyond) {
    int wrong = 0;
    for (int i = 0; i < steps; ++i) {
      if (live_.empty() || unit() < 0.55)
        insert(beyond);
      else if (unit() < 0.8)
        remove();
      wrong += query(i % 5 == 0 ? 10 + beyond : beyond) ? 0 : 1;
    }
    while (!live_.empty()) remove();
    wrong += query(10) ? 0 : 1;
    return wrong;
  }
  int hits() const { return hits_; }

 private:
  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  double size() { return std::pow(10, -9 * unit() * unit()); }
  Point place(double beyond) {
    const double x = std::lerp(-beyond, 1 + beyond, unit());
    const double y = std::lerp(-beyond, 1 + beyond, unit());
    return {std::lerp(bounds_.low.x, bounds_.high.x, x),
            std::lerp(bounds_.low.y, bounds_.high.y, y)};
  }
  Vector step() {
    const double extent = size() * (bounds_.high.x - bounds_.low.x);
    return {extent * (2 * unit() - 1), extent * (2 * unit() - 1)};
  }
  void insert(double beyond) {
    Index id = static_cast<Index>(edges_.size());
    if (free_.empty()) {
      edges_.emplace_back();
    } else {
      id = free_.back();
      free_.pop_back();
    }
    edges_[id].a = place(beyond);
    edges_[id].b = edges_[id].a + step();
    index_.insert(edges_, id);
    live_.insert(id);
  }
  void remove() {
    auto it = live_.begin();
    std::advance(it, static_cast<int>(unit() * 0.999 * static_cast<double>(live_.size())));
    index_.remove(edges_, *it);
    free_.push_back(*it);
    live_.erase(it);
  }
  bool query(double beyond) {
    Point c = place(beyond);
    if (!live_.empty() && unit() < 0.6) c = edges_[*live_.begin()].a;
    const Vector half = 2 * step();
    const Vector h{std::fabs(half.x), std::fabs(half.y)};
    const Box box{c - h, c + h};
    const Index skip = live_.empty() ? kNoIndex : *live_.rbegin();
    std::vector<Index> found{77};
    index_.query(edges_, box, skip, found);
    std::sort(found.begin(), found.end());
    hits_ += static_cast<int>(found.size());
    return found == brute_force(edges_, live_, box, skip);
  }

  Box bounds_;
  EdgeIndex index_;
  std::mt19937_64 random_;
  std::vector<FrontEdge> edges_;
  std::vector<Index> free_;
  std::set<Index> live_;
  int hits_ = 0;
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("queries equal brute force through random insertions and removals") {
    for (const double typical : {0.5, 0.02, 1e-4}) {
      Exerciser exerciser({{0, 0}, {1, 1}}, typical, 1);
      CHECK(exerciser.run(4000, 0) == 0);
      CHECK(exerciser.hits() > 4000);
    }
  }

  TEST_CASE("flat and shifted bounds work") {
    Exerciser flat({{-1, 5}, {1, 5.001}}, 0.01, 2);
    CHECK(flat.run(3000, 0) == 0);
    Exerciser shifted({{1e6, -1e6}, {1e6 + 1, -1e6 + 1}}, 0.01, 3);
    CHECK(shifted.run(3000, 0) == 0);
  }

  TEST_CASE("boxes far outside the bounds are answered") {
    std::vector<FrontEdge> edges(1);
    edges[0].a = {0.9, 0.9};
    edges[0].b = {1, 1};
    EdgeIndex index({{0, 0}, {1, 1}}, 0.1);
    index.insert(edges, 0);
    std::vector<Index> found;
    index.query(edges, {{-1e300, -1e300}, {1e300, 1e300}}, kNoIndex, found);
    CHECK(found == std::vector<Index>{0});
    index.query(edges, {{1, 1}, {1e18, 1e18}}, kNoIndex, found);
    CHECK(found == std::vector<Index>{0});
    index.query(edges, {{1.1, 1.1}, {1e18, 1e18}}, kNoIndex, found);
    CHECK(found.empty());
    index.query(edges, {{0, 0}, {1, 1}}, 0, found);
    CHECK(found.empty());
  }
}
