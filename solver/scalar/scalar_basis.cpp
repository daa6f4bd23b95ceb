#include "solver/scalar/scalar_basis.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/space/basis.hpp"
#include "solver/space/quadrature.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

template <std::size_t N>
ScalarBasis padded(const std::array<double, N>& value, const std::array<Vector, N>& gradient) {
  ScalarBasis basis{static_cast<int>(N), {}, {}};
  std::copy(value.begin(), value.end(), basis.value.begin());
  std::copy(gradient.begin(), gradient.end(), basis.gradient.begin());
  return basis;
}
template <int N>
ScalarBasis padded(const Basis<N>& basis) {
  return padded<static_cast<std::size_t>(N)>(basis.value, basis.gradient);
}

std::array<ReferenceHessian, 9> quadratic_triangle_hessians() {
  // L1 (2 L1 - 1), ..., 4 L1 L2, 4 L2 L3, 4 L3 L1 with L1 = 1 - xi - eta, L2 = xi, L3 = eta.
  return {{{4, 4, 4}, {4, 0, 0}, {0, 0, 4}, {-8, -4, 0}, {0, 4, 0}, {0, -4, -8}}};
}

std::array<ReferenceHessian, 9> bilinear_hessians() {
  return {{{0, 0.25, 0}, {0, -0.25, 0}, {0, 0.25, 0}, {0, -0.25, 0}}};
}

/// The quadratic Lagrange function of node -1, 0 or 1 of [-1, 1] at t: value and derivatives.
std::array<double, 3> quadratic_at(int node, double t) {
  if (node == 0) return {1 - t * t, -2 * t, -2};
  return {0.5 * t * (t + node), t + 0.5 * node, 1};
}

std::array<ReferenceHessian, 9> biquadratic_hessians(ReferencePoint at) {
  constexpr int kXi[] = {-1, 1, 1, -1, 0, 1, 0, -1, 0};
  constexpr int kEta[] = {-1, -1, 1, 1, -1, 0, 1, 0, 0};
  std::array<ReferenceHessian, 9> hessians;
  for (int k = 0; k < 9; ++k) {
    const auto f = quadratic_at(kXi[k], at.xi), g = quadratic_at(kEta[k], at.eta);
    hessians[k] = {f[2] * g[0], f[1] * g[1], f[0] * g[2]};
  }
  return hessians;
}

using Rule = std::vector<ScalarBasisPoint>;

std::vector<Rule> rules_of(Shape shape, int order) {
  std::vector<Rule> rules;
  for (int degree = 0; degree <= kMaxQuadratureDegree; ++degree) {
    Rule& rule = rules.emplace_back();
    for (const auto& [at, weight] : reference_quadrature(shape, degree))
      rule.push_back({at, weight, scalar_basis(shape, order, at)});
  }
  return rules;
}

}  // namespace

ScalarBasis scalar_basis(Shape shape, int order, ReferencePoint at) {
  if (shape == Shape::triangle)
    return order == 1 ? padded(linear_triangle(at)) : padded(quadratic_triangle(at));
  return order == 1 ? padded(bilinear_quad(at)) : padded(biquadratic_quad(at));
}

std::array<ReferenceHessian, 9> scalar_basis_hessians(Shape shape, int order, ReferencePoint at) {
  if (shape == Shape::quadrilateral)
    return order == 1 ? bilinear_hessians() : biquadratic_hessians(at);
  if (order == 2) return quadratic_triangle_hessians();
  return {};
}

std::span<const ScalarBasisPoint> scalar_rule(Shape shape, int order, int degree) {
  static const std::array<std::vector<Rule>, 4> tables{
      rules_of(Shape::triangle, 1), rules_of(Shape::triangle, 2), rules_of(Shape::quadrilateral, 1),
      rules_of(Shape::quadrilateral, 2)};
  return tables[(shape == Shape::triangle ? 0 : 2) + order - 1][degree];
}

DofLayout scalar_layout(int order) {
  if (order != 1 && order != 2)
    throw std::out_of_range("scalar elements have order 1 or 2, not " + std::to_string(order));
  return order == 1 ? DofLayout{1, 0, 0, 0} : DofLayout{1, 1, 0, 1};
}

}  // namespace anisofront
