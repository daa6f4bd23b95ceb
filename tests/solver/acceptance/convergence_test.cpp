// Row 7: orders of convergence against references.json. mitc: 4 for energy and deflection (theta of
// second degree), 2 for moments at vertices; the baselines: 2.
#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "tests/solver/acceptance/reference_plate.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

/// Errors below this (relative) are those of what the mesh does not resolve: the layer of t^2 at
/// clamped edges; round-off for t = 0.001.
constexpr double kFloor = 2e-6;

struct Errors {
  double energy, deflection, moment;
};

Errors errors_of(const SolvedPlate& plate, const SquareReference& exact) {
  const PlateState centre = state_at(plate, {0.5, 0.5});
  return {relative_error(4 * plate.solution.energy.total(), exact.energy),
          relative_error(centre.w, exact.w), relative_error(centre.moments.xx, exact.mx)};
}

enum class Cells { triangles, quads, mixed };

Mesh on(Cells cells, const std::vector<double>& lines) {
  return cells == Cells::triangles ? triangles_on(lines, lines)
         : cells == Cells::quads   ? quads_on(lines, lines)
                                   : mixed_on(lines, lines);
}

Errors uniform_errors(Cells cells, Index n, const SquareReference& exact,
                      PlateElement element = PlateElement::mitc) {
  return errors_of(SolvedPlate(on(cells, equal_lines(n, 0.5)),
                               quarter_plate(exact.plate, exact.thickness), element),
                   exact);
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

void check_high_order(double coarse, double fine) {
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK((order(coarse, fine) >= 3.5 || fine <= kFloor));
}

bool is_smooth(const SquareReference& exact) {
  return exact.plate == SquarePlate::hard || exact.plate == SquarePlate::clamped;
}

void check_orders(Cells cells, const SquareReference& exact) {
  CAPTURE(static_cast<int>(cells));
  CAPTURE(name_of(exact.plate));
  CAPTURE(exact.thickness);
  const Errors coarse = uniform_errors(cells, 16, exact), fine = uniform_errors(cells, 32, exact);
  check_high_order(coarse.energy, fine.energy);
  check_high_order(coarse.deflection, fine.deflection);
  CHECK(fine.energy <= kFloor);
  CHECK(fine.deflection <= kFloor);
  CHECK(order(coarse.moment, fine.moment) >= 1.9);
  CHECK(fine.moment <= 2e-3);
}

}  // namespace

TEST_SUITE("convergence") {
  TEST_CASE("mitc converges with order four and moments with order two on uniform meshes") {
    for (const SquareReference& exact : kSquareReferences)
      if (is_smooth(exact) && exact.thickness != .01)
        for (const Cells cells : {Cells::triangles, Cells::quads}) check_orders(cells, exact);
  }

  // Above the floor from the coarsest mesh on.
  TEST_CASE("mitc on coarse meshes has order 3.5 and more") {
    for (const SquareReference& exact : kSquareReferences) {
      if (exact.plate != SquarePlate::hard) continue;
      CAPTURE(exact.thickness);
      const Errors triangles[] = {uniform_errors(Cells::triangles, 4, exact),
                                  uniform_errors(Cells::triangles, 16, exact)};
      CHECK(order(triangles[0].energy, triangles[1].energy) / 2 >= 3.5);
      const Errors quads[] = {uniform_errors(Cells::quads, 8, exact),
                              uniform_errors(Cells::quads, 16, exact)};
      CHECK(order(quads[0].energy, quads[1].energy) >= 3.5);
      CHECK(order(quads[0].deflection, quads[1].deflection) >= 3.5);
    }
  }

  TEST_CASE("mitc4 and Arnold-Falk converge with order two") {
    for (const SquareReference& exact : kSquareReferences) {
      if (!is_smooth(exact) || exact.thickness == .01) continue;
      CAPTURE(name_of(exact.plate));
      CAPTURE(exact.thickness);
      const auto check_order = [&](Cells cells, PlateElement element) {
        const Errors coarse = uniform_errors(cells, 16, exact, element),
                     fine = uniform_errors(cells, 32, exact, element);
        CHECK(std::abs(order(coarse.energy, fine.energy) - 2) <= 0.1);
        CHECK(fine.energy >= 100 * kFloor);  // what the high order is for
        CHECK(order(coarse.moment, fine.moment) >= 1.9);
      };
      check_order(Cells::quads, PlateElement::mitc4);
      check_order(Cells::triangles, PlateElement::arnold_falk);
    }
  }

  TEST_CASE("mitc quadrilaterals keep order four at soft supports once the layer is resolved") {
    for (const SquareReference& exact : kSquareReferences) {
      if (exact.plate != SquarePlate::soft) continue;
      CAPTURE(exact.thickness);
      const auto errors = [&](Index n) {
        const auto lines = layer_lines(n, 0.5, plate_layer(exact.thickness));
        return errors_of(
            SolvedPlate(quads_on(lines, lines), quarter_plate(exact.plate, exact.thickness)),
            exact);
      };
      const Errors coarse = errors(16), fine = errors(32);
      check_high_order(coarse.energy, fine.energy);
      check_high_order(coarse.deflection, fine.deflection);
      CHECK(fine.energy <= kFloor);
    }
  }

  // FE.md 1.4 has for soft supports at t = 0.001 on Shishkin meshes of 8, 12, 16, 24 intervals:
  // MITC7 1.9e-2 9.0e-3 5.5e-3 2.9e-3, MITC9 1.5e-2 5.0e-3 2.5e-3 1.1e-3,
  // MITC4 9.8e-2 6.5e-2 4.9e-2 3.2e-2, Arnold-Falk 1.4e-1 ... 4.7e-2.
  TEST_CASE("the energy norm of the error at soft supports falls as measured before") {
    const auto fine_lines = layer_lines(40, 0.5, plate_layer(1e-3));
    const ReferencePlate reference(quarter_plate(SquarePlate::soft, 1e-3), fine_lines, fine_lines);
    const auto error = [&](Cells cells, Index n, PlateElement element) {
      const auto lines = layer_lines(n, 0.5, plate_layer(1e-3));
      return relative_energy_error(
          SolvedPlate(on(cells, lines), quarter_plate(SquarePlate::soft, 1e-3), element),
          reference);
    };
    CHECK(error(Cells::triangles, 8, PlateElement::mitc) <= 1.9e-2);
    CHECK(error(Cells::triangles, 16, PlateElement::mitc) <= 6.5e-3);
    CHECK(error(Cells::triangles, 24, PlateElement::mitc) <= 3.8e-3);
    const double coarse = error(Cells::quads, 8, PlateElement::mitc),
                 fine = error(Cells::quads, 24, PlateElement::mitc);
    CHECK(coarse <= 1.5e-2);
    CHECK(fine <= 1.3e-3);
    CHECK(std::log(coarse / fine) / std::log(3.) >= 1.9);
    for (const auto& [cells, element] : {std::pair(Cells::quads, PlateElement::mitc4),
                                         std::pair(Cells::triangles, PlateElement::arnold_falk)}) {
      const double low = error(cells, 8, element), high = error(cells, 24, element);
      CHECK(std::log(low / high) / std::log(3.) == doctest::Approx(1).epsilon(0.05));
      CHECK(high >= 2e-2);
      CHECK(high <= 5.5e-2);
    }
  }
}

TEST_SUITE("slow") {
  TEST_CASE("mitc converges with order four on mixed meshes and for t = 0.01") {
    for (const SquareReference& exact : kSquareReferences) {
      if (!is_smooth(exact)) continue;
      check_orders(Cells::mixed, exact);
      if (exact.thickness != .01) continue;
      check_orders(Cells::triangles, exact);
      check_orders(Cells::quads, exact);
    }
  }
}
