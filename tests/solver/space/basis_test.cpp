#include "solver/space/basis.hpp"

#include <doctest/doctest.h>

#include "solver/space/reference_quadrature.hpp"

using namespace anisofront;

namespace {

const std::vector<ReferencePoint> kTriangleNodes{{0, 0},  {1, 0},   {0, 1},
                                                 {.5, 0}, {.5, .5}, {0, .5}};
const std::vector<ReferencePoint> kSquareNodes{{-1, -1}, {1, -1}, {1, 1},  {-1, 1}, {0, -1},
                                               {1, 0},   {0, 1},  {-1, 0}, {0, 0}};
constexpr ReferencePoint kInside{0.2, 0.37};

/// 1 at its own node, 0 at the others.
template <int N>
void check_lagrange(Basis<N> (*basis)(ReferencePoint), const std::vector<ReferencePoint>& nodes) {
  for (int n = 0; n < N; ++n) {
    const Basis<N> b = basis(nodes[n]);
    for (int k = 0; k < N; ++k) CHECK(b.value[k] == doctest::Approx(k == n ? 1 : 0));
  }
}

/// Gradients against central differences of the values.
template <int N>
void check_gradients(Basis<N> (*basis)(ReferencePoint)) {
  const double h = 1e-6;
  const Basis<N> b = basis(kInside);
  const Basis<N> right = basis({kInside.xi + h, kInside.eta}),
                 left = basis({kInside.xi - h, kInside.eta});
  const Basis<N> up = basis({kInside.xi, kInside.eta + h}),
                 down = basis({kInside.xi, kInside.eta - h});
  for (int k = 0; k < N; ++k) {
    CHECK(b.gradient[k].x ==
          doctest::Approx((right.value[k] - left.value[k]) / (2 * h)).epsilon(1e-8));
    CHECK(b.gradient[k].y ==
          doctest::Approx((up.value[k] - down.value[k]) / (2 * h)).epsilon(1e-8));
  }
}

/// sum of f(node) N(x) for the functions that the space must hold.
template <int N>
double interpolated(Basis<N> (*basis)(ReferencePoint), const std::vector<ReferencePoint>& nodes,
                    double (*f)(ReferencePoint)) {
  const Basis<N> b = basis(kInside);
  double sum = 0;
  for (int k = 0; k < N; ++k) sum += f(nodes[k]) * b.value[k];
  return sum;
}

double full_quadratic(ReferencePoint p) {
  return 2 - p.xi + 3 * p.eta + 4 * p.xi * p.eta - 5 * p.xi * p.xi + 6 * p.eta * p.eta;
}
double cubic_terms(ReferencePoint p) { return p.xi * p.xi * p.eta - 2 * p.xi * p.eta * p.eta; }
double biquadratic_term(ReferencePoint p) { return p.xi * p.xi * p.eta * p.eta; }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("Lagrange functions are one at their own node and zero at the others") {
    check_lagrange(linear_triangle, kTriangleNodes);
    check_lagrange(quadratic_triangle, kTriangleNodes);
    check_lagrange(bilinear_quad, kSquareNodes);
    check_lagrange(serendipity_quad, kSquareNodes);
    check_lagrange(biquadratic_quad, kSquareNodes);
  }

  TEST_CASE("gradients are the derivatives of the values") {
    check_gradients(linear_triangle);
    check_gradients(quadratic_triangle);
    check_gradients(bilinear_quad);
    check_gradients(serendipity_quad);
    check_gradients(biquadratic_quad);
    check_gradients(crouzeix_raviart);
    check_gradients(triangle_bubble);
  }

  TEST_CASE("second-order spaces hold the polynomials they must hold") {
    const double q = full_quadratic(kInside);
    CHECK(interpolated(quadratic_triangle, kTriangleNodes, full_quadratic) == doctest::Approx(q));
    CHECK(interpolated(serendipity_quad, kSquareNodes, full_quadratic) == doctest::Approx(q));
    CHECK(interpolated(biquadratic_quad, kSquareNodes, full_quadratic) == doctest::Approx(q));
    const double c = cubic_terms(kInside);
    CHECK(interpolated(serendipity_quad, kSquareNodes, cubic_terms) == doctest::Approx(c));
    CHECK(interpolated(biquadratic_quad, kSquareNodes, biquadratic_term) ==
          doctest::Approx(biquadratic_term(kInside)));
  }

  TEST_CASE("Crouzeix-Raviart functions are one at the middle of their edge") {
    for (int n = 0; n < 3; ++n) {
      const Basis<3> b = crouzeix_raviart(kTriangleNodes[3 + n]);
      for (int k = 0; k < 3; ++k) CHECK(b.value[k] == doctest::Approx(k == n ? 1 : 0));
    }
  }

  TEST_CASE("the bubble is one at the centre and vanishes on the edges") {
    CHECK(triangle_bubble({1. / 3, 1. / 3}).value[0] == doctest::Approx(1));
    for (const ReferencePoint p : {ReferencePoint{.3, 0}, {0, .8}, {.4, .6}})
      CHECK(triangle_bubble(p).value[0] == doctest::Approx(0));
  }

  TEST_CASE("traces are the restrictions of the quadratic functions to an edge") {
    const Basis<6> b = quadratic_triangle({0.3, 0});  // on edge 0 from corner 0 to corner 1
    const auto trace = quadratic_trace(0.3);
    CHECK(trace[0] == doctest::Approx(b.value[0]));
    CHECK(trace[1] == doctest::Approx(b.value[1]));
    CHECK(trace[2] == doctest::Approx(b.value[3]));
    CHECK(linear_trace(0.3)[1] == doctest::Approx(0.3));
  }
}
