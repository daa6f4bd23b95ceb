// Reference values of FE.md 3.1 (references.json: hp discretisations, digits shown are converged).
#include <cmath>

#include <doctest/doctest.h>

#include "mesher/mesh/topology.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// (-1, 1)^2 without the quadrant x > 0, y < 0, graded towards the corner: vertex (i, j) of
/// -n .. n at sign(i) |i / n|^power.
Mesh l_shape(Index n, double power, bool with_quads) {
  Mesh mesh;
  const Index w = 2 * n + 1;
  std::vector<Index> number(w * w, kNoIndex);
  const auto coordinate = [&](Index i) {
    return std::copysign(std::pow(std::abs(1. * i / n), power), i);
  };
  const auto vertex = [&](Index i, Index j) {
    Index& v = number[(j + n) * w + i + n];
    if (v == kNoIndex) {
      v = static_cast<Index>(mesh.points.size());
      mesh.points.push_back({coordinate(i), coordinate(j)});
    }
    return v;
  };
  for (Index j = -n; j < n; ++j)
    for (Index i = -n; i < n; ++i) {
      if (i >= 0 && j < 0) continue;
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                  d = vertex(i, j + 1);
      if (with_quads) {
        mesh.quads.push_back({a, b, c, d});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  mesh.quad_regions.assign(mesh.quads.size(), 1);
  for (const auto& [a, b] : boundary_edges(mesh)) mesh.edges.push_back({{a, b}, 1, kNoIndex, {}});
  return mesh;
}

ScalarProblem unit_load(double a, double c) { return with_values(a, c, 1, 0); }

}  // namespace

TEST_SUITE("convergence") {
  TEST_CASE("Poisson on the square has the energy and the centre value of the reference") {
    for (const bool with_quads : {false, true}) {
      const Mesh mesh = with_quads ? square_quads(32, 32) : square_mesh(32);
      const ScalarSolution u = solve_straight(mesh, unit_load(1, 0), 2);
      const double energy = 0.03514425373878842890;
      CHECK(u.squared_energy < energy);
      CHECK(u.squared_energy == doctest::Approx(energy).epsilon(1e-5));
      CHECK(u.field.values[16 * 33 + 16] == doctest::Approx(0.07367135328151381557).epsilon(1e-6));
      // Linear elements: the missing energy falls by four when the size is halved.
      const double coarse =
          energy -
          solve_straight(with_quads ? square_quads(16, 16) : square_mesh(16), unit_load(1, 0), 1)
              .squared_energy;
      const double fine = energy - solve_straight(mesh, unit_load(1, 0), 1).squared_energy;
      CHECK(fine > 0);
      CHECK(coarse / fine == doctest::Approx(4).epsilon(0.03));
    }
  }

  TEST_CASE("Poisson on the L shape has the energy of the reference") {
    for (const bool with_quads : {false, true}) {
      const ScalarProblem problem{1., 0., 1., {{1, 0}}};
      const double energy = solve_straight(l_shape(24, 3, with_quads), problem, 2).squared_energy;
      CHECK(energy < 0.21407580268571);
      CHECK(energy == doctest::Approx(0.21407580268571).epsilon(1e-5));
    }
  }

  TEST_CASE("the corner singularity has the energy of the reference and order two when graded") {
    const ExactSolution exact = corner_singularity(1, 0);
    const ScalarProblem problem{1., 0., 0., {{1, exact.value}}};
    for (const bool with_quads : {false, true}) {
      const Mesh coarse = l_shape(8, 4, with_quads), graded = l_shape(16, 4, with_quads);
      const FeMesh fine = straight_fe_mesh(graded);
      const ScalarSolution u = solve_scalar(fine, problem, of_order(2));
      CHECK(u.squared_energy == doctest::Approx(1.836226661875162634).epsilon(1e-4));
      const ErrorNorms norms = error_norms(fine, problem, exact, u.field);
      CHECK(norms.exact_energy * norms.exact_energy ==
            doctest::Approx(1.836226661875162634).epsilon(1e-4));
      CHECK(std::log2(solve_and_compare(coarse, problem, exact, 2).h1 / norms.h1) > 1.8);
    }
    // A uniform mesh has order 2/3 whatever the element.
    const double rough = solve_and_compare(l_shape(8, 1, true), problem, exact, 2).h1;
    const double less = solve_and_compare(l_shape(16, 1, true), problem, exact, 2).h1;
    CHECK(std::log2(rough / less) == doctest::Approx(2. / 3).epsilon(0.05));
  }

  TEST_CASE("reaction-diffusion energies are those of the reference down to thin layers") {
    const struct {
      double epsilon, energy;
    } references[] = {{1, 0.0335232057097263},
                      {0.1, 0.650945320919283},
                      {1e-2, 0.960509295817894},
                      {1e-3, 0.996005092958179},
                      {1e-4, 0.999600050929582}};
    for (const auto& [epsilon, energy] : references)
      for (const bool with_quads : {false, true}) {
        CAPTURE(epsilon);
        const double width = std::min(0.25, 10 * epsilon);
        const Mesh mesh = mapped(with_quads ? square_quads(48, 48) : square_mesh(48), [&](Point p) {
          return Point{layers_at_both_ends(p.x, width), layers_at_both_ends(p.y, width)};
        });
        const double found =
            solve_straight(mesh, unit_load(epsilon * epsilon, 1), 2).squared_energy;
        // Energies are missed from below; the layers hold 4 epsilon of it.
        CHECK(found < energy);
        CHECK(energy - found < 5e-4 * std::min(1., 4 * epsilon));
      }
  }
}
