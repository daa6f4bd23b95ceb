#include "solver/scalar/scalar_field.hpp"

#include <doctest/doctest.h>

#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

TEST_SUITE("unit") {
  TEST_CASE("a linear field has its values and gradient everywhere") {
    const Mesh mesh = perturbed(mixed_square(4, 4), 4, 4, 0.25, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    std::vector<double> values;
    for (const Point p : mesh.points) values.push_back(2 * p.x - 3 * p.y);
    const ScalarField field = linear_field(fe, values);
    for (Index e = 0; e < fe.element_count(); ++e) {
      const Element element = element_at(fe, e);
      const ReferencePoint at{0.2, 0.3};
      const ScalarState state = scalar_state(fe, field, element, at);
      const Point p = map_at(element, at).x;
      CHECK(state.value == doctest::Approx(2 * p.x - 3 * p.y));
      CHECK(state.gradient.x == doctest::Approx(2));
      CHECK(state.gradient.y == doctest::Approx(-3));
    }
  }

  TEST_CASE("gradients of a field on bent elements agree with differences of its values") {
    const Mesh mesh = disc_quads(2);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    const ScalarField u =
        solve_scalar(fe, {1., 0., [](Point p) { return 1 + p.x; }, {{kRim, 0}}}, of_order(2)).field;
    for (Index e = 0; e < fe.element_count(); ++e) {
      const ScalarOnElement on = on_element(fe, u, element_at(fe, e));
      const ReferencePoint at{0.3, -0.4};
      const double h = 1e-5;
      const MapPoint map = map_at(on.element, at);
      const double d_xi = (on.at({at.xi + h, at.eta}).value - on.at({at.xi - h, at.eta}).value);
      const double d_eta = (on.at({at.xi, at.eta + h}).value - on.at({at.xi, at.eta - h}).value);
      const Vector gradient = on.at(at).gradient;
      CHECK(dot(gradient, map.d_xi) == doctest::Approx(d_xi / (2 * h)).epsilon(1e-6).scale(0.1));
      CHECK(dot(gradient, map.d_eta) == doctest::Approx(d_eta / (2 * h)).epsilon(1e-6).scale(0.1));
    }
  }
}
