#include "solver/norms.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

ErrorNorms norms_of(const Mesh& mesh, double a, double c, const ExactSolution& exact,
                    const std::vector<double>& values) {
  return error_norms(mesh, {a, c, {}, {}}, exact, values);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the energy of the layer by quadrature is the closed form on meshes that miss it") {
    // Values 0: the error is the exact solution itself. Closed forms of FE.md 3.1.
    const auto energies = [](Index n, double a) {
      const Mesh mesh = square_mesh(n);
      const std::vector<double> zero(mesh.points.size(), 0.);
      return norms_of(mesh, a, 1, product_layer(a, 1), zero);
    };
    for (const Index n : {1, 4, 16}) {
      CAPTURE(n);
      CHECK(energies(n, 1e-4).energy == doctest::Approx(std::sqrt(0.9603)).epsilon(1e-5));
    }
    const ErrorNorms thin = energies(4, 1e-6);
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
    const ExactSolution exact{[](Point p) { return p.x * p.x; },
                              [](Point p) {
                                return Vector{2 * p.x, 0};
                              },
                              [](Point) { return 0.; },
                              {}};
    const ErrorNorms norms = norms_of(square_mesh(1), 3, 5, exact, {0, 1, 0, 1});
    CHECK(norms.l2 * norms.l2 == doctest::Approx(1. / 30));
    CHECK(norms.h1 * norms.h1 == doctest::Approx(1. / 3));
    CHECK(norms.energy * norms.energy == doctest::Approx(1 + 1. / 6));
    CHECK(norms.exact_energy * norms.exact_energy == doctest::Approx(4 + 1));
  }

  TEST_CASE("triangles at a singular gradient are subdivided until the rules agree") {
    // u = x^(3/4): int |grad u|^2 = int 9/16 x^(-1/2) = 9/8.
    const ExactSolution exact{[](Point p) { return std::pow(p.x, 0.75); },
                              [](Point p) {
                                return Vector{0.75 * std::pow(p.x, -0.25), 0};
                              },
                              [](Point) { return 0.; },
                              {}};
    const ErrorNorms norms = norms_of(square_mesh(4), 1, 0, exact, std::vector<double>(25, 0.));
    CHECK(norms.h1 == doctest::Approx(std::sqrt(1.125)).epsilon(1e-3));
  }

  TEST_CASE("a linear solution has no error") {
    const ExactSolution exact{[](Point p) { return 1 + 2 * p.x - p.y; },
                              [](Point) {
                                return Vector{2, -1};
                              },
                              [](Point) { return 0.; },
                              {}};
    const Mesh mesh = perturbed_mesh(5, 0.3, 4);
    std::vector<double> values;
    for (const Point& p : mesh.points) values.push_back(exact.value(p));
    CHECK(norms_of(mesh, 1, 1, exact, values).energy < 1e-13);
  }
}
