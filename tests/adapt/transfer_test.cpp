#include "adapt/transfer.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "solver/scalar/scalar_basis.hpp"
#include "tests/solver/disc_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double linear(Point p) { return 2 - p.x + 3 * p.y; }
double quadratic(Point p) { return linear(p) + p.x * p.x - 4 * p.x * p.y + 2 * p.y * p.y; }

ScalarField interpolant(const FeMesh& mesh, int order, double (*u)(Point)) {
  ScalarField field{order, make_dof_map(mesh, scalar_layout(order)), {}, {}};
  for (const Point p : node_points(mesh, order)) field.values.push_back(u(p));
  field.inner.assign(field.values.begin() + field.dofs.count(), field.values.end());
  field.values.resize(field.dofs.count());
  return field;
}

double difference(const ScalarField& a, const ScalarField& b) {
  REQUIRE(a.values.size() == b.values.size());
  REQUIRE(a.inner.size() == b.inner.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
  for (std::size_t i = 0; i < a.inner.size(); ++i)
    largest = std::max(largest, std::abs(a.inner[i] - b.inner[i]));
  return largest;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("linear and quadratic functions are carried exactly to other meshes") {
    const Mesh sources[] = {perturbed_mesh(6, 0.3, 1), perturbed(mixed_square(5, 5), 5, 5, 0.3, 2),
                            perturbed(square_quads(3, 24), 3, 24, 0.3, 3)};
    const Mesh targets[] = {perturbed(mixed_square(7, 4), 7, 4, 0.3, 4),
                            three_quads_of(perturbed_mesh(4, 0.3, 5))};
    for (const Mesh& source : sources)
      for (const Mesh& target : targets)
        for (const int order : {1, 2}) {
          const auto u = order == 1 ? linear : quadratic;
          const FeMesh from = straight_fe_mesh(source), to = straight_fe_mesh(target);
          PointLocation location(from);
          const ScalarField field = carried(location, interpolant(from, order, u), to, order);
          CHECK(difference(field, interpolant(to, order, u)) < 1e-12);
        }
  }

  TEST_CASE("a field is carried to its own mesh without change even where edges are bent") {
    const Mesh mesh = disc_quads(3);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    const auto wave = [](Point p) { return std::sin(5 * p.x) * std::cos(3 * p.y); };
    const ScalarField field = interpolant(fe, 2, wave);
    PointLocation location(fe);
    CHECK(difference(carried(location, field, fe, 2), field) < 1e-11);
  }

  TEST_CASE("values outside the mesh are those of its nearest point") {
    const Mesh mesh = square_mesh(3);
    const FeMesh fe = straight_fe_mesh(mesh);
    PointLocation location(fe);
    const std::vector<Point> points{{0.2, 0.4}, {1.5, 0.25}, {-1, -1}};
    const auto values = values_at(location, interpolant(fe, 1, linear), points);
    CHECK(values[0] == doctest::Approx(linear({0.2, 0.4})));
    CHECK(values[1] == doctest::Approx(linear({1, 0.25})));
    CHECK(values[2] == doctest::Approx(linear({0, 0})));
  }

  TEST_CASE("several components are evaluated side by side") {
    const Mesh mesh = square_quads(3, 3);
    const FeMesh fe = straight_fe_mesh(mesh);
    PointLocation location(fe);
    const std::vector<Point> points{{0.2, 0.4}, {0.7, 0.1}};
    const auto values =
        components_at(location, points, 3, [](const Location& place, std::span<double> v) {
          const Point p = map_at(place.element, place.at).x;
          v[0] = p.x;
          v[1] = p.y;
          v[2] = place.element.region;
        });
    REQUIRE(values.size() == 6);
    CHECK(values[0] == doctest::Approx(0.2));
    CHECK(values[4] == doctest::Approx(0.1));
    CHECK(values[5] == 1);
  }
}
