#include "solver/plate/plate_loads.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Approx;
using doctest::Contains;

namespace {

struct Loaded {
  DofMap dofs;
  Eigen::VectorXd rhs;
};

Loaded loaded(const FeMesh& mesh, PlateElement element, const PlateProblem& problem) {
  Loaded result{make_dof_map(mesh, plate_layout(element)), {}};
  result.rhs.setZero(result.dofs.count());
  add_edge_loads(mesh, result.dofs, element, problem, result.rhs);
  add_point_loads(mesh, result.dofs, element, problem, result.rhs);
  return result;
}

/// Work of the loads in a deflection and a rotation field, by their values at the nodes of mitc.
double work(const FeMesh& mesh, const Loaded& loaded, const ScalarFunction& w,
            const VectorFunction& theta) {
  double sum = 0;
  const auto add = [&](Index first, Point p) {
    sum += loaded.rhs[first] * w(p) + loaded.rhs[first + 1] * theta(p).x +
           loaded.rhs[first + 2] * theta(p).y;
  };
  for (Index v = 0; v < loaded.dofs.vertices; ++v)
    add(loaded.dofs.at_vertex(v), mesh.mesh.points[v]);
  for (Index e = 0; e < loaded.dofs.edges; ++e) add(loaded.dofs.at_edge(e), mesh.edge_points[e]);
  return sum;
}

const auto kNoDeflection = [](Point) { return 0.; };
const auto kNoRotation = [](Point) { return Vector{}; };

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a constant shear force is spread by Simpson's rule") {
    const Mesh mesh = square_mesh(1);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem;
    problem.edge_loads = {{kBottom, 6, 0, 0}};
    const Loaded mitc = loaded(fe, PlateElement::mitc, problem);
    const Index bottom = mitc.dofs.at_edge(fe.edges.curve_edges[0]);
    CHECK(mitc.rhs[0] == Approx(1));
    CHECK(mitc.rhs[3] == Approx(1));
    CHECK(mitc.rhs[bottom] == Approx(4));
    CHECK(mitc.rhs.cwiseAbs().sum() == Approx(6));
    const Loaded falk = loaded(fe, PlateElement::arnold_falk, problem);
    CHECK(falk.rhs[falk.dofs.at_edge(fe.edges.curve_edges[0])] == Approx(6));
    CHECK(falk.rhs.cwiseAbs().sum() == Approx(6));
    const Mesh quad = square_quads(1, 1);
    const Loaded mitc4 = loaded(straight_fe_mesh(quad), PlateElement::mitc4, problem);
    CHECK(mitc4.rhs[0] == Approx(3));
    CHECK(mitc4.rhs[3] == Approx(3));
    CHECK(mitc4.rhs.cwiseAbs().sum() == Approx(6));
  }

  TEST_CASE("quadratic loads do the exact work in quadratic deflections") {
    // Right side x = 1: int_0^1 y^2 (1 + y + y^2) dy = 1/3 + 1/4 + 1/5.
    const Mesh mesh = mixed_square(3, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem;
    problem.edge_loads = {{kRight, [](Point p) { return p.y * p.y; }, 0, 0}};
    const auto w = [](Point p) { return p.x + p.y + p.x * p.y * p.y; };
    CHECK(work(fe, loaded(fe, PlateElement::mitc, problem), w, kNoRotation) ==
          Approx(47. / 60).epsilon(1e-13));
  }

  TEST_CASE("couples act against rotations along the normal and anticlockwise from it") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto theta = [](Point) { return Vector{2, 3}; };
    struct Row {
      Index side;
      Vector n, s;
    };
    for (const auto& [side, n, s] : {Row{kBottom, {0, -1}, {1, 0}},
                                     {kRight, {1, 0}, {0, 1}},
                                     {kTop, {0, 1}, {-1, 0}},
                                     {kLeft, {-1, 0}, {0, -1}}}) {
      PlateProblem problem;
      problem.edge_loads = {{side, 0, 1, 0}};
      CHECK(work(fe, loaded(fe, PlateElement::mitc, problem), kNoDeflection, theta) ==
            Approx(-(2 * n.x + 3 * n.y)));
      problem.edge_loads = {{side, 0, 0, 1}};
      CHECK(work(fe, loaded(fe, PlateElement::mitc, problem), kNoDeflection, theta) ==
            Approx(-(2 * s.x + 3 * s.y)));
    }
  }

  TEST_CASE("on a bent rim the loads follow length and normal of the curve") {
    // Radius 2: int 1 ds = 4 pi, int x^2 ds = 8 pi, int n.x ds = int s.(-y, x) ds = 8 pi.
    const CurvedDisc disc(6, 2.);
    PlateProblem problem;
    problem.edge_loads = {{kRim, 1, 0, 0}};
    const auto at = [&](const ScalarFunction& w, const VectorFunction& theta) {
      return work(disc.fe, loaded(disc.fe, PlateElement::mitc, problem), w, theta);
    };
    const auto near = [](double value) { return Approx(value).epsilon(2e-6); };
    CHECK(at([](Point) { return 1.; }, kNoRotation) == near(4 * kPi));
    CHECK(at([](Point p) { return p.x * p.x; }, kNoRotation) == near(8 * kPi));
    problem.edge_loads = {{kRim, 0, 1, 0}};
    CHECK(at(kNoDeflection, [](Point p) { return p; }) == near(-8 * kPi));
    CHECK(std::abs(at(kNoDeflection, [](Point) { return Vector{1, 1}; })) < 1e-13);
    problem.edge_loads = {{kRim, 0, 0, 1}};
    CHECK(at(kNoDeflection, [](Point p) { return Vector{-p.y, p.x}; }) == near(-8 * kPi));
    CHECK(std::abs(at(kNoDeflection, [](Point p) { return p; })) < 1e-12);
  }

  TEST_CASE("a point load acts on the deflection of the nearest vertex") {
    const Mesh mesh = square_mesh(2);
    PlateProblem problem;
    problem.point_loads = {{{0.45, 0.55}, 7}, {{0.5, 0.5}, -2}};
    const FeMesh fe = straight_fe_mesh(mesh);
    const Loaded result = loaded(fe, PlateElement::mitc, problem);
    CHECK(result.rhs[3 * 4] == 5);
    CHECK(result.rhs.cwiseAbs().sum() == 5);
    CHECK_THROWS_AS(loaded(fe, PlateElement::arnold_falk, problem), UsageError);
    problem.point_loads = {{{2, 2}, 7}};
    CHECK_THROWS_WITH_AS(loaded(fe, PlateElement::mitc, problem), Contains("outside the mesh"),
                         InputError);
  }

  TEST_CASE("the resultant is the work in rigid motions") {
    const Mesh mesh = mixed_square(2, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem;
    problem.point_loads = {{{0.5, 1}, 2}};
    problem.edge_loads = {{kRight, -4, 0, 0}, {kTop, 0, 3, 0}};
    const Loaded result = loaded(fe, PlateElement::mitc, problem);
    const LoadResultant sum = resultant(fe, result.dofs, PlateElement::mitc, result.rhs);
    CHECK(sum.force == Approx(2 - 4));
    CHECK(sum.moment.x == Approx(2 * 0.5 - 4 * 1));
    CHECK(sum.moment.y == Approx(2 * 1 - 4 * 0.5 - 3));
    CHECK(sum.absolute == Approx(6));
  }

  TEST_CASE("loads that are not numbers are refused with the place") {
    const Mesh mesh = square_mesh(1);
    PlateProblem problem;
    problem.edge_loads = {{kLeft, 0, [](Point p) { return std::sqrt(p.y - 0.5); }, 0}};
    CHECK_THROWS_WITH_AS(loaded(straight_fe_mesh(mesh), PlateElement::mitc, problem),
                         Contains("the moment of an edge load is"), InputError);
  }
}
