#include "adapt/recovery.hpp"

#include <cmath>

#include <doctest/doctest.h>
#include <omp.h>

#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

Vector linear(Index, Point p) { return {1 - 2 * p.x + 3 * p.y, 4 * p.x + p.y}; }

Vector quadratic(Index, Point p) {
  return {2 - p.x + 3 * p.x * p.y - p.y * p.y, p.x * p.x + 5 * p.y - p.x * p.y};
}

/// Another polynomial in each region.
Vector piecewise(Index region, Point p) {
  return region == 1 ? quadratic(1, p) : Vector{-7., 1 + p.x * p.x};
}

const auto of_degree(int degree) { return degree == 1 ? linear : quadratic; }

double error_on(const FeMesh& mesh, int order, const Stresses& stresses) {
  return recovery_error(mesh, RecoveredFlux(mesh, samples_of(mesh, order, stresses)), stresses);
}

double error_on(const Mesh& mesh, int order, const Stresses& stresses) {
  return error_on(straight_fe_mesh(mesh), order, stresses);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("polynomials of the fit degree are recovered exactly on all kinds of meshes") {
    for (const int order : {1, 2}) {
      CAPTURE(order);
      const auto stresses = of_degree(order);
      CHECK(error_on(perturbed_mesh(5, 0.3, 2), order, stresses) < 1e-11);
      CHECK(error_on(perturbed(square_quads(5, 4), 5, 4, 0.25, 2), order, stresses) < 1e-11);
      CHECK(error_on(perturbed(mixed_square(5, 4), 5, 4, 0.25, 2), order, stresses) < 1e-11);
      CHECK(error_on(three_quads_of(perturbed_mesh(3, 0.2, 5)), order, stresses) < 1e-11);
    }
  }

  TEST_CASE("stretch of a thousand costs no accuracy") {
    for (const int order : {1, 2}) {
      const auto thin = [](Point p) { return Point{p.x - 3e-4 * p.y, p.x + 1e-3 * p.y}; };
      CHECK(error_on(mapped(perturbed_mesh(5, 0.25, 2), thin), order, of_degree(order)) < 1e-9);
      CHECK(error_on(mapped(square_quads(5, 5), thin), order, of_degree(order)) < 1e-9);
    }
  }

  TEST_CASE("bent elements recover polynomials too") {
    for (const Mesh& mesh : {square_mesh(4), square_quads(4, 4)}) {
      const FeMesh fe = with_bent_bottom(mesh, 0.04);
      CHECK(error_on(fe, 1, linear) < 1e-11);
      CHECK(error_on(fe, 2, quadratic) < 1e-11);
    }
  }

  TEST_CASE("at an interface each region keeps its own polynomial") {
    const Mesh mesh = with_two_regions(perturbed(mixed_square(6, 5), 6, 5, 0.05, 4));
    CHECK(error_on(mesh, 2, piecewise) < 1e-11);
    CHECK(error_on(with_two_regions(square_mesh(4)), 1, [](Index region, Point p) {
            return region == 1 ? linear(1, p) : Vector{-7, p.x};
          }) < 1e-12);
    // Without the regions the jump is smeared out.
    CHECK(error_on(square_mesh(4), 1, [](Index, Point p) {
            return Vector{p.x < 0.5 ? 0. : 1., 0.};
          }) > 0.1);
  }

  TEST_CASE("a curve with a condition divides the recovery like an interface") {
    const Mesh mesh = with_middle_curve(square_mesh(6), 1);
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.fluxes.push_back({kMiddle, 1., 0.});
    // u = |x - 1/2|: the gradient jumps by 2.
    const auto field = interpolant(fe, 1, [](Point p) { return std::abs(p.x - 0.5); });
    CHECK(estimate_by_recovery(fe, problem, field).error < 1e-12);
    CHECK(estimate_by_recovery(fe, {}, field).error > 0.1);
  }

  TEST_CASE("vertex values are those of the polynomials and at interfaces their mean") {
    const Mesh mesh = with_two_regions(square_mesh(4));
    const FeMesh fe = straight_fe_mesh(mesh);
    const RecoveredFlux recovered(fe, samples_of(fe, 2, piecewise));
    REQUIRE(recovered.components() == 2);
    REQUIRE(recovered.vertex_values().size() == 50);
    for (Index v = 0; v < 25; ++v) {
      const Point p = mesh.points[v];
      const Vector left = piecewise(1, p), right = piecewise(2, p);
      const Vector expected = p.x < 0.5 ? left : (p.x > 0.5 ? right : 0.5 * (left + right));
      CHECK(recovered.vertex_values()[2 * v] == doctest::Approx(expected.x));
      CHECK(recovered.vertex_values()[2 * v + 1] == doctest::Approx(expected.y));
    }
  }

  TEST_CASE("meshes of a few elements give what their samples determine") {
    Mesh one;
    one.points = {{0, 0}, {1, 0}, {0, 1}, {9, 9}};
    one.triangles = {{0, 1, 2}};
    const FeMesh fe = straight_fe_mesh(one);
    const RecoveredFlux constant(fe, samples_of(fe, 1, [](Index, Point) { return Vector{3, 4}; }));
    CHECK(constant.vertex_values()[0] == doctest::Approx(3));
    CHECK(constant.vertex_values()[5] == doctest::Approx(4));
    CHECK(constant.vertex_values()[6] == 0);  // no element has this vertex
    CHECK(error_on(square_quads(1, 1), 1, [](Index, Point) { return Vector{3, 4}; }) < 1e-13);
    CHECK(error_on(square_mesh(1), 2, linear) < 1e-11);
    CHECK(error_on(square_mesh(2), 1, linear) < 1e-12);
  }
}

TEST_SUITE("property") {
  TEST_CASE("affine maps of the mesh commute with the recovery") {
    // Values that no polynomial fits.
    const auto wild = [](Point p) { return Vector{std::sin(9 * p.x + p.y), std::cos(7 * p.y)}; };
    const auto affine = [](Point p) { return Point{3 + 0.1 * p.x - 40 * p.y, 0.7 * p.x + p.y}; };
    for (const int order : {1, 2}) {
      const Mesh mesh = perturbed(mixed_square(6, 6), 6, 6, order == 1 ? 0.2 : 0.1, 3);
      const Mesh image = mapped(mesh, affine);
      const FeMesh fe = straight_fe_mesh(mesh), image_fe = straight_fe_mesh(image);
      FluxSamples samples = samples_of(fe, order, [&](Index, Point p) { return wild(p); });
      FluxSamples image_samples =
          samples_of(image_fe, order, [](Index, Point) { return Vector{}; });
      image_samples.values = samples.values;
      const RecoveredFlux a(fe, samples), b(image_fe, image_samples);
      for (std::size_t i = 0; i < a.vertex_values().size(); ++i)
        CHECK(a.vertex_values()[i] == doctest::Approx(b.vertex_values()[i]).epsilon(1e-9));
    }
  }

  TEST_CASE("the recovery and its estimate do not depend on the number of threads") {
    const Mesh mesh = perturbed_mesh(40, 0.2, 6);
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.reaction = 2.;
    const auto field = interpolant(fe, 1, [](Point p) { return std::exp(p.x) * p.y * p.y; });
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const ErrorEstimate one = estimate_by_recovery(fe, problem, field);
    const ErrorEstimate residual_of_one = estimate_by_residual(fe, problem, field);
    omp_set_num_threads(4);
    const ErrorEstimate four = estimate_by_recovery(fe, problem, field);
    const ErrorEstimate residual_of_four = estimate_by_residual(fe, problem, field);
    omp_set_num_threads(threads);
    CHECK(one.error == four.error);
    CHECK(one.energy == four.energy);
    CHECK(one.indicators == four.indicators);
    CHECK(residual_of_one.indicators == residual_of_four.indicators);
  }
}
