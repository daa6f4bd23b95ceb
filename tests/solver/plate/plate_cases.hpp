#pragma once

// Meshes and plates that several tests of the plate start from.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mesher/geometry/domain.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "solver/plate/solve_plate.hpp"
#include "tests/solver/disc_mesh.hpp"

namespace anisofront::test {

inline constexpr double kPi = 3.141592653589793;
inline constexpr double kSmallAngle = 37 * kPi / 180;

/// Plate with D = 1, nu = 0.3, k = 5/6 as in the references.
inline PlateMaterial unit_bending(double thickness) {
  PlateMaterial material;
  material.thickness = thickness;
  material.young = 12 * (1 - 0.09) / (thickness * thickness * thickness);
  return material;
}

inline Vector turned(Vector v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

inline Mesh turned(const Mesh& mesh, double angle) {
  return mapped(mesh, [angle](Point p) { return turned(p, angle); });
}

/// A disc with its rim bent. Keeps the mesh that the view needs.
struct CurvedDisc {
  explicit CurvedDisc(Index rings, double radius = 1)
      : domain(disc_domain(radius)),
        mesh(disc_mesh(rings, radius)),
        fe(curved_fe_mesh(mesh, domain)) {}

  Domain domain;
  Mesh mesh;
  FeMesh fe;
};

inline PlateProblem plate(const PlateMaterial& material, RegionCoefficient load = 0.) {
  PlateProblem problem;
  problem.material = material;
  problem.load = std::move(load);
  return problem;
}

/// The same support on all sides of a square mesh.
inline void support_all_sides(SupportKind kind, PlateProblem& problem) {
  for (const Index side : {kBottom, kRight, kTop, kLeft})
    problem.supports.push_back({side, kind, {}});
}

inline PlateState state_at_vertex(const FeMesh& mesh, const PlateProblem& problem,
                                  const PlateSolution& solution, Point at) {
  const auto states = vertex_states(mesh, problem, solution);
  const PlateState* nearest = &states.front();
  for (const PlateState& s : states)
    if (norm(s.x - at) < norm(nearest->x - at)) nearest = &s;
  return *nearest;
}

/// Collects warnings.
struct Warnings {
  std::vector<std::string> texts;
  Monitor monitor() {
    Monitor m;
    m.warn = [this](const std::string& text) { texts.push_back(text); };
    return m;
  }
};

}  // namespace anisofront::test
