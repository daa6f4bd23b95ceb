#include "adapt/transfer.hpp"

#include "solver/scalar/scalar_basis.hpp"

namespace anisofront {

std::vector<double> components_at(PointLocation& from, std::span<const Point> points,
                                  int components, const Evaluate& evaluate) {
  const auto width = static_cast<std::size_t>(components);
  std::vector<double> values(points.size() * width);
  for (std::size_t i = 0; i < points.size(); ++i)
    evaluate(from.nearest(points[i]), std::span(values).subspan(i * width, width));
  return values;
}

std::vector<double> values_at(PointLocation& from, const ScalarField& field,
                              std::span<const Point> points) {
  return components_at(from, points, 1, [&](const Location& place, std::span<double> value) {
    value[0] = scalar_state(from.mesh(), field, place.element, place.at).value;
  });
}

std::vector<Point> node_points(const FeMesh& mesh, int order) {
  std::vector<Point> points = mesh.mesh.points;
  if (order == 1) return points;
  points.insert(points.end(), mesh.edge_points.begin(), mesh.edge_points.end());
  const auto triangles = static_cast<Index>(mesh.mesh.triangles.size());
  for (Index e = triangles; e < mesh.element_count(); ++e)
    points.push_back(element_at(mesh, e).nodes[8]);
  return points;
}

ScalarField carried(PointLocation& from, const ScalarField& field, const FeMesh& target,
                    int order) {
  ScalarField result{order, make_dof_map(target, scalar_layout(order)), {}, {}};
  std::vector<double> values = values_at(from, field, node_points(target, order));
  result.inner.assign(values.begin() + result.dofs.count(), values.end());
  values.resize(result.dofs.count());
  result.values = std::move(values);
  return result;
}

}  // namespace anisofront
