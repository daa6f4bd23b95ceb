// Row 2 of FE.md 6: the corner singularity of the L shape. Uniform meshes reach a slope of -1/3.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/adapt/acceptance/adapted.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

constexpr Index kSides = 1;

Domain l_shape() {
  const Point corners[] = {{0, 0}, {0, -1}, {-1, -1}, {-1, 1}, {1, 1}, {1, 0}};
  Domain domain;
  for (std::size_t k = 0; k < 6; ++k) {
    const std::string name = "side " + std::to_string(k + 1);
    // Clockwise from the corner: the domain lies to the right.
    domain.curves.push_back({name, kSides, make_line(corners[(k + 1) % 6], corners[k])});
  }
  add_region(domain, "plate", 1, {5, 4, 3, 2, 1, 0}, {});
  return domain;
}

Model corner_model(int order) {
  const ExactSolution exact = corner_singularity(1, 0);
  ScalarProblem problem{1., 0., exact.source};
  problem.dirichlet.push_back({kSides, exact.value});
  ScalarOptions options;
  options.order = order;
  return scalar_model(std::move(problem), exact, options);
}

/// A grid with squares of 1/8 on the L shape.
Mesh initial_mesh() {
  const Domain domain = l_shape();
  Mesh box;
  box.points = {{-1.1, -1.1}, {1.1, -1.1}, {1.1, 1.1}, {-1.1, 1.1}};
  box.triangles = {{0, 1, 2}, {0, 2, 3}};
  box.triangle_regions = {1, 1};
  return generate(domain, box, MetricField(4, metric_from_size(0.125)),
                  generate_options(Preset::best))
      .mesh;
}

struct Row {
  double dofs, error;
};

/// The last meshes of five cycles with more and more vertices.
std::vector<Row> final_rows(int order, std::initializer_list<double> targets) {
  std::vector<Row> rows;
  for (const double vertices : targets) {
    const LoopInput input =
        five_cycles(corner_model(order), l_shape(), initial_mesh(), settings_with(vertices));
    const CycleRecord last = adapt_loop(input).cycles.back();
    rows.push_back({static_cast<double>(last.dofs), *last.error.relative_energy});
  }
  return rows;
}

double slope(const Row& a, const Row& b) {
  return std::log(b.error / a.error) / std::log(b.dofs / a.dofs);
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("linear elements adapt to the corner of the L shape at the best rate") {
    const auto rows = final_rows(1, {400, 1600, 10000});
    for (const Row& r : rows) MESSAGE("P1 dofs " << r.dofs << " error " << r.error);
    for (std::size_t k = 1; k < rows.size(); ++k) CHECK(slope(rows[k - 1], rows[k]) <= -0.47);
    CHECK(rows.back().dofs <= 25000);
    CHECK(rows.back().error <= 6.4e-3);  // FreeFem++: 6.17e-3 with 24902
  }

  TEST_CASE("quadratic elements adapt to the corner of the L shape at the best rate") {
    const auto rows = final_rows(2, {200, 800, 3200});
    for (const Row& r : rows) MESSAGE("P2 dofs " << r.dofs << " error " << r.error);
    for (std::size_t k = 1; k < rows.size(); ++k) CHECK(slope(rows[k - 1], rows[k]) <= -0.8);
    CHECK(rows.back().error <= 5.87e-4);  // FreeFem++ with 39183 dofs
  }
}
