#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "solver/plate/solve_plate.hpp"

namespace anisofront::acceptance {

/// A plate with its solution and the mesh that the view needs.
struct SolvedPlate {
  SolvedPlate(Mesh m, PlateProblem p, PlateElement element = PlateElement::mitc)
      : mesh(std::move(m)),
        fe(straight_fe_mesh(mesh)),
        problem(std::move(p)),
        solution(solve(element)) {}
  /// With edges bent along the curves of the domain.
  SolvedPlate(Mesh m, const Domain& domain, PlateProblem p,
              PlateElement element = PlateElement::mitc)
      : mesh(std::move(m)),
        fe(curved_fe_mesh(mesh, domain)),
        problem(std::move(p)),
        solution(solve(element)) {}
  SolvedPlate(const SolvedPlate&) = delete;
  SolvedPlate& operator=(const SolvedPlate&) = delete;

  Mesh mesh;
  FeMesh fe;
  PlateProblem problem;
  PlateSolution solution;

 private:
  PlateSolution solve(PlateElement element) const {
    PlateOptions options;
    options.element = element;
    return solve_plate(fe, problem, options);
  }
};

/// At the vertex next to p, the mean over the elements round it.
inline PlateState state_at(const SolvedPlate& plate, Point p) {
  const auto states = vertex_states(plate.fe, plate.problem, plate.solution);
  return *std::min_element(states.begin(), states.end(), [p](const auto& a, const auto& b) {
    return norm(a.x - p) < norm(b.x - p);
  });
}

inline double relative_error(double value, double exact) { return std::abs(value / exact - 1); }

}  // namespace anisofront::acceptance
