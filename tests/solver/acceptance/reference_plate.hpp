#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/space/reference_quadrature.hpp"
#include "tests/solver/acceptance/graded_mesh.hpp"
#include "tests/solver/acceptance/solved_plate.hpp"

namespace anisofront::acceptance {

/// Twice the density of the energy: M : C^-1 : M + Q . Q / (k G t).
inline double energy_density(const PlateMaterial& material, const Moments& m, Vector q) {
  const double nu = material.poisson, bending = material.bending_stiffness();
  return (m.xx * m.xx + m.yy * m.yy - 2 * nu * m.xx * m.yy) / (bending * (1 - nu * nu)) +
         2 * m.xy * m.xy / (bending * (1 - nu)) + dot(q, q) / material.shear_stiffness();
}

/// A plate on [0, x.back()] x [0, y.back()], the quarter of one that is symmetric about the last x
/// line and the last y line, solved by mitc quadrilaterals on a tensor mesh that is fine enough to
/// stand for the exact solution. The state is known on the whole plate.
class ReferencePlate {
 public:
  /// The sides have the tags of square_mesh().
  ReferencePlate(PlateProblem problem, std::vector<double> x, std::vector<double> y)
      : x_(std::move(x)), y_(std::move(y)), plate_(quads_on(x_, y_), std::move(problem)) {}

  const PlateSolution& solution() const { return plate_.solution; }

  /// In the quarter or in its mirror images.
  PlateState at(Point p) const {
    const bool is_right = p.x > x_.back(), is_upper = p.y > y_.back();
    const Place x = place(x_, is_right ? 2 * x_.back() - p.x : p.x),
                y = place(y_, is_upper ? 2 * y_.back() - p.y : p.y);
    PlateState state =
        plate_state(plate_.fe, plate_.problem, plate_.solution,
                    element_at(plate_.fe, y.interval * intervals(x_) + x.interval), {x.at, y.at});
    state.x = p;
    if (is_right) mirror(state.rotation.x, state.shear.x, state.moments.xy);
    if (is_upper) mirror(state.rotation.y, state.shear.y, state.moments.xy);
    return state;
  }

 private:
  struct Place {
    Index interval;
    double at;  ///< in [-1, 1]
  };

  static Place place(const std::vector<double>& lines, double s) {
    const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, s);
    const double low = *(above - 1), high = *above;
    return {static_cast<Index>(above - lines.begin()) - 1, (2 * s - low - high) / (high - low)};
  }

  static void mirror(double& rotation, double& shear, double& twist) {
    rotation = -rotation;
    shear = -shear;
    twist = -twist;
  }

  std::vector<double> x_, y_;
  SolvedPlate plate_;
};

/// Norm of the error in the energy norm over that of the solution, both over the mesh: from the
/// moments and shear forces at the points of a rule of degree 8 in each element, so layers must be
/// resolved. The mesh lies in the reference plate (or its mirror images). `state` gives the
/// PlateState to be judged at an element's reference point.
template <class State>
double relative_energy_error(const FeMesh& mesh, const PlateProblem& problem, State state,
                             const ReferencePlate& reference) {
  double error = 0, whole = 0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    const PlateMaterial& material = problem.material_in(element.region);
    for (const WeightedPoint& point : reference_quadrature(element.shape, 8)) {
      const PlateState found = state(element, point.at), exact = reference.at(found.x);
      const Moments difference{found.moments.xx - exact.moments.xx,
                               found.moments.yy - exact.moments.yy,
                               found.moments.xy - exact.moments.xy};
      const double weight = point.weight * map_at(element, point.at).determinant();
      error += weight * energy_density(material, difference, found.shear - exact.shear);
      whole += weight * energy_density(material, exact.moments, exact.shear);
    }
  }
  return std::sqrt(error / whole);
}

/// Of a solution of solve_plate().
inline double relative_energy_error(const FeMesh& mesh, const PlateProblem& problem,
                                    const PlateSolution& solution,
                                    const ReferencePlate& reference) {
  return relative_energy_error(
      mesh, problem,
      [&](const Element& element, ReferencePoint at) {
        return plate_state(mesh, problem, solution, element, at);
      },
      reference);
}

inline double relative_energy_error(const SolvedPlate& plate, const ReferencePlate& reference) {
  return relative_energy_error(plate.fe, plate.problem, plate.solution, reference);
}

}  // namespace anisofront::acceptance
