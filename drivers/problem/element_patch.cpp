#include "drivers/problem/element_patch.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

/// Distance on the reference element within which a point counts as on an edge: far above the
/// rounding of a location, far below anything that a solution resolves.
constexpr double kOnEdge = 1e-8;

ReferencePoint reference_corner(Shape shape, int k) {
  constexpr std::array<ReferencePoint, 3> kTriangle{{{0, 0}, {1, 0}, {0, 1}}};
  constexpr std::array<ReferencePoint, 4> kSquare{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  return shape == Shape::triangle ? kTriangle[static_cast<std::size_t>(k)]
                                  : kSquare[static_cast<std::size_t>(k)];
}

/// Where a point lies with respect to edge k: t from 0 to 1 along it, and the distance.
struct EdgePosition {
  double t = 0, distance = 0;
};
EdgePosition position_at_edge(Shape shape, int corners, int k, ReferencePoint at) {
  const ReferencePoint a = reference_corner(shape, k);
  const ReferencePoint b = reference_corner(shape, (k + 1) % corners);
  const Vector edge{b.xi - a.xi, b.eta - a.eta}, offset{at.xi - a.xi, at.eta - a.eta};
  return {dot(offset, edge) / squared_norm(edge), std::fabs(cross(edge, offset)) / norm(edge)};
}

ReferencePoint point_of_edge(const Element& element, int k, double t) {
  const ReferencePoint a = reference_corner(element.shape, k);
  const ReferencePoint b = reference_corner(element.shape, (k + 1) % element.corners);
  return {a.xi + t * (b.xi - a.xi), a.eta + t * (b.eta - a.eta)};
}

/// Place of a value among the first `count` of a local array.
int local_index(const std::array<Index, 4>& numbers, int count, Index wanted) {
  return static_cast<int>(std::find(numbers.begin(), numbers.begin() + count, wanted) -
                          numbers.begin());
}

std::vector<std::array<Index, 2>> elements_at_edges(const FeMesh& mesh) {
  std::vector<std::array<Index, 2>> elements(static_cast<std::size_t>(mesh.edges.count()),
                                             {kNoIndex, kNoIndex});
  const auto add = [&](Index edge, Index element) {
    auto& pair = elements[static_cast<std::size_t>(edge)];
    pair[pair[0] == kNoIndex ? 0 : 1] = element;
  };
  Index number = 0;
  for (const auto& edges : mesh.edges.triangle_edges) {
    for (const Index edge : edges) add(edge, number);
    ++number;
  }
  for (const auto& edges : mesh.edges.quad_edges) {
    for (const Index edge : edges) add(edge, number);
    ++number;
  }
  return elements;
}

}  // namespace

ElementPatches::ElementPatches(const FeMesh& mesh)
    : mesh_(mesh), stars_(vertex_stars(mesh.mesh)), edge_elements_(elements_at_edges(mesh)) {}

std::vector<Location> ElementPatches::around(const Location& place) const {
  const Element& element = place.element;
  for (int k = 0; k < element.corners; ++k) {
    const EdgePosition p = position_at_edge(element.shape, element.corners, k, place.at);
    if (p.distance > kOnEdge) continue;
    const Index from = element.vertices[k], to = element.vertices[(k + 1) % element.corners];
    if (p.t < kOnEdge) return around_vertex(from);
    if (p.t > 1 - kOnEdge) return around_vertex(to);
    return around_edge(element.edges[k], from, p.t);
  }
  return {place};
}

std::vector<Location> ElementPatches::around_vertex(Index vertex) const {
  std::vector<Location> places;
  const auto v = static_cast<std::size_t>(vertex);
  for (Index i = stars_.first[v]; i < stars_.first[v + 1]; ++i) {
    const Element element = element_at(mesh_, stars_.elements[static_cast<std::size_t>(i)]);
    const int corner = local_index(element.vertices, element.corners, vertex);
    places.push_back({element, reference_corner(element.shape, corner)});
  }
  return places;
}

std::vector<Location> ElementPatches::around_edge(Index edge, Index from, double t) const {
  std::vector<Location> places;
  for (const Index number : edge_elements_[static_cast<std::size_t>(edge)]) {
    if (number == kNoIndex) continue;
    const Element element = element_at(mesh_, number);
    const int k = local_index(element.edges, element.corners, edge);
    const bool same_direction = element.vertices[static_cast<std::size_t>(k)] == from;
    places.push_back({element, point_of_edge(element, k, same_direction ? t : 1 - t)});
  }
  return places;
}

}  // namespace anisofront
