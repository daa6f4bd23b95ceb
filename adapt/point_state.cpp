#include "adapt/point_state.hpp"

#include <utility>

namespace anisofront {
namespace {

Vector normal_to(Vector s) { return {s.y, -s.x}; }

std::vector<double> gradient_along(const std::vector<double>& state, Vector s) {
  const Vector gradient{state[1], state[2]};
  return {dot(gradient, normal_to(s)), dot(gradient, s)};
}

std::vector<double> stresses_along(const std::vector<double>& state, Vector s) {
  const Vector n = normal_to(s), shear{state[6], state[7]};
  const auto product = [&](Vector a, Vector b) {
    return a.x * state[3] * b.x + a.y * state[4] * b.y + (a.x * b.y + a.y * b.x) * state[5];
  };
  return {product(n, n), product(s, s), product(n, s), dot(shear, n), dot(shear, s)};
}

std::vector<double> as_values(const PlateState& s) {
  return {s.w,          s.rotation.x, s.rotation.y, s.moments.xx,
          s.moments.yy, s.moments.xy, s.shear.x,    s.shear.y};
}

}  // namespace

Quantities scalar_quantities() { return {{"u", "u_x", "u_y"}, {"u_n", "u_s"}, gradient_along}; }

Quantities plate_quantities() {
  return {{"w", "theta_x", "theta_y", "M_xx", "M_yy", "M_xy", "Q_x", "Q_y"},
          {"M_n", "M_s", "M_ns", "Q_n", "Q_s"},
          stresses_along};
}

PointState scalar_point_state(const FeMesh& mesh, std::shared_ptr<const ScalarSolution> solution) {
  return {scalar_quantities(), [&mesh, solution = std::move(solution)](const Location& place) {
            const ScalarState state = scalar_state(mesh, solution->field, place.element, place.at);
            return std::vector{state.value, state.gradient.x, state.gradient.y};
          }};
}

PointState plate_point_state(const FeMesh& mesh, std::shared_ptr<const PlateProblem> problem,
                             std::shared_ptr<const PlateSolution> solution) {
  return {plate_quantities(), [&mesh, problem = std::move(problem),
                               solution = std::move(solution)](const Location& place) {
            return as_values(plate_state(mesh, *problem, *solution, place.element, place.at));
          }};
}

}  // namespace anisofront
