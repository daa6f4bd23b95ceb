#include "solver/plate/plate_supports.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// Conditions on the bottom side of one cell of two triangles, turned by an angle: unknowns are
/// 3 v + (w, theta_x, theta_y) of vertices 0 to 3, then those of the edges.
struct OneCell {
  explicit OneCell(double angle) : mesh(turned(square_mesh(1), angle)), fe(straight_fe_mesh(mesh)) {
    dofs = make_dof_map(fe, plate_layout(PlateElement::mitc));
  }
  PlateConditions hold(SupportKind kind, Coefficient deflection = {}) const {
    PlateProblem problem;
    problem.supports = {{kBottom, kind, std::move(deflection)}};
    return plate_conditions(fe, dofs, PlateElement::mitc, problem);
  }
  Mesh mesh;
  FeMesh fe;
  DofMap dofs;
};

std::vector<Index> unknowns(const PlateConditions& conditions) {
  std::vector<Index> result;
  for (const Constraint& c : conditions.constraints) result.push_back(c.unknown);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("on an axis the unknowns themselves are held") {
    const OneCell cell(0);
    const Index e = cell.dofs.at_edge(cell.fe.edges.curve_edges[0]);  // the bottom edge
    const auto hard = cell.hold(SupportKind::hard_support);
    CHECK(hard.frames.empty());
    CHECK(unknowns(hard) == std::vector<Index>{0, 1, 3, 4, e, e + 1});
    const auto soft_clamped = cell.hold(SupportKind::soft_clamped);
    CHECK(unknowns(soft_clamped) == std::vector<Index>{0, 2, 3, 5, e, e + 2});
    const auto symmetry = cell.hold(SupportKind::symmetry);
    CHECK(unknowns(symmetry) == std::vector<Index>{2, 5, e + 2});
    CHECK(cell.hold(SupportKind::free).constraints.empty());
  }

  TEST_CASE("on an oblique edge the first of two turned unknowns is held") {
    const OneCell cell(kSmallAngle);
    const auto hard = cell.hold(SupportKind::hard_support);
    const Index e = cell.dofs.at_edge(cell.fe.edges.curve_edges[0]);
    CHECK(unknowns(hard) == std::vector<Index>{0, 1, 3, 4, e, e + 1});
    REQUIRE(hard.frames.size() == 3);
    CHECK(hard.frames[0].first == 1);
    for (const Frame& frame : hard.frames) {
      CHECK(norm(frame.axis) == doctest::Approx(1).epsilon(1e-14));
      CHECK(std::abs(cross(frame.axis, turned({1, 0}, kSmallAngle))) < 1e-15);
    }
  }

  TEST_CASE("where both rotations are held no frame is needed") {
    const auto clamped = OneCell(kSmallAngle).hold(SupportKind::clamped);
    CHECK(clamped.frames.empty());
    CHECK(clamped.constraints.size() == 9);
  }

  TEST_CASE("deflections are prescribed and rotations held at zero") {
    const auto conditions = OneCell(0).hold(SupportKind::clamped, 0.25);
    for (const Constraint& c : conditions.constraints)
      CHECK(c.value == (c.unknown % 3 == 0 ? 0.25 : 0));
  }

  TEST_CASE("no unknown is constrained twice where conditions meet") {
    const Mesh mesh = turned(mixed_square(3, 3), kSmallAngle);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem;
    support_all_sides(SupportKind::hard_support, problem);
    problem.point_supports = {{turned({1, 1}, kSmallAngle), 0, true}};
    const auto held = unknowns(plate_conditions(
        fe, make_dof_map(fe, plate_layout(PlateElement::mitc)), PlateElement::mitc, problem));
    CHECK(std::adjacent_find(held.begin(), held.end()) == held.end());
    // 12 vertices and 12 edges hold w, corners two rotations, the others one.
    CHECK(held.size() == 24 + 8 + 20);
  }
}
