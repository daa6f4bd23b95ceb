#pragma once

#include <functional>
#include <span>
#include <vector>

#include "adapt/point_location.hpp"
#include "solver/scalar/scalar_field.hpp"

namespace anisofront {

/// Writes the components of a solution at a place: deflection and rotations of a plate, say.
using Evaluate = std::function<void(const Location&, std::span<double>)>;

/// `components` numbers per point, those of points[0] first. Outside the mesh, the values of its
/// nearest point.
std::vector<double> components_at(PointLocation& from, std::span<const Point> points,
                                  int components, const Evaluate& evaluate);

/// Values of a field on the mesh of `from`.
std::vector<double> values_at(PointLocation& from, const ScalarField& field,
                              std::span<const Point> points);

/// The nodes of elements of that order in the order of a field: vertices, then (order 2) the points
/// of the edges, then the centres of the quadrilaterals.
std::vector<Point> node_points(const FeMesh& mesh, int order);

/// The field of the order given with the values of `field` at the nodes of `target`. Exact for
/// functions that both spaces hold.
ScalarField carried(PointLocation& from, const ScalarField& field, const FeMesh& target, int order);

}  // namespace anisofront
