#include "adapt/reference_errors.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

Domain square_domain() {
  Domain domain;
  const Point corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const char* names[] = {"bottom", "right", "top", "left"};
  for (Index k = 0; k < 4; ++k)
    domain.curves.push_back({names[k], k + 1, make_line(corners[k], corners[(k + 1) % 4])});
  add_region(domain, "square", 1, {0, 1, 2, 3}, {});
  return domain;
}

/// The sine problem, noting the vertices of the meshes it is solved on.
Model noting(std::vector<std::size_t>& sizes, int order) {
  const ExactSolution exact = sine_product(1, 0);
  ScalarOptions options;
  options.order = order;
  return [&sizes, solve = scalar_model(dirichlet_problem(exact, 1, 0), {}, options)](
             const FeMesh& mesh, const Monitor& monitor) {
    sizes.push_back(mesh.mesh.points.size());
    return solve(mesh, monitor);
  };
}

double true_error(const Mesh& mesh, int order) {
  const double energy = std::sqrt(std::numbers::pi * std::numbers::pi / 2);
  return solved_problem(mesh, order, sine_product(1, 0), 1, 0).true_error / energy;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("errors against a finer solution are near the true ones and each mesh is solved once") {
    for (const int order : {1, 2}) {
      CAPTURE(order);
      const std::vector<Mesh> meshes{square_mesh(4), square_mesh(8)};
      std::vector<std::size_t> sizes;
      const auto errors = errors_against_reference(noting(sizes, order), square_domain(), {},
                                                   generate_options(Preset::best))(meshes);
      REQUIRE(sizes.size() == 3);
      CHECK(sizes[0] == 25);
      CHECK(sizes[1] == 81);
      CHECK(static_cast<double>(sizes[2]) ==
            doctest::Approx((order == 1 ? 16 : 8) * 81).epsilon(0.1));
      REQUIRE(errors.size() == 2);
      for (std::size_t i = 0; i < 2; ++i)
        CHECK(errors[i] == doctest::Approx(true_error(meshes[i], order)).epsilon(0.05));
    }
  }

  TEST_CASE("the number of vertices of the reference can be asked for") {
    const std::vector<Mesh> meshes{square_mesh(4)};
    std::vector<std::size_t> sizes;
    AdaptSettings settings;
    settings.use_goal = true;  // the reference is for the energy whatever steers
    const auto errors = errors_against_reference(noting(sizes, 1), square_domain(), settings,
                                                 generate_options(Preset::best), {600})(meshes);
    CHECK(errors.size() == 1);
    CHECK(static_cast<double>(sizes.back()) == doctest::Approx(600).epsilon(0.1));
  }
}
