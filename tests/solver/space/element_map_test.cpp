#include "solver/space/element_map.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr ReferencePoint kInside{0.23, 0.41};

Element skewed_quad() {
  static const Mesh mesh = [] {
    Mesh m;
    m.points = {{0, 0}, {3, 0.2}, {2.5, 1.7}, {-0.4, 1.1}};
    m.quads = {{0, 1, 2, 3}};
    return m;
  }();
  return element_at(straight_fe_mesh(mesh), 0);
}

Element bent_triangle() {
  static const Mesh mesh = disc_mesh(2);
  const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
  for (Index e = 0; e < fe.element_count(); ++e)
    if (const Element element = element_at(fe, e); element.bent) return element;
  return {};
}

void check_derivatives(const Element& element) {
  const double h = 1e-6;
  const MapPoint map = map_at(element, kInside);
  const auto x = [&](double s, double t) {
    return map_at(element, {kInside.xi + s, kInside.eta + t}).x;
  };
  CHECK(norm(map.d_xi - (1 / (2 * h)) * (x(h, 0) - x(-h, 0))) < 1e-8);
  CHECK(norm(map.d_eta - (1 / (2 * h)) * (x(0, h) - x(0, -h))) < 1e-8);
}

void check_inverse(const Element& element) {
  const auto at = inverse_map(element, map_at(element, kInside).x);
  REQUIRE(at);
  CHECK(at->xi == doctest::Approx(kInside.xi).epsilon(1e-12));
  CHECK(at->eta == doctest::Approx(kInside.eta).epsilon(1e-12));
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("determinants that are not positive beyond rounding are refused") {
    Element element;
    element.number = 6;
    CHECK(positive_determinant({{}, {2, 1}, {1, 3}}, element) == 5);
    CHECK(positive_determinant({{}, {1, 1}, {1, 1 + 1e-12}}, element) > 0);
    for (const MapPoint& map : {MapPoint{{4, 0.5}, {1, 3}, {2, 1}},
                                {{4, 0.5}, {1, 3}, {1, 3}},
                                {{4, 0.5}, {0.1, 0.3}, {0.2, std::nextafter(0.6, 1)}},
                                {{4, 0.5}, {0, 0}, {0, 0}},
                                {{4, 0.5}, {1, 0}, {0, std::nan("")}}})
      CHECK_THROWS_WITH_AS(positive_determinant(map, element),
                           "element 7 is turned inside out or flat at (4, 0.5); expected convex "
                           "elements with anticlockwise corners",
                           InputError);
  }

  TEST_CASE("derivatives of the map are those of its points") {
    check_derivatives(skewed_quad());
    check_derivatives(bent_triangle());
  }

  TEST_CASE("the inverse map returns to the reference point") {
    check_inverse(skewed_quad());
    check_inverse(bent_triangle());
  }

  TEST_CASE("physical gradients and covariant components undo each other") {
    const MapPoint map = map_at(skewed_quad(), kInside);
    const Vector v{0.7, -1.3};
    CHECK(norm(map.gradient(map.covariant(v)) - v) < 1e-14);
  }

  TEST_CASE("the gradient of a linear function is its coefficients") {
    // f = 2 x - 5 y has the reference gradient (f_xi, f_eta) = J (2, -5).
    const MapPoint map = map_at(bent_triangle(), kInside);
    const Vector g{dot(map.d_xi, {2, -5}), dot(map.d_eta, {2, -5})};
    CHECK(norm(map.gradient(g) - Vector{2, -5}) < 1e-13);
  }

  TEST_CASE("reference points outside are moved to the element") {
    const ReferencePoint square = clamped(Shape::quadrilateral, {1.2, -3});
    CHECK(square.xi == 1);
    CHECK(square.eta == -1);
    const ReferencePoint beyond = clamped(Shape::triangle, {0.8, 0.6});
    CHECK(beyond.xi == doctest::Approx(0.6));
    CHECK(beyond.eta == doctest::Approx(0.4));
    CHECK(clamped(Shape::triangle, {-0.1, 0.5}).xi == 0);
    CHECK(clamped(Shape::triangle, {3, -1}).xi == 1);
  }

  TEST_CASE("points of a curve edge run along the curve") {
    const Mesh mesh = disc_mesh(3);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    const CurvePoint middle = curve_point(fe, 0, 0.5);
    CHECK(norm(middle.x) == doctest::Approx(1).epsilon(1e-12));
    CHECK(dot(middle.x, middle.tangent) == doctest::Approx(0));
    // The parabola through three points of the circle.
    CHECK(norm(curve_point(fe, 0, 0.2).x) == doctest::Approx(1).epsilon(1e-3));
    CHECK(curve_point(fe, 0, 0).x == mesh.points[mesh.edges[0].vertices[0]]);
  }
}
