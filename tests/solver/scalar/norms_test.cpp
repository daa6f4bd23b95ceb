#include "solver/scalar/norms.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

ErrorNorms norms_of(const Mesh& mesh, double a, double c, const ExactSolution& exact,
                    const std::vector<double>& values) {
  const FeMesh fe = straight_fe_mesh(mesh);
  return error_norms(fe, {a, c, 0.}, exact, linear_field(fe, values));
}

/// The function 0 of order 2.
ScalarField zero_field(const FeMesh& mesh) {
  const DofMap dofs = make_dof_map(mesh, scalar_layout(2));
  return {2, dofs, std::vector<double>(dofs.count(), 0.),
          std::vector<double>(mesh.mesh.quads.size(), 0.)};
}

ExactSolution solution(ScalarFunction value, VectorFunction gradient) {
  return {std::move(value), std::move(gradient), [](Point) { return 0.; }, {}};
}

const ExactSolution kParabola = solution([](Point p) { return p.x * p.x; },
                                         [](Point p) {
                                           return Vector{2 * p.x, 0};
                                         });

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the energy of the layer by quadrature is the closed form on meshes that miss it") {
    // Values 0: the error is the exact solution itself. Closed forms of FE.md 3.1.
    const auto energies = [](const Mesh& mesh, double a) {
      const FeMesh fe = straight_fe_mesh(mesh);
      return error_norms(fe, {a, 1., 0.}, product_layer(a, 1), zero_field(fe));
    };
    for (const Index n : {1, 4, 16})
      for (const Mesh& mesh : {square_mesh(n), square_quads(n, n), mixed_square(n, n)}) {
        CAPTURE(n);
        CHECK(energies(mesh, 1e-4).energy == doctest::Approx(std::sqrt(0.9603)).epsilon(1e-5));
      }
    const ErrorNorms thin = energies(square_mesh(4), 1e-6);
    CHECK(thin.energy == doctest::Approx(std::sqrt(0.996003)).epsilon(1e-5));
    CHECK(thin.exact_energy == doctest::Approx(thin.energy).epsilon(1e-12));
  }

  TEST_CASE("norms of the sine solution are pi / sqrt 2 and one half") {
    const Mesh mesh = perturbed_mesh(6, 0.2, 3);
    const std::vector<double> zero(mesh.points.size(), 0.);
    const ErrorNorms norms = norms_of(mesh, 1, 0, sine_product(1, 0), zero);
    CHECK(norms.h1 == doctest::Approx(2.221441469079183).epsilon(1e-6));
    CHECK(norms.l2 == doctest::Approx(0.5).epsilon(1e-6));
    CHECK(norms.relative_energy() == doctest::Approx(1));
  }

  TEST_CASE("the error of a linear function against a quadratic one is the exact integral") {
    // u = x^2, u_h = x on the square with vertices at its corners only: e = x^2 - x.
    for (const Mesh& mesh : {square_mesh(1), square_quads(1, 1)}) {
      const ErrorNorms norms = norms_of(mesh, 3, 5, kParabola, {0, 1, 0, 1});
      CHECK(norms.l2 * norms.l2 == doctest::Approx(1. / 30));
      CHECK(norms.h1 * norms.h1 == doctest::Approx(1. / 3));
      CHECK(norms.energy * norms.energy == doctest::Approx(1 + 1. / 6));
      CHECK(norms.exact_energy * norms.exact_energy == doctest::Approx(4 + 1));
    }
  }

  TEST_CASE("the energy norm takes coefficients that depend on region and place") {
    // u = x^2: int a 4 x^2 with a = 1 + y in region 1 (x < 1/2), 10 in region 2; int c x^4, c = x.
    Mesh mesh = square_quads(2, 1);
    mesh.quad_regions = {1, 2};
    ScalarProblem problem{[](Point p) { return 1 + p.y; }, [](Point p) { return p.x; }, 0.};
    problem.diffusion.set(2, 10.);
    const FeMesh fe = straight_fe_mesh(mesh);
    const ErrorNorms norms = error_norms(fe, problem, kParabola, zero_field(fe));
    const double a = 4. / 3 * (1.5 / 8 + 10 * 7. / 8), c = 1. / 6;
    CHECK(norms.exact_energy * norms.exact_energy == doctest::Approx(a + c));
    CHECK(norms.energy == doctest::Approx(norms.exact_energy));
  }

  TEST_CASE("elements at a singular gradient are subdivided until the rules agree") {
    // u = x^(3/4): int |grad u|^2 = int 9/16 x^(-1/2) = 9/8.
    const ExactSolution exact = solution([](Point p) { return std::pow(p.x, 0.75); },
                                         [](Point p) {
                                           return Vector{0.75 * std::pow(p.x, -0.25), 0};
                                         });
    for (const Mesh& mesh : {square_mesh(4), square_quads(4, 4)}) {
      const ErrorNorms norms = norms_of(mesh, 1, 0, exact, std::vector<double>(25, 0.));
      CHECK(norms.h1 == doctest::Approx(std::sqrt(1.125)).epsilon(1e-3));
    }
  }

  TEST_CASE("a linear solution has no error") {
    const ExactSolution exact = solution([](Point p) { return 1 + 2 * p.x - p.y; },
                                         [](Point) {
                                           return Vector{2, -1};
                                         });
    const Mesh mesh = perturbed(mixed_square(5, 5), 5, 5, 0.3, 4);
    std::vector<double> values;
    for (const Point& p : mesh.points) values.push_back(exact.value(p));
    CHECK(norms_of(mesh, 1, 1, exact, values).energy < 1e-13);
  }

  TEST_CASE("bent elements are integrated to their bent edges") {
    // Of u = 1 on the disc: sqrt(int u^2) is the root of the area, pi - O(h^4) with bent edges.
    const ExactSolution one = solution([](Point) { return 1.; }, [](Point) { return Vector{}; });
    const Domain domain = disc_domain();
    for (const Mesh& mesh : {disc_mesh(4), disc_quads(3)}) {
      const FeMesh bent = curved_fe_mesh(mesh, domain), straight = straight_fe_mesh(mesh);
      const double l2 = error_norms(bent, {}, one, zero_field(bent)).l2;
      CHECK(l2 * l2 == doctest::Approx(std::numbers::pi).epsilon(1e-4));
      const double polygon = error_norms(straight, {}, one, zero_field(straight)).l2;
      CHECK(polygon * polygon < 0.995 * std::numbers::pi);
    }
  }

  TEST_CASE("values that are not finite are refused with the place before anything is divided") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Mesh mesh = square_quads(40, 40);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto check_refused = [&fe](const ScalarProblem& problem, const ExactSolution& exact,
                                     const ScalarField& field, const char* part) {
      CHECK_THROWS_WITH_AS(error_norms(fe, problem, exact, field), doctest::Contains(part),
                           InputError);
    };
    const ScalarField zero = zero_field(fe);
    ScalarField outer = zero, inner = zero, all = zero;
    outer.values[20] = nan;
    inner.inner[40] = std::numeric_limits<double>::infinity();
    all.values.assign(all.values.size(), nan);
    check_refused({}, kParabola, outer, "the field is not finite at (0.4");
    check_refused({}, kParabola, inner, "the field is not finite at (0.0");
    check_refused({}, kParabola, all, "the field is not finite at (0.0");
    const ExactSolution no_value =
        solution([nan](Point p) { return p.y > 0.9 ? nan : p.y; }, [](Point) { return Vector{}; });
    check_refused({}, no_value, zero, "the exact solution or a coefficient is not finite at (0.0");
    const ExactSolution no_gradient = solution([](Point p) { return p.y; },
                                               [nan](Point p) {
                                                 return Vector{p.y < 0.5 ? 0 : nan, 1};
                                               });
    check_refused({}, no_gradient, zero, "the exact solution or a coefficient is not finite at (");
    check_refused({nan, 0., 0.}, kParabola, zero, "or a coefficient is not finite at (");
  }

  TEST_CASE("a value that is infinite in a vertex does no harm") {
    const ExactSolution exact = solution(
        [](Point p) { return p.x + p.y == 0 ? std::numeric_limits<double>::infinity() : p.x; },
        [](Point) {
          return Vector{1, 0};
        });
    const ErrorNorms norms = norms_of(square_mesh(2), 1, 0, exact, std::vector<double>(9, 0.));
    CHECK(norms.l2 * norms.l2 == doctest::Approx(1. / 3));
  }

  TEST_CASE("the norms do not depend on the number of threads and errors of functions come out") {
    const Mesh mesh = square_mesh(40);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto norms = [&](const ExactSolution& exact, int threads) {
      return error_norms(fe, {1., 1., 0.}, exact, zero_field(fe), threads);
    };
    CHECK(norms(kParabola, 1).energy == norms(kParabola, 3).energy);
    const ExactSolution failing = solution(
        [](Point p) -> double { return p.x > 0.9 ? throw 7 : 0; }, [](Point) { return Vector{}; });
    CHECK_THROWS_AS(norms(failing, 2), int);
  }
}
