// Orders of convergence of the scalar elements on manufactured solutions.
#include <cmath>

#include <doctest/doctest.h>

#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

struct Orders {
  double h1 = 0, l2 = 0;
};

/// log2 of the ratio of the errors on two meshes, the second with half the size.
Orders orders(const ErrorNorms& coarse, const ErrorNorms& fine) {
  return {std::log2(coarse.h1 / fine.h1), std::log2(coarse.l2 / fine.l2)};
}

using MakeMesh = Mesh (*)(Index n);
Mesh triangles(Index n) { return square_mesh(n); }
Mesh quads(Index n) { return square_quads(n, n); }
Mesh mixed(Index n) { return mixed_square(n, n); }
Mesh distorted_mixed(Index n) { return perturbed(mixed_square(n, n), n, n, 0.2, 11); }
Mesh seed_type_quads(Index n) { return three_quads_of(perturbed_mesh(n, 0.25, 12)); }

/// u = sin(pi x) sin(pi y).
ErrorNorms sine_error(MakeMesh make, Index n, int order) {
  const ExactSolution exact = sine_product(1, 0);
  return solve_and_compare(make(n), problem_of(exact, 1, 0), exact, order);
}

/// u = (1 - r^2) / 4 on the disc.
ErrorNorms disc_error(const FeMesh& mesh, int order) {
  const ExactSolution exact{[](Point p) { return (1 - squared_norm(p)) / 4; },
                            [](Point p) { return -0.5 * p; },
                            [](Point) { return 1.; },
                            {}};
  ScalarProblem problem{1., 0., 1., {{kRim, 0}}};
  return solve_and_compare(mesh, problem, exact, order);
}

}  // namespace

TEST_SUITE("convergence") {
  TEST_CASE("P1 and P2 and Q1 and Q2 and their mixtures converge with their orders") {
    for (const MakeMesh make : {triangles, quads, mixed})
      for (const int order : {1, 2}) {
        CAPTURE(order);
        ErrorNorms coarse = sine_error(make, 8, order);
        for (const Index n : {16, 32, 64}) {
          const ErrorNorms fine = sine_error(make, n, order);
          CAPTURE(n);
          const auto [h1, l2] = orders(coarse, fine);
          CHECK(std::abs(h1 - order) < 0.1);
          CHECK(std::abs(l2 - (order + 1)) < 0.1);
          coarse = fine;
        }
      }
  }

  TEST_CASE("distorted mixed meshes keep the orders") {
    for (const int order : {1, 2}) {
      const auto [h1, l2] =
          orders(sine_error(distorted_mixed, 16, order), sine_error(distorted_mixed, 64, order));
      CHECK(h1 / 2 == doctest::Approx(order).epsilon(0.1));
      CHECK(l2 / 2 == doctest::Approx(order + 1).epsilon(0.1));
    }
  }

  TEST_CASE("biquadratic elements keep their order on quadrilaterals cut from triangles") {
    ErrorNorms coarse = sine_error(seed_type_quads, 8, 2);
    for (const Index n : {16, 32}) {
      const ErrorNorms fine = sine_error(seed_type_quads, n, 2);
      CHECK(orders(coarse, fine).h1 >= 1.9);
      CHECK(orders(coarse, fine).l2 >= 2.85);
      coarse = fine;
    }
  }

  TEST_CASE("bent edges keep the order of quadratic elements on the disc") {
    const Domain domain = disc_domain();
    for (const bool with_quads : {false, true}) {
      CAPTURE(with_quads);
      const auto mesh = [&](Index n) { return with_quads ? disc_quads(n) : disc_mesh(n); };
      const Mesh coarse = mesh(6), fine = mesh(12);
      const auto bent = orders(disc_error(curved_fe_mesh(coarse, domain), 2),
                               disc_error(curved_fe_mesh(fine, domain), 2));
      CHECK(bent.h1 >= 1.9);
      CHECK(bent.l2 >= 2.8);
      // Polygons: the boundary layer of errors of size h^2 is h wide.
      const auto straight =
          orders(disc_error(straight_fe_mesh(coarse), 2), disc_error(straight_fe_mesh(fine), 2));
      CHECK(straight.h1 <= 1.7);
      CHECK(straight.l2 <= 2.2);
    }
  }

  TEST_CASE("the energy error squared is the energy missing from the solution") {
    // Galerkin orthogonality on a stretched layer mesh; |u|^2 = 0.9603 for eps = 0.01 (FE.md 3.1).
    const ExactSolution exact = product_layer(1e-4, 1);
    const ScalarProblem problem = problem_of(exact, 1e-4, 1);
    for (const int order : {1, 2}) {
      const Mesh mesh = mapped(mixed_square(24, 24), [](Point p) {
        return Point{sinh_grading(p.x, 3), sinh_grading(p.y, 3)};
      });
      const FeMesh fe = straight_fe_mesh(mesh);
      const ScalarSolution solution = solve_scalar(fe, problem, of_order(order));
      const double error = error_norms(fe, problem, exact, solution.field).energy;
      // |e|^2 = |u|^2 - 2 (f, u_h) + |u_h|^2 + ... = |u|^2 - |u_h|^2.
      CHECK(error * error == doctest::Approx(0.9603 - solution.squared_energy).epsilon(0.02));
    }
  }

  TEST_CASE("the resolved layer problem converges with the order in the energy norm") {
    const ExactSolution exact = product_layer(0.04, 1);
    const ScalarProblem problem = problem_of(exact, 0.04, 1);
    for (const int order : {1, 2}) {
      const double coarse =
          solve_and_compare(square_quads(20, 20), problem, exact, order).relative_energy();
      const double fine =
          solve_and_compare(square_quads(40, 40), problem, exact, order).relative_energy();
      CHECK(std::log2(coarse / fine) == doctest::Approx(order).epsilon(0.03));
    }
  }
}
