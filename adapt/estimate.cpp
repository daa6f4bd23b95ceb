#include "adapt/estimate.hpp"

#include <cmath>

#include "solver/space/p1_element.hpp"
#include "solver/space/quadrature.hpp"

namespace anisofront {
namespace {

/// Mean over a triangle of the square of the linear function with these corner values: exact.
double mean_square(const std::array<double, 3>& v) {
  const double sum = v[0] + v[1] + v[2];
  return (sum * sum + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 12;
}
double mean_square(const std::array<Vector, 3>& v) {
  return mean_square(std::array{v[0].x, v[1].x, v[2].x}) +
         mean_square(std::array{v[0].y, v[1].y, v[2].y});
}

}  // namespace

EnergyEstimate estimate_energy_error(const Mesh& mesh, const ScalarProblem& problem,
                                     std::span<const double> values,
                                     std::span<const LocalQuadratic> quadratics) {
  EnergyEstimate squares;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const Triangle& t = mesh.triangles[k];
    const auto corners = corners_of(mesh, t);
    const P1Element element(corners);
    const Point centroid = point_at(corners, {1. / 3, 1. / 3, 1. / 3});
    const Index region = k < mesh.triangle_regions.size() ? mesh.triangle_regions[k] : 0;
    const double a = problem.diffusion.in(region)(centroid);
    const double c = problem.reaction.in(region)(centroid);
    const auto u = values_at(values, t);
    const Vector constant = element.gradient(u);
    std::array<Vector, 3> recovered{}, difference{};
    for (int i = 0; i < 3; ++i) {
      recovered[i] = quadratics[t[i]].gradient;
      difference[i] = recovered[i] - constant;
    }
    squares.error += element.area * a * mean_square(difference);
    squares.energy += element.area * (a * mean_square(recovered) + c * mean_square(u));
  }
  return {std::sqrt(squares.error), std::sqrt(squares.energy)};
}

}  // namespace anisofront
