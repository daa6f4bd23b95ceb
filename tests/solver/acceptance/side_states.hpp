#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tests/solver/acceptance/solved_plate.hpp"

namespace anisofront::acceptance {

inline ReferencePoint corner_of(Shape shape, int k) {
  constexpr ReferencePoint kTriangle[] = {{0, 0}, {1, 0}, {0, 1}};
  constexpr ReferencePoint kSquare[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  return shape == Shape::triangle ? kTriangle[k % 3] : kSquare[k % 4];
}

/// The states on a straight side, each from the element that holds the point.
class SideStates {
 public:
  SideStates(const SolvedPlate& plate, Index tag) : plate_(plate) {
    std::vector<char> is_wanted(static_cast<std::size_t>(plate.fe.edges.count()), 0);
    for (std::size_t i = 0; i < plate.mesh.edges.size(); ++i)
      is_wanted[plate.fe.edges.curve_edges[i]] = plate.mesh.edges[i].tag == tag;
    for (Index e = 0; e < plate.fe.element_count(); ++e) {
      const Element element = element_at(plate.fe, e);
      for (int k = 0; k < element.corners; ++k)
        if (is_wanted[element.edges[k]]) sides_.push_back({e, k});
    }
  }

  PlateState at(Point p) const {
    Place best{};
    double distance = std::numeric_limits<double>::infinity();
    for (const Side& side : sides_) {
      const Element element = element_at(plate_.fe, side.element);
      const Point a = element.nodes[side.edge],
                  b = element.nodes[(side.edge + 1) % element.corners];
      const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0., 1.);
      if (norm(p - lerp(a, b, t)) >= distance) continue;
      distance = norm(p - lerp(a, b, t));
      best = {side, t};
    }
    return state(best);
  }

  /// At the ends and `inner` points between of each edge.
  std::vector<PlateState> sampled(int inner) const {
    std::vector<PlateState> states;
    for (const Side& side : sides_)
      for (int i = 0; i <= inner + 1; ++i) states.push_back(state({side, i / (inner + 1.)}));
    return states;
  }

 private:
  struct Side {
    Index element;
    int edge;
  };
  struct Place {
    Side side;
    double t;
  };

  PlateState state(const Place& place) const {
    const Element element = element_at(plate_.fe, place.side.element);
    const ReferencePoint a = corner_of(element.shape, place.side.edge),
                         b = corner_of(element.shape, place.side.edge + 1);
    return plate_state(plate_.fe, plate_.problem, plate_.solution, element,
                       {std::lerp(a.xi, b.xi, place.t), std::lerp(a.eta, b.eta, place.t)});
  }

  const SolvedPlate& plate_;
  std::vector<Side> sides_;
};

/// Largest |value(state)| among five points of each edge of a side.
template <class Function>
double largest_on_side(const SolvedPlate& plate, Index tag, Function value) {
  double largest = 0;
  for (const PlateState& state : SideStates(plate, tag).sampled(3))
    largest = std::max(largest, std::abs(value(state)));
  return largest;
}

}  // namespace anisofront::acceptance
