#include "drivers/report/mesh_detail.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

struct Shape {
  double thickness = 0;  ///< area / longest edge
  double longest = 0;
  Point centre;
};

template <class Element>
Shape shape_of(const Mesh& mesh, const Element& element) {
  Shape shape;
  double twice = 0;
  Point previous = mesh.points[static_cast<std::size_t>(element.back())];
  for (const Index v : element) {
    const Point p = mesh.points[static_cast<std::size_t>(v)];
    twice += cross(previous, p);
    shape.longest = std::max(shape.longest, norm(p - previous));
    shape.centre = shape.centre + 1. / static_cast<double>(element.size()) * p;
    previous = p;
  }
  shape.thickness = shape.longest > 0 ? std::fabs(twice) / 2 / shape.longest : 0;
  return shape;
}

std::vector<Shape> shapes_of(const Mesh& mesh) {
  std::vector<Shape> shapes;
  for (const Triangle& triangle : mesh.triangles) shapes.push_back(shape_of(mesh, triangle));
  for (const Quad& quad : mesh.quads) shapes.push_back(shape_of(mesh, quad));
  return shapes;
}

bool is_thinner(const Shape& a, const Shape& b) { return a.thickness < b.thickness; }

/// The most stretched of the thinnest.
Shape most_stretched(const std::vector<Shape>& shapes, double thinnest) {
  constexpr double kAlike = 1.5;
  Shape best;
  for (const Shape& shape : shapes)
    if (shape.thickness <= kAlike * thinnest && shape.longest > best.longest) best = shape;
  return best;
}

/// At least 60 thicknesses are shown, and more of stretched elements, to show how long they are, as
/// long as the thickness can be seen.
double half_width(const Shape& shape) {
  return std::clamp(0.7 * shape.longest, 30 * shape.thickness, 120 * shape.thickness);
}

/// [low, high] of the length 2 `half` around `centre`, moved into [least, greatest] but for a bit
/// of blank beyond these.
std::pair<double, double> within(double centre, double half, double least, double greatest) {
  constexpr double kBlank = 0.06;
  const double inner = (1 - kBlank) * half;
  const double middle = std::clamp(centre, least + inner, greatest - inner);
  return {middle - half, middle + half};
}

}  // namespace

std::optional<PlaneWindow> detail_window(const Mesh& mesh) {
  constexpr double kRange = 30, kLargestShare = 0.5;
  const std::vector<Shape> shapes = shapes_of(mesh);
  if (shapes.empty()) return {};
  const auto [thinnest, thickest] = std::minmax_element(shapes.begin(), shapes.end(), is_thinner);
  if (!(thinnest->thickness > 0) || thickest->thickness < kRange * thinnest->thickness) return {};
  Point low = mesh.points.front(), high = low;
  for (const Point p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Shape shape = most_stretched(shapes, thinnest->thickness);
  const double half = half_width(shape);
  const double extent = std::min(high.x - low.x, high.y - low.y);
  if (2 * half > kLargestShare * extent) return {};
  const auto [left, right] = within(shape.centre.x, half, low.x, high.x);
  const auto [below, above] = within(shape.centre.y, half, low.y, high.y);
  return PlaneWindow{{left, below}, {right, above}};
}

}  // namespace anisofront
