// The scaling alpha_T = min(h_T / sqrt(a), 1 / sqrt(c)): R. Verfuerth, Robust a posteriori error
// estimators for a singularly perturbed reaction-diffusion equation, Numer. Math. 78 (1998)
// 479-493.
// h_T the smallest height: G. Kunert, An a posteriori residual error estimator for the finite
// element method on anisotropic tetrahedral meshes, Numer. Math. 86 (2000) 471-490, and Robust a
// posteriori error estimation for a singularly perturbed reaction-diffusion equation on anisotropic
// tetrahedral meshes, Adv. Comput. Math. 15 (2001) 237-259. The upper bound then holds up to a
// factor that is moderate as long as elements are stretched along the layers.
// With convection the bound is not robust: it holds for a norm that includes b . grad e.
#include <algorithm>
#include <cmath>

#include "adapt/edge_sides.hpp"
#include "adapt/element_loop.hpp"
#include "adapt/energy_estimate.hpp"
#include "solver/scalar/reference_side.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "solver/scalar/scalar_boundary.hpp"
#include "solver/scalar/supg.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

constexpr int kResidualDegree = 6;
constexpr int kJumpDegree = 5;
/// Of the element's size, for differences of a coefficient a that varies.
constexpr double kDifferenceStep = 1e-4;

/// Heights of an element over its sides: |T| / |E|, twice that in triangles.
struct Heights {
  std::array<double, 4> over{};
  double smallest = 0;

  explicit Heights(const Element& element) {
    double twice = 0;
    for (int k = 0; k < element.corners; ++k)
      twice += cross(element.nodes[k], element.nodes[(k + 1) % element.corners]);
    const double area = element.corners == 3 ? twice : 0.5 * twice;
    for (int k = 0; k < element.corners; ++k)
      over[k] = area / norm(element.nodes[(k + 1) % element.corners] - element.nodes[k]);
    smallest = *std::min_element(over.begin(), over.begin() + element.corners);
  }
};

/// The problem on one element.
struct Local {
  const Coefficient &a, &c, &f, &b_x, &b_y;
  ScalarOnElement u;
  Heights heights;

  Local(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field,
        const Element& element)
      : a(problem.diffusion.in(element.region)),
        c(problem.reaction.in(element.region)),
        f(problem.source.in(element.region)),
        b_x(problem.velocity_x.in(element.region)),
        b_y(problem.velocity_y.in(element.region)),
        u(on_element(mesh, field, element)),
        heights(element) {}

  /// alpha_T^2 at a place.
  double squared_scale(Point x) const {
    const double by_diffusion = heights.smallest * heights.smallest / a(x), reaction = c(x);
    return reaction * by_diffusion > 1 ? 1 / reaction : by_diffusion;
  }

  Vector diffusion_gradient(Point x) const {
    if (a.is_constant()) return {};
    const double d = kDifferenceStep * heights.smallest, s = 0.5 / d;
    return {s * (a({x.x + d, x.y}) - a({x.x - d, x.y})),
            s * (a({x.x, x.y + d}) - a({x.x, x.y - d}))};
  }

  double laplacian(ReferencePoint at, const MapPoint& map) const {
    const ScalarBasis basis = scalar_basis(u.element.shape, u.order, at);
    std::array<Vector, 9> gradients{};
    for (int i = 0; i < basis.count; ++i) gradients[i] = map.gradient(basis.gradient[i]);
    const auto laplacians = basis_laplacians(u.element, u.order, at, gradients);
    double sum = 0;
    for (int i = 0; i < basis.count; ++i) sum += u.values[i] * laplacians[i];
    return sum;
  }

  /// f - c u + div a grad u - b . grad u.
  double residual(ReferencePoint at, const MapPoint& map) const {
    const ScalarState state = u.at(at);
    const Vector flow = diffusion_gradient(map.x) - Vector{b_x(map.x), b_y(map.x)};
    return f(map.x) - c(map.x) * state.value + a(map.x) * laplacian(at, map) +
           dot(flow, state.gradient);
  }

  /// int alpha_T^2 r^2.
  double squared_residual() const {
    double sum = 0;
    for (const auto& [at, weight] : reference_quadrature(u.element.shape, kResidualDegree)) {
      const MapPoint map = map_at(u.element, at);
      const double r = residual(at, map);
      sum += weight * map.determinant() * squared_scale(map.x) * r * r;
    }
    return sum;
  }

  /// Of the square of the jump at a point of side k: alpha_T h_T / (sqrt(a) h_E), from the trace
  /// inequality |v|_E^2 <= (C / h_E) |v|_T (|v|_T + h_T |grad v|_T).
  double jump_weight(int k, Point x) const {
    return std::sqrt(squared_scale(x) / a(x)) * heights.smallest / heights.over[k];
  }
};

/// A point of side k at s in [0, 1] from its corner k.
struct SidePoint {
  Point x;
  double speed = 0;  ///< |dx/ds|
  double flux = 0;   ///< a du_h/dn, n outward
  double value = 0;  ///< u_h
};

SidePoint side_point(const Local& local, int k, double s) {
  const ReferenceSide side(local.u.element.shape, k);
  const MapPoint map = map_at(local.u.element, side.at(s));
  const Vector tangent = side.direction.x * map.d_xi + side.direction.y * map.d_eta;
  const double speed = norm(tangent);
  const ScalarState state = local.u.at(side.at(s));
  const Vector normal = (1 / speed) * Vector{tangent.y, -tangent.x};
  return {map.x, speed, local.a(map.x) * dot(state.gradient, normal), state.value};
}

/// Conditions on edges by their number in the problem, -1: none.
struct EdgeConditions {
  std::vector<int> dirichlet, flux;

  EdgeConditions(const FeMesh& mesh, const ScalarProblem& problem)
      : dirichlet(mesh.edges.count(), -1), flux(mesh.edges.count(), -1) {
    for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i) {
      const Index edge = mesh.edges.curve_edges[i];
      dirichlet[edge] = condition_on(problem.dirichlet, mesh.mesh.edges[i].tag);
      flux[edge] = condition_on(problem.fluxes, mesh.mesh.edges[i].tag);
    }
  }
};

/// The jump terms of an edge, by side.
using JumpSquares = std::array<double, 2>;

JumpSquares inner_jump(const Local& first, int k, const Local& second, int l,
                       const FluxCondition* condition) {
  JumpSquares squares{};
  for (const auto& [s, weight] : edge_quadrature(kJumpDegree)) {
    const SidePoint p = side_point(first, k, s), q = side_point(second, l, 1 - s);
    double jump = -p.flux - q.flux;
    if (condition) jump += condition->flux(p.x) - condition->transfer(p.x) * p.value;
    const double half = 0.5 * weight * p.speed * jump * jump;
    squares[0] += half * first.jump_weight(k, p.x);
    squares[1] += half * second.jump_weight(l, p.x);
  }
  return squares;
}

JumpSquares boundary_jump(const Local& local, int k, const FluxCondition* condition) {
  JumpSquares squares{};
  for (const auto& [s, weight] : edge_quadrature(kJumpDegree)) {
    const SidePoint p = side_point(local, k, s);
    double jump = -p.flux;
    if (condition) jump += condition->flux(p.x) - condition->transfer(p.x) * p.value;
    squares[0] += weight * p.speed * jump * jump * local.jump_weight(k, p.x);
  }
  return squares;
}

std::vector<JumpSquares> jump_squares(const FeMesh& mesh, const ScalarProblem& problem,
                                      const ScalarField& field, const EdgeSides& sides) {
  const EdgeConditions conditions(mesh, problem);
  std::vector<JumpSquares> squares(sides.size());
  for_each_index(mesh.edges.count(), [&](Index e) {
    if (conditions.dirichlet[e] >= 0) return;
    const FluxCondition* condition =
        conditions.flux[e] >= 0 ? &problem.fluxes[conditions.flux[e]] : nullptr;
    const auto& [first, second] = sides[e];
    const Local local(mesh, problem, field, element_at(mesh, first.element));
    squares[e] = second.element == kNoIndex
                     ? boundary_jump(local, first.side, condition)
                     : inner_jump(local, first.side,
                                  {mesh, problem, field, element_at(mesh, second.element)},
                                  second.side, condition);
  });
  return squares;
}

}  // namespace

ErrorEstimate estimate_by_residual(const FeMesh& mesh, const ScalarProblem& problem,
                                   const ScalarField& field) {
  const EdgeSides sides = edge_sides(mesh);
  const auto jumps = jump_squares(mesh, problem, field, sides);
  ErrorEstimate estimate;
  estimate.indicators.resize(mesh.element_count());
  const double square = element_sum<double>(mesh.element_count(), 0, [&](Index e) {
    const Local local(mesh, problem, field, element_at(mesh, e));
    double own = local.squared_residual();
    for (int k = 0; k < local.u.element.corners; ++k) {
      const Index edge = local.u.element.edges[k];
      own += jumps[edge][sides[edge][0].element == e ? 0 : 1];
    }
    estimate.indicators[e] = std::sqrt(own);
    return own;
  });
  estimate.error = std::sqrt(square);
  estimate.energy = std::sqrt(squared_energy(mesh, problem, field));
  return estimate;
}

}  // namespace anisofront
