#include "solver/plate/plate_problem.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Contains;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Mesh named_square() {
  Mesh mesh = square_mesh(2);
  mesh.groups = {{1, kBottom, "bottom"}, {1, kLeft, "left"}, {1, 9, "hole"}, {2, 1, "slab"}};
  return mesh;
}

void check_refused(const PlateProblem& problem, const char* words) {
  const Mesh mesh = named_square();
  CHECK_THROWS_WITH_AS(validate(problem, straight_fe_mesh(mesh)), Contains(words), InputError);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("stiffnesses follow from modulus and thickness and Poisson's ratio") {
    // Steel of 10 mm: D = 210000 1000 / (12 0.91) = 19230769.23 N mm.
    const PlateMaterial steel{210000, 0.3, 10, 5. / 6};
    CHECK(steel.bending_stiffness() == doctest::Approx(19230769.230769).epsilon(1e-13));
    CHECK(steel.shear_stiffness() == doctest::Approx(673076.923076923).epsilon(1e-13));
  }

  TEST_CASE("a sound problem passes with and without loads") {
    const Mesh mesh = named_square();
    PlateProblem problem;
    CHECK_NOTHROW(validate(problem, straight_fe_mesh(mesh)));
    problem.supports = {{kBottom, SupportKind::clamped, {}}, {kLeft, SupportKind::free, {}}};
    problem.edge_loads = {{kLeft, 1, 0, 0}};
    problem.load = 3;
    CHECK_NOTHROW(validate(problem, straight_fe_mesh(mesh)));
  }

  TEST_CASE("materials that are none are refused with the region") {
    check_refused(plate({0, 0.3, 1, 1}),
                  "Young's modulus of the plate in region \"slab\" (tag 1) is 0");
    check_refused(plate({1, 0.3, -1, 1}),
                  "thickness of the plate in region \"slab\" (tag 1) is -1");
    check_refused(plate({1, 0.3, 1, kNan}), "the shear factor");
    check_refused(plate({1, 0.5, 1, 1}), "expected a number between -1 and 0.5");
    check_refused(plate({1, -1, 1, 1}), "expected a number between -1 and 0.5");
    check_refused(plate({1, kNan, 1, 1}), "expected a number between -1 and 0.5");
  }

  TEST_CASE("plates thinner than a hundred thousandth of their side are refused with the reason") {
    check_refused(plate({1, 0.3, 0.99e-5, 1}), "(L/t)^2 (L/h)^4");
    const Mesh mesh = named_square();
    CHECK_NOTHROW(validate(plate({1, 0.3, 1e-5, 1}), straight_fe_mesh(mesh)));
  }

  TEST_CASE("a default material that no region uses is not looked at") {
    const Mesh mesh = named_square();
    PlateProblem problem = plate({0, 9, 0, 0});
    problem.regions = {{1, PlateMaterial{}}};
    CHECK_NOTHROW(validate(problem, straight_fe_mesh(mesh)));
    CHECK(problem.material_in(1).young == 1);
    CHECK(problem.material_in(2).young == 0);
  }

  TEST_CASE("tags that the mesh does not carry are refused with what it has") {
    PlateProblem problem;
    problem.supports = {{9, SupportKind::clamped, {}}};
    check_refused(problem,
                  "support on \"hole\" (tag 9): no edge of the mesh carries it; the mesh has "
                  "\"bottom\" (tag 1), tag 2, tag 3, \"left\" (tag 4)");
    problem.supports.clear();
    problem.edge_loads = {{8, 1, 0, 0}};
    check_refused(problem, "edge load on tag 8: no edge");
    problem.edge_loads.clear();
    problem.regions = {{5, PlateMaterial{}}};
    check_refused(problem, "plate material on tag 5: no element");
    problem.regions.clear();
    problem.load.set(6, 1.);
    check_refused(problem,
                  "load on tag 6: no element of the mesh carries it; the mesh has \"slab\"");
  }

  TEST_CASE("edges without a tag cannot be supported") {
    Mesh mesh = named_square();
    for (CurveEdge& edge : mesh.edges) edge.tag = 0;
    PlateProblem problem;
    problem.supports = {{0, SupportKind::clamped, {}}};
    CHECK_THROWS_WITH_AS(validate(problem, straight_fe_mesh(mesh)), Contains("the mesh has none"),
                         InputError);
  }

  TEST_CASE("a curve supported twice is refused") {
    PlateProblem problem;
    problem.supports = {{kLeft, SupportKind::clamped, {}}, {kLeft, SupportKind::free, {}}};
    check_refused(problem, "support on \"left\" (tag 4) is given twice");
  }

  TEST_CASE("a vertex that no element has is refused with its number and place") {
    Mesh mesh = named_square();
    mesh.points.push_back({0.3, 0.4});
    CHECK_THROWS_WITH_AS(validate({}, straight_fe_mesh(mesh)),
                         Contains("vertex 10 of the mesh at (0.3, 0.4) belongs to no element"),
                         InputError);
  }

  TEST_CASE("numbers that are not finite are refused with the place") {
    PlateProblem problem;
    problem.supports = {{kLeft, SupportKind::clamped, kNan}};
    check_refused(problem, "deflection prescribed on \"left\" (tag 4) is nan");
    problem.supports.clear();
    problem.load = kNan;
    check_refused(problem, "the load is nan");
    problem.load = 0.;
    problem.edge_loads = {{kLeft, 0, kNan, 0}};
    check_refused(problem, "the edge load on \"left\" (tag 4)");
    problem.edge_loads.clear();
    problem.point_loads = {{{0.5, 0.5}, kNan}};
    check_refused(problem, "the point load at (0.5, 0.5) is nan");
    problem.point_loads.clear();
    problem.point_supports = {{{kNan, 0.5}, 0, false}};
    check_refused(problem, "the deflection of the point support at (nan, 0.5)");
  }
}
