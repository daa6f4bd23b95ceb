#pragma once

#include <array>

#include "adapt/goal.hpp"

namespace anisofront {

/// int weight N_j over one element, N_j its nodal functions of second order in the local order of
/// Element (6 of a triangle, 9 of a quadrilateral): with them the integral of weight v is that of
/// the values of v at the nodes, for v of first or second order.
struct WeightMoments {
  Index element = kNoIndex;
  std::array<double, 9> moments{};
};

/// A patch or region mean: J(v) = 1 / whole sum_T sum_j moments[j] v(node j).
struct GoalMean {
  std::vector<WeightMoments> elements;  ///< those with weight, ascending
  double whole = 0;                     ///< int weight over the mesh
};

/// Elements that are large against the disc are subdivided (by halving the longest side) until
/// their parts are not, so that a disc far smaller than an element has its right mean: relative
/// error about 1e-5.
/// Throws InputError: a radius that is not positive, a disc that no element meets, a region tag
/// that no element carries. Precondition: the goal is a mean.
GoalMean goal_mean(const FeMesh& mesh, const Goal& goal);

/// J(v) of a function given by element and reference point.
template <class Function>
double mean_of(const FeMesh& mesh, const GoalMean& mean, const Function& function);

/// The reference points of the nodes of second order: 6 or 9.
std::span<const ReferencePoint> second_order_nodes(Shape shape);

/// f with int f v = J(v) by the rules of the solvers (degree 6 on triangles, 4 x 4 points on
/// quadrilaterals). Inside the disc f is weight / whole; on elements that its rim crosses and that
/// are not small against it, where these rules would not do, the polynomial of second order with
/// the same moments. May be called from several threads; the mesh need not outlive it.
/// Throws InputError as goal_mean() does.
RegionCoefficient mean_source(const FeMesh& mesh, const Goal& goal);

template <class Function>
double mean_of(const FeMesh& mesh, const GoalMean& mean, const Function& function) {
  double sum = 0;
  for (const WeightMoments& own : mean.elements) {
    const Element element = element_at(mesh, own.element);
    const auto nodes = second_order_nodes(element.shape);
    for (std::size_t j = 0; j < nodes.size(); ++j)
      sum += own.moments[j] * function(element, nodes[j]);
  }
  return sum / mean.whole;
}

}  // namespace anisofront
