// Constant curvature on distorted, stretched meshes of all kinds (FE.md, table 6, row 5): what
// every plate element must reproduce under moments on its edges.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "solver/plate/solve_plate.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// w = (a X^2 + 2 b X Y + c Y^2) / 2 about the centre of the unit square, with the constant moments
/// that belong to it.
struct ConstantCurvature {
  double a = 1, b = -0.7, c = 0.4;

  double w(Point p) const {
    const Vector r = p - Point{0.5, 0.5};
    return 0.5 * (a * r.x * r.x + 2 * b * r.x * r.y + c * r.y * r.y);
  }
  /// For D = 1 and nu = 0.3.
  Moments moments() const { return {-(a + 0.3 * c), -(c + 0.3 * a), -0.7 * b}; }
};

/// A free plate on three pins is the hardest case; round-off of the matrix entries alone takes nine
/// digits of it at aspect 64, where the sides hold the deflection instead.
enum class Held { at_three_corners, along_sides };

/// A square plate under the edge moments n.M n and n.M s, s anticlockwise from n.
PlateProblem bent_by_edges(const ConstantCurvature& exact, double thickness, Held held) {
  PlateProblem problem = plate(unit_bending(thickness));
  const auto [xx, yy, xy] = exact.moments();
  problem.edge_loads = {
      {kBottom, 0, yy, -xy}, {kRight, 0, xx, xy}, {kTop, 0, yy, -xy}, {kLeft, 0, xx, xy}};
  if (held == Held::at_three_corners) {
    for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, 1}})
      problem.point_supports.push_back({p, exact.w(p), false});
  } else {
    support_all_sides(SupportKind::soft_support, problem);
    for (PlateSupport& side : problem.supports)
      side.deflection = [exact](Point p) { return exact.w(p); };
  }
  return problem;
}

struct PatchErrors {
  double moments = 0;  ///< relative to the largest
  double shear = 0;    ///< |Q| / S
  double deflection = 0;
};

PatchErrors patch_errors(const Mesh& mesh, PlateElement element, Held held) {
  const ConstantCurvature exact;
  const PlateProblem problem = bent_by_edges(exact, 1e-3, held);
  const FeMesh fe = straight_fe_mesh(mesh);
  PlateOptions options;
  options.element = element;
  const PlateSolution solution = solve_plate(fe, problem, options);
  const auto [xx, yy, xy] = exact.moments();
  PatchErrors errors;
  for (Index e = 0; e < fe.element_count(); ++e) {
    const Element at = element_at(fe, e);
    for (const ReferencePoint p : {ReferencePoint{0.2, 0.3}, {0.6, 0.3}, {0.1, 0.8}}) {
      const PlateState state = plate_state(fe, problem, solution, at, p);
      const Moments& m = state.moments;
      for (const double error : {m.xx - xx, m.yy - yy, m.xy - xy})
        errors.moments = std::max(errors.moments, std::abs(error) / 1.12);
      errors.shear = std::max(errors.shear, norm(state.shear) / problem.material.shear_stiffness());
      // Deflections are exact at the nodes; on triangles everywhere.
      if (at.shape == Shape::triangle && element == PlateElement::mitc)
        errors.deflection = std::max(errors.deflection, std::abs(state.w - exact.w(state.x)));
    }
  }
  return errors;
}

void check_patch(const Mesh& mesh, PlateElement element, Held held) {
  const PatchErrors errors = patch_errors(mesh, element, held);
  CAPTURE(errors.moments);
  CAPTURE(errors.shear);
  CHECK(errors.moments < 1e-6);
  CHECK(errors.shear < 1e-10);
  CHECK(errors.deflection < 1e-6);
}

void check_patches(const std::function<Mesh(Index, Index)>& mesh, PlateElement element) {
  for (const Index aspect : {1, 8, 64}) {
    CAPTURE(aspect);
    const Index nx = 4, ny = 4 * aspect;
    const Mesh distorted = perturbed(mesh(nx, ny), nx, ny, 0.3, 1);
    check_patch(distorted, element, Held::along_sides);
    if (aspect < 64 && element != PlateElement::arnold_falk)
      check_patch(distorted, element, Held::at_three_corners);
  }
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("triangles of any stretch reproduce constant curvature") {
    check_patches([](Index nx, Index ny) { return square_mesh(nx, ny); }, PlateElement::mitc);
  }
  TEST_CASE("quadrilaterals of any stretch reproduce constant curvature") {
    check_patches(square_quads, PlateElement::mitc);
  }
  TEST_CASE("triangles and quadrilaterals together reproduce constant curvature") {
    check_patches(mixed_square, PlateElement::mitc);
  }
  TEST_CASE("the low order quadrilateral reproduces constant curvature") {
    check_patches(square_quads, PlateElement::mitc4);
  }
  TEST_CASE("the low order triangle reproduces constant curvature") {
    check_patches([](Index nx, Index ny) { return square_mesh(nx, ny); },
                  PlateElement::arnold_falk);
  }
}
