#include "solver/scalar/supg.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// X(x) of FE.md 3.1 (b): -eps X'' + X' = 1, X(0) = X(1) = 0.
double outflow(double x, double eps) {
  return x - (std::exp((x - 1) / eps) - std::exp(-1 / eps)) / (1 - std::exp(-1 / eps));
}

/// u = 1 + x - 2 y + x^2 + 3 x y - 2 y^2 and its data for a = 1/50, b = (3, -2).
double quadratic(Point p) { return 1 + p.x - 2 * p.y + p.x * p.x + 3 * p.x * p.y - 2 * p.y * p.y; }
double quadratic_source(Point p) {
  const Vector gradient{1 + 2 * p.x + 3 * p.y, -2 + 3 * p.x - 4 * p.y};
  return 3 * gradient.x - 2 * gradient.y - (2 - 4) * 0.02;
}

ScalarProblem with_velocity(ScalarProblem problem, Vector b) {
  problem.velocity_x = b.x;
  problem.velocity_y = b.y;
  return problem;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the length along the flow is the width of the element in that direction") {
    // Triangle with legs 0.5 and 2.
    std::array<Vector, 9> gradients{{{-2, -0.5}, {2, 0}, {0, 0.5}}};
    CHECK(flow_length({3, 0}, 3, gradients) == doctest::Approx(0.5));
    CHECK(flow_length({0, -3}, 3, gradients) == doctest::Approx(2));
    CHECK(flow_length({0, 0}, 3, gradients) == 0);
  }

  TEST_CASE("the stabilising time has its limits") {
    // Pe = 5: 0.1 / 2 / 2 (coth 5 - 1/5); Pe < 1: none.
    CHECK(supg_time({0, 2}, 0.02, 0.1) == doctest::Approx(0.025 * (1.0000908 - 0.2)));
    CHECK(supg_time({1, 0}, 1, 1.99) == 0);
    CHECK(supg_time({1, 0}, 1e-12, 0.1) == doctest::Approx(0.05));
    CHECK(supg_time({0, 0}, 1, 1) == 0);
  }

  TEST_CASE("Laplacians of the basis are those of polynomials on bent and distorted elements") {
    // sum_i p(x_i) Lap N_i = Lap p where p lies in the space: x^2 + 3 x y - 2 y^2, Lap p = -2.
    const Mesh mesh = perturbed(mixed_square(3, 3), 3, 3, 0.3, 4);
    FeMesh fe = straight_fe_mesh(mesh);
    for (Index e = 0; e < fe.element_count(); ++e) {
      const Element element = element_at(fe, e);
      const ReferencePoint at{0.2, 0.3};
      const ScalarBasis basis = scalar_basis(element.shape, 2, at);
      const MapPoint map = map_at(element, at);
      std::array<Vector, 9> gradients{};
      for (int i = 0; i < basis.count; ++i) gradients[i] = map.gradient(basis.gradient[i]);
      const auto laplacians = basis_laplacians(element, 2, at, gradients);
      double sum = 0;
      for (int i = 0; i < basis.count; ++i) sum += quadratic(element.nodes[i]) * laplacians[i];
      CHECK(sum == doctest::Approx(-2).epsilon(1e-10));
    }
  }

  TEST_CASE("Laplacians on a bent triangle agree with differences of the function") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0.1}, {0.2, 0.9}};
    mesh.triangles = {{0, 1, 2}};
    FeMesh fe = straight_fe_mesh(mesh);
    fe.edge_points[fe.edges.triangle_edges[0][1]] = {0.7, 0.6};
    fe.edge_is_bent[fe.edges.triangle_edges[0][1]] = 1;
    const Element element = element_at(fe, 0);
    const ReferencePoint at{0.3, 0.4};
    const MapPoint map = map_at(element, at);
    const ScalarBasis basis = scalar_basis(element.shape, 2, at);
    std::array<Vector, 9> gradients{};
    for (int i = 0; i < 6; ++i) gradients[i] = map.gradient(basis.gradient[i]);
    const auto laplacians = basis_laplacians(element, 2, at, gradients);
    for (int i = 0; i < 6; ++i) {
      const auto value = [&](Point p) {
        return scalar_basis(element.shape, 2, *inverse_map(element, p)).value[i];
      };
      const double h = 1e-3;
      const double differences =
          (value(map.x + Vector{h, 0}) + value(map.x - Vector{h, 0}) + value(map.x + Vector{0, h}) +
           value(map.x - Vector{0, h}) - 4 * value(map.x)) /
          (h * h);
      CHECK(laplacians[i] == doctest::Approx(differences).epsilon(1e-4));
    }
  }

  TEST_CASE("linear elements are exact at the nodes of a strip at any Peclet number") {
    for (const double eps : {0.03, 0.01, 1e-4}) {
      CAPTURE(eps);
      const ScalarProblem problem{eps, 0., 1., {{kLeft, 0}, {kRight, 0}}};
      const Mesh mesh = square_quads(10, 2);
      const FeMesh fe = straight_fe_mesh(mesh);
      const auto u = solve_scalar(fe, with_velocity(problem, {1, 0}));
      CHECK(nodal_error(fe, u.field, [eps](Point p) { return outflow(p.x, eps); }) < 1e-11);
    }
  }

  TEST_CASE("quadratics pass the patch test although the flow dominates") {
    // Consistent only if the residual holds the Laplacian. Peclet number about 3 / (2 * 8 * .04).
    for (const Mesh& mesh : {square_mesh(4), square_quads(4, 4), mixed_square(4, 4)}) {
      const Mesh rough = perturbed(mesh, 4, 4, 0.3, 6);
      const FeMesh fe = straight_fe_mesh(rough);
      const auto problem =
          with_velocity(with_values(0.02, 0, quadratic_source, quadratic), {3, -2});
      CHECK(nodal_error(fe, solve_scalar(fe, problem, of_order(2)).field, quadratic) < 1e-11);
    }
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("an unresolved exponential layer does not make the solution oscillate") {
    // eps = 1e-3 on 16 columns: Peclet number 31; without stabilisation u_h jumps by its own size.
    const ExactSolution exact = exponential_layer(1e-3, 0, 1);
    const auto problem = with_velocity(problem_of(exact, 1e-3, 0), {1, 0});
    for (const int order : {1, 2})
      for (const Mesh& mesh : {square_mesh(16), square_quads(16, 16), mixed_square(16, 16)}) {
        CAPTURE(order);
        const auto u = solve_straight(mesh, problem, order).field.values;
        double overshoot = 0, interior = 0;
        for (std::size_t v = 0; v < mesh.points.size(); ++v) {
          overshoot = std::max({overshoot, u[v] - 1, -u[v]});
          const bool is_before_layer = mesh.points[v].x < 0.9;
          if (is_before_layer)
            interior = std::max(interior, std::abs(u[v] - exact.value(mesh.points[v])));
        }
        CHECK(overshoot < 0.08);
        CHECK(interior < 0.06);
      }
  }

  TEST_CASE("the resolved exponential layer converges with the order of the element") {
    const ExactSolution exact = exponential_layer(0.1, 0, 1);
    const auto problem = with_velocity(problem_of(exact, 0.1, 0), {1, 0});
    for (const int order : {1, 2}) {
      const double coarse = solve_and_compare(mixed_square(20, 20), problem, exact, order).h1;
      const double fine = solve_and_compare(mixed_square(40, 40), problem, exact, order).h1;
      CHECK(std::log2(coarse / fine) == doctest::Approx(order).epsilon(0.05));
    }
  }

  TEST_CASE("smooth solutions keep the order although the flow dominates") {
    ExactParameters parameters;
    parameters.diffusion = 1e-5;
    parameters.velocity = {2, 1};
    const ExactSolution exact = exact_solution("sine-product", parameters);
    const auto problem = with_velocity(problem_of(exact, 1e-5, 0), {2, 1});
    for (const int order : {1, 2}) {
      const ErrorNorms coarse = solve_and_compare(square_mesh(16), problem, exact, order);
      const ErrorNorms fine = solve_and_compare(square_mesh(32), problem, exact, order);
      CHECK(std::log2(coarse.h1 / fine.h1) == doctest::Approx(order).epsilon(0.1));
      CHECK(std::log2(coarse.l2 / fine.l2) > order + 0.4);
    }
  }

  TEST_CASE("parabolic layers on a fitted mesh converge") {
    const ExactSolution exact = parabolic_layers(1e-4, 0, 1);
    const auto problem = with_velocity(problem_of(exact, 1e-4, 0), {1, 0});
    const auto error = [&](Index n, int order) {
      return solve_and_compare(
                 mapped(square_quads(n, n),
                        [](Point p) {
                          return Point{layer_at_end(p.x, 1e-3), layers_at_both_ends(p.y, 0.08)};
                        }),
                 problem, exact, order)
          .relative_energy();
    };
    for (const int order : {1, 2}) {
      CAPTURE(order);
      CHECK(std::log2(error(16, order) / error(32, order)) > 0.85 * order);
    }
    CHECK(error(32, 2) < 0.02);
  }
}
