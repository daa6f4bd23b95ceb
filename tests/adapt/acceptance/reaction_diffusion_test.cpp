// Rows 3, 4, 12 and 18 of FE.md 6: layers of width eps along all sides of the unit square.
#include <cmath>

#include <doctest/doctest.h>

#include "adapt/reference.hpp"
#include "tests/adapt/acceptance/adapted.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;
using namespace anisofront::test;

namespace {

Model layer_model(double epsilon, int order) {
  const ExactSolution exact = product_layer(epsilon * epsilon, 1);
  ScalarProblem problem{epsilon * epsilon, 1., exact.source};
  for (const Index side : {kBottom, kRight, kTop, kLeft}) problem.dirichlet.push_back({side, 0.});
  ScalarOptions options;
  options.order = order;
  return scalar_model(std::move(problem), exact, options);
}

struct Case {
  double epsilon;
  int order;
  double vertices;
  AdaptMode mode = AdaptMode::anisotropic;
  Elements elements = Elements::triangle;
};

VariantHistory adapted(const Case& c) {
  AdaptSettings settings = settings_with(c.vertices);
  settings.density.mode = c.mode;
  settings.elements = c.elements;
  LoopInput input =
      five_cycles(layer_model(c.epsilon, c.order), square_domain(1), square_mesh(16), settings);
  input.generate.quads.effort = QuadEffort::fast;
  return adapt_loop(input);
}

double true_error(const CycleRecord& record) { return *record.error.relative_energy; }

/// The last mesh has at most `vertices` and an error of at most `error`; the estimate is right from
/// cycle 3 on, and the mesh obeys its metric.
void check_row(const Case& c, Index vertices, double error, double largest_effectivity = 1.1) {
  CAPTURE(c.epsilon);
  CAPTURE(c.order);
  const VariantHistory history = adapted(c);
  REQUIRE(history.cycles.size() == 6);
  const CycleRecord& last = history.cycles.back();
  MESSAGE("order " << c.order << " eps " << c.epsilon << ": " << last.background.vertices
                   << " vertices, error " << true_error(last) << ", "
                   << last.background.percent_unit << " % of the edges in the unit band");
  CHECK(last.background.vertices <= vertices);
  CHECK(true_error(last) <= error);
  for (int k = 3; k <= 5; ++k) {
    CHECK(*history.cycles[k].error.effectivity >= 0.9);
    CHECK(*history.cycles[k].error.effectivity <= largest_effectivity);
  }
  if (c.elements == Elements::triangle) CHECK(last.background.percent_unit >= 99);
}

/// Vertices of anisotropic meshes over those of isotropic ones with the same true error, that of
/// the worse of both last meshes. `aniso`, `iso`: numbers of vertices aimed at.
double vertex_ratio(double epsilon, std::initializer_list<double> aniso,
                    std::initializer_list<double> iso) {
  const auto curve = [&](AdaptMode mode, std::initializer_list<double> targets) {
    std::array<std::vector<double>, 2> points;
    for (const double vertices : targets) {
      const CycleRecord last = adapted({epsilon, 1, vertices, mode}).cycles.back();
      points[0].push_back(static_cast<double>(last.background.vertices));
      points[1].push_back(true_error(last));
    }
    return points;
  };
  const auto a = curve(AdaptMode::anisotropic, aniso), b = curve(AdaptMode::isotropic, iso);
  const double level = std::max(a[1].back(), b[1].back());
  const auto at_level = [&](const auto& points) {
    return level == points[1].back() ? points[0].back()
                                     : at_equal_error(points[0], points[1], level).value();
  };
  MESSAGE("eps " << epsilon << " at error " << level << ": anisotropic " << at_level(a)
                 << ", isotropic " << at_level(b) << " vertices");
  return at_level(a) / at_level(b);
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("linear elements find layers with fewer vertices than FreeFem++") {
    check_row({1e-2, 1, 1400}, 1600, 6.5e-3);  // FreeFem++: 1460 vertices, 6.21e-3
    check_row({1e-3, 1, 6800}, 7500, 2.0e-3);  // 7035, 1.89e-3
  }

  TEST_CASE("quadratic elements find layers with fewer vertices than FreeFem++") {
    check_row({1e-2, 2, 1000}, 1100, 4.1e-4);  // FreeFem++: 1092 vertices, 4.07e-4
    check_row({1e-3, 2, 4400}, 4700, 7.3e-5);  // 4645, 7.22e-5
  }

  TEST_CASE("quadrilaterals find layers too") {
    check_row({1e-2, 1, 1400, AdaptMode::anisotropic, Elements::quadrilateral}, 1600, 6.5e-3);
    check_row({1e-2, 2, 1000, AdaptMode::anisotropic, Elements::quadrilateral}, 1100, 4.1e-4, 1.25);
  }

  TEST_CASE("anisotropic meshes need 5 percent of the isotropic vertices for layers of 0.01") {
    CHECK(vertex_ratio(1e-2, {200, 400}, {4000, 8000}) <= 0.05);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("anisotropic meshes need 2.5 percent of the isotropic vertices for layers of 0.001") {
    CHECK(vertex_ratio(1e-3, {500, 1000, 2000, 4000}, {100000, 300000}) <= 0.025);
  }
}
