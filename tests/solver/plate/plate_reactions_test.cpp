#include "solver/plate/plate_reactions.hpp"

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "solver/plate/solve_plate.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Approx;

namespace {

struct Balance {
  double force = 0;
  Vector moment;
};

/// Loads and reactions together: the work of all of them in the three rigid motions.
Balance balance(const PlateSolution& solution) {
  Balance sum{solution.load, solution.load_moment};
  for (const PlateReaction& r : solution.reactions) {
    sum.force += r.force;
    sum.moment = sum.moment + r.moment + r.lever;
  }
  return sum;
}

void check_balance(const PlateSolution& solution, double scale) {
  const Balance sum = balance(solution);
  CHECK(std::abs(sum.force) < 1e-9 * scale);
  CHECK(norm(sum.moment) < 1e-9 * scale);
  CHECK(solution.work == Approx(solution.energy.total()).epsilon(1e-9));
}

const PlateReaction& reaction(const PlateSolution& solution, Index tag) {
  for (const PlateReaction& r : solution.reactions)
    if (r.tag == tag) return r;
  FAIL("no reaction of tag ", tag);
  return solution.reactions.front();
}

const auto kSine = [](Point p) { return std::sin(kPi * p.x) * std::sin(kPi * p.y); };

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("loads and reactions balance with every element and on every side") {
    struct Row {
      PlateElement element;
      Mesh mesh;
    };
    for (const Row& row : {Row{PlateElement::mitc, mixed_square(5, 4)},
                           {PlateElement::mitc4, square_quads(5, 4)},
                           {PlateElement::arnold_falk, square_mesh(5, 4)}}) {
      const Mesh mesh = turned(perturbed(row.mesh, 5, 4, 0.2, 7), kSmallAngle);
      PlateProblem problem = plate(unit_bending(0.05), [](Point p) { return 1 + p.x - 3 * p.y; });
      problem.supports = {{kBottom, SupportKind::clamped, {}},
                          {kRight, SupportKind::hard_support, {}},
                          {kTop, SupportKind::symmetry, {}},
                          {kLeft, SupportKind::soft_clamped, {}}};
      problem.edge_loads = {{kTop, 0.7, 0.2, -0.4}};
      PlateOptions options;
      options.element = row.element;
      const PlateSolution solution = solve_plate(straight_fe_mesh(mesh), problem, options);
      CHECK(solution.reactions.size() == 4);
      check_balance(solution, 1);
      CHECK(reaction(solution, kTop).force == 0);
    }
  }

  TEST_CASE("the load of a distributed force is its integral and its first moments") {
    // int (1 + x) = 3/2, int x (1 + x) = 5/6, int y (1 + x) = 3/4 on the unit square.
    PlateProblem problem = plate(unit_bending(0.1), [](Point p) { return 1 + p.x; });
    support_all_sides(SupportKind::clamped, problem);
    const Mesh mesh = mixed_square(4, 4);
    const PlateSolution solution = solve_plate(straight_fe_mesh(mesh), problem);
    CHECK(solution.load == Approx(1.5).epsilon(1e-13));
    CHECK(solution.load_moment.x == Approx(5. / 6).epsilon(1e-13));
    CHECK(solution.load_moment.y == Approx(0.75).epsilon(1e-13));
  }

  TEST_CASE("a quarter of the sine loaded hard supported plate has the known reactions") {
    // Q_n = -sin(pi s) / (2 pi) on a side (FE.md 3.2); M_ns = (1 - nu) / (4 pi^2) cos(pi s) and on
    // the axes M_n = (1 + nu) / (4 pi^2) sin(pi s), from the Kirchhoff part of the solution.
    const Mesh mesh = mapped(mixed_square(8, 8), [](Point p) { return 0.5 * p; });
    PlateProblem problem = plate(unit_bending(0.1), kSine);
    problem.supports = {{kBottom, SupportKind::hard_support, {}},
                        {kLeft, SupportKind::hard_support, {}},
                        {kRight, SupportKind::symmetry, {}},
                        {kTop, SupportKind::symmetry, {}}};
    const PlateSolution solution = solve_plate(straight_fe_mesh(mesh), problem);
    check_balance(solution, 1);
    const double pi2 = kPi * kPi, pi3 = pi2 * kPi;
    CHECK(solution.load == Approx(1 / pi2).epsilon(1e-6));
    CHECK(reaction(solution, kBottom).force == Approx(-0.5 / pi2).epsilon(1e-3));
    CHECK(reaction(solution, kBottom).moment.x == Approx(-0.7 / (4 * pi3)).epsilon(1e-3));
    CHECK(std::abs(reaction(solution, kBottom).moment.y) < 1e-15);
    CHECK(reaction(solution, kLeft).force == Approx(-0.5 / pi2).epsilon(1e-3));
    CHECK(reaction(solution, kLeft).moment.y == Approx(-0.7 / (4 * pi3)).epsilon(1e-3));
    CHECK(reaction(solution, kRight).moment.x == Approx(-1.3 / (4 * pi3)).epsilon(1e-3));
    CHECK(reaction(solution, kTop).moment.y == Approx(-1.3 / (4 * pi3)).epsilon(1e-3));
    CHECK(reaction(solution, kRight).force == 0);
  }

  TEST_CASE("a bent rim carries the load of a disc") {
    const CurvedDisc disc(4);
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    for (const SupportKind kind :
         {SupportKind::clamped, SupportKind::hard_support, SupportKind::soft_support}) {
      problem.supports = {{kRim, kind, {}}};
      const PlateSolution solution = solve_plate(disc.fe, problem);
      CHECK(solution.load == Approx(kPi).epsilon(1e-4));
      CHECK(reaction(solution, kRim).force == Approx(-solution.load).epsilon(1e-10));
      check_balance(solution, 1);
    }
  }

  TEST_CASE("a point load is carried by the supports") {
    PlateProblem problem = plate(unit_bending(0.01));
    support_all_sides(SupportKind::hard_support, problem);
    problem.point_loads = {{{0.3, 0.6}, 5}};
    const Mesh mesh = square_mesh(10);
    const PlateSolution solution = solve_plate(straight_fe_mesh(mesh), problem);
    CHECK(solution.load == 5);
    CHECK(solution.load_moment.x == Approx(1.5));
    CHECK(solution.load_moment.y == Approx(3));
    check_balance(solution, 5);
  }

  TEST_CASE("three pins of a free plate carry what does not balance and nothing else") {
    PlateProblem problem = plate(unit_bending(0.1), [](Point p) {
      return std::cos(2 * kPi * p.x) * std::cos(2 * kPi * p.y);
    });
    for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, 1}})
      problem.point_supports.push_back({p, 0, false});
    const Mesh mesh = mixed_square(8, 8);
    const FeMesh fe = straight_fe_mesh(mesh);
    Warnings warnings;
    const PlateSolution balanced = solve_plate(fe, problem, {}, warnings.monitor());
    REQUIRE(balanced.reactions.size() == 1);
    CHECK(balanced.reactions[0].tag == 0);
    CHECK(balanced.reactions[0].largest < 1e-10);
    CHECK(warnings.texts.empty());
    check_balance(balanced, 1);

    // Weight 1 on a square: pins at three corners carry 0, 1/2 and 1/2.
    problem.load = 1.;
    const PlateSolution loaded = solve_plate(fe, problem, {}, warnings.monitor());
    CHECK(loaded.reactions[0].force == Approx(-1));
    CHECK(loaded.reactions[0].largest == Approx(0.5));
    REQUIRE(warnings.texts.size() == 1);
    CHECK(warnings.texts[0].find("point supports carry up to 0.5") != std::string::npos);
  }

  TEST_CASE("a vertex of two supports counts to each in equal parts") {
    // A single quadrilateral on four clamped sides: all load sits in the corners, and each side
    // has two of them.
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    support_all_sides(SupportKind::clamped, problem);
    const Mesh mesh = square_quads(1, 1);
    PlateOptions options;
    options.element = PlateElement::mitc4;
    const PlateSolution solution = solve_plate(straight_fe_mesh(mesh), problem, options);
    for (const Index side : {kBottom, kRight, kTop, kLeft})
      CHECK(reaction(solution, side).force == Approx(-0.25));
  }
}
