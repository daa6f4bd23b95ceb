#include "solver/scalar/scalar_basis.hpp"

#include <stdexcept>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

constexpr Shape kShapes[] = {Shape::triangle, Shape::quadrilateral};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("second derivatives of the basis agree with differences of its gradients") {
    const double h = 1e-5;
    for (const Shape shape : kShapes)
      for (const int order : {1, 2}) {
        const ReferencePoint at{0.23, 0.31};
        const auto hessians = scalar_basis_hessians(shape, order, at);
        const auto right = scalar_basis(shape, order, {at.xi + h, at.eta});
        const auto left = scalar_basis(shape, order, {at.xi - h, at.eta});
        const auto up = scalar_basis(shape, order, {at.xi, at.eta + h});
        const auto down = scalar_basis(shape, order, {at.xi, at.eta - h});
        for (int i = 0; i < right.count; ++i) {
          const Vector d_xi = (0.5 / h) * (right.gradient[i] - left.gradient[i]);
          const Vector d_eta = (0.5 / h) * (up.gradient[i] - down.gradient[i]);
          CHECK(hessians[i].xi_xi == doctest::Approx(d_xi.x).scale(1).epsilon(1e-8));
          CHECK(hessians[i].xi_eta == doctest::Approx(d_xi.y).scale(1).epsilon(1e-8));
          CHECK(hessians[i].eta_eta == doctest::Approx(d_eta.y).scale(1).epsilon(1e-8));
        }
      }
  }

  TEST_CASE("rules sum to the reference area and hold the basis at their points") {
    for (const Shape shape : kShapes)
      for (const int order : {1, 2})
        for (const int degree : {0, 4, 12}) {
          double area = 0;
          for (const ScalarBasisPoint& point : scalar_rule(shape, order, degree)) {
            area += point.weight;
            double sum = 0;
            for (int i = 0; i < point.basis.count; ++i) sum += point.basis.value[i];
            CHECK(sum == doctest::Approx(1));
          }
          CHECK(area == doctest::Approx(shape == Shape::triangle ? 0.5 : 4));
        }
  }

  TEST_CASE("orders other than one and two are refused") {
    CHECK(scalar_layout(2).in_quad == 1);
    CHECK(scalar_layout(1).per_edge == 0);
    CHECK_THROWS_AS(scalar_layout(3), std::out_of_range);
    CHECK_THROWS_AS(scalar_layout(0), std::out_of_range);
  }
}
