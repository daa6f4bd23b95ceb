// Row 8 on discs: clamped and simply supported circular plates in closed form, and the paradox of
// Babuska: a hard supported polygon does not tend to the hard supported circle.
// I. Babuska, The theory of small changes in the domain of existence in the theory of partial
// differential equations and its applications, in: Differential Equations and Their Applications,
// Prague (1963) 13-26.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "mesher/generate.hpp"
#include "tests/solver/acceptance/disc_plates.hpp"
#include "tests/solver/acceptance/square_plates.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;
using std::numbers::pi;

namespace {

/// Radius 1, q = 1, D = 1, nu = 0.3: at the centre w and M, and U = 1/2 int q w.
struct DiscReference {
  double w, moment, energy;
};

/// w = (1 - r^2) (c - r^2) / 64 + (1 - r^2) / (4 k G t), c = 1 clamped, (5 + nu) / (1 + nu) simply
/// supported. At t = 0.1 references.json has w = 0.0163392857, U = 8.742229557e-3 (clamped) and
/// w = 0.0644162088 (supported).
DiscReference disc_reference(SupportKind kind, double thickness) {
  const double shear = 0.25 * thickness * thickness / 3.5;
  const double c = kind == SupportKind::clamped ? 1 : 5.3 / 1.3;
  return {c / 64 + shear, kind == SupportKind::clamped ? 1.3 / 16 : 3.3 / 16,
          pi * ((c / 2 - (1 + c) / 4 + 1. / 6) / 64 + 0.25 * shear)};
}

PlateProblem disc_plate(SupportKind kind, double thickness) {
  PlateProblem problem;
  problem.material = unit_plate(thickness);
  problem.load = 1;
  problem.supports = {{kEdge, kind, {}}};
  return problem;
}

void check_disc(const SolvedPlate& plate, const DiscReference& exact) {
  const PlateState centre = state_at(plate, {0, 0});
  CHECK(relative_error(centre.w, exact.w) <= 1e-5);
  CHECK(relative_error(plate.solution.energy.total(), exact.energy) <= 2e-5);
  CHECK(relative_error(centre.moments.xx, exact.moment) <= 3e-3);
  CHECK(relative_error(centre.moments.yy, exact.moment) <= 3e-3);
}

/// On triangles and on quadrilaterals.
void check_discs(SupportKind kind, double thickness) {
  CAPTURE(static_cast<int>(kind));
  CAPTURE(thickness);
  const DiscReference exact = disc_reference(kind, thickness);
  const PlateProblem problem = disc_plate(kind, thickness);
  check_disc(SolvedPlate(disc_of_triangles(16, 12), unit_disc(), problem), exact);
  check_disc(SolvedPlate(disc_of_quads(16, 12), unit_disc(), problem), exact);
}

/// The disc meshed by the project's own mesher with elements of equal size.
Mesh generated_disc(double size, Elements elements) {
  Mesh background = disc_of_triangles(8, 6);
  GenerateOptions options = generate_options(Preset::best);
  options.elements = elements;
  options.quads.effort = QuadEffort::fast;
  return generate(unit_disc(), background,
                  testing::sample(background, [&](Point) { return metric_from_size(size); }),
                  options)
      .mesh;
}

double energy_error(const SolvedPlate& plate, const DiscReference& exact) {
  return plate.solution.energy.total() / exact.energy - 1;
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("circular plates with bent edges give their closed forms") {
    for (const SupportKind kind : {SupportKind::clamped, SupportKind::hard_support})
      for (const double thickness : {.1, .001}) check_discs(kind, thickness);
  }

  TEST_CASE(
      "shear and moment at the edge of a clamped circular plate are -q a / 2 and -q a^2 / 8") {
    for (const bool quads : {false, true}) {
      const SolvedPlate plate(quads ? disc_of_quads(16, 12) : disc_of_triangles(16, 12),
                              unit_disc(), disc_plate(SupportKind::clamped, .1));
      const PlateState edge = state_at(plate, {1, 0});
      CHECK(relative_error(edge.shear.x, -0.5) <= 5e-3);
      CHECK(std::abs(edge.shear.y) <= 5e-3);
      CHECK(relative_error(edge.moments.xx, -0.125) <= 5e-3);
    }
  }

  TEST_CASE("circular plates on meshes of the project's own mesher give their closed forms") {
    for (const Elements elements : {Elements::triangle, Elements::quadrilateral})
      for (const SupportKind kind : {SupportKind::clamped, SupportKind::hard_support}) {
        CAPTURE(static_cast<int>(elements));
        CAPTURE(static_cast<int>(kind));
        const SolvedPlate plate(generated_disc(0.08, elements), unit_disc(), disc_plate(kind, .01));
        CHECK(std::abs(energy_error(plate, disc_reference(kind, .01))) <= 1e-4);
      }
  }

  TEST_CASE("a hard supported polygon stays wrong as it is refined and bent edges cure it") {
    const double thickness = .001;
    const PlateProblem problem = disc_plate(SupportKind::hard_support, thickness);
    const DiscReference exact = disc_reference(SupportKind::hard_support, thickness);
    for (const bool quads : {false, true})
      for (const Index n : {4, 8}) {
        CAPTURE(quads);
        CAPTURE(n);
        const Mesh mesh = quads ? disc_of_quads(n, 3 * n / 4) : disc_of_triangles(n, 3 * n / 4);
        CHECK(energy_error(SolvedPlate(mesh, problem), exact) < -0.5);
        CHECK(std::abs(energy_error(SolvedPlate(mesh, unit_disc(), problem), exact)) <= 1e-3);
      }
  }

  TEST_CASE("the solver warns of a hard supported polygon and not of bent edges") {
    const PlateProblem problem = disc_plate(SupportKind::hard_support, .01);
    const Mesh mesh = disc_of_quads(4, 3);
    std::vector<std::string> warnings;
    Monitor monitor;
    monitor.warn = [&](const std::string& text) { warnings.push_back(text); };
    solve_plate(curved_fe_mesh(mesh, unit_disc()), problem, {}, monitor);
    CHECK(warnings.empty());
    solve_plate(straight_fe_mesh(mesh), problem, {}, monitor);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("Babuska") != std::string::npos);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("circular plates with bent edges give their closed forms for more supports") {
    for (const SupportKind kind : {SupportKind::clamped, SupportKind::hard_support})
      check_discs(kind, .01);
    for (const double thickness : {.1, .01, .001})
      check_discs(SupportKind::soft_support, thickness);
  }
}
