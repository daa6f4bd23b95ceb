#include <array>

#include "solver/plate/solve_plate.hpp"

namespace anisofront {
namespace {

ReferencePoint corner(Shape shape, int k) {
  constexpr std::array<ReferencePoint, 3> kTriangle{{{0, 0}, {1, 0}, {0, 1}}};
  constexpr std::array<ReferencePoint, 4> kSquare{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  return shape == Shape::triangle ? kTriangle[k] : kSquare[k];
}

void add(const PlateState& state, PlateState& sum) {
  sum.w += state.w;
  sum.rotation = sum.rotation + state.rotation;
  sum.moments.xx += state.moments.xx;
  sum.moments.yy += state.moments.yy;
  sum.moments.xy += state.moments.xy;
  sum.shear = sum.shear + state.shear;
}

void divide(double count, PlateState& sum) {
  sum.w /= count;
  sum.rotation = (1 / count) * sum.rotation;
  sum.moments = {sum.moments.xx / count, sum.moments.yy / count, sum.moments.xy / count};
  sum.shear = (1 / count) * sum.shear;
}

}  // namespace

PlateState plate_state(const FeMesh& mesh, const PlateProblem& problem,
                       const PlateSolution& solution, const Element& element, ReferencePoint at) {
  const LocalValues values =
      local_values(mesh, solution.dofs, element, solution.values, solution.inner);
  return plate_state(solution.element, problem.material_in(element.region), element, values, at);
}

std::vector<PlateState> vertex_states(const FeMesh& mesh, const PlateProblem& problem,
                                      const PlateSolution& solution) {
  std::vector<PlateState> states(mesh.mesh.points.size());
  std::vector<int> count(states.size(), 0);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    for (int k = 0; k < element.corners; ++k) {
      const Index v = element.vertices[k];
      add(plate_state(mesh, problem, solution, element, corner(element.shape, k)), states[v]);
      ++count[v];
    }
  }
  for (std::size_t v = 0; v < states.size(); ++v) {
    divide(count[v], states[v]);
    states[v].x = mesh.mesh.points[v];
  }
  return states;
}

}  // namespace anisofront
