#include "solver/norms.hpp"

#include <algorithm>
#include <cmath>

#include "solver/p1_element.hpp"
#include "solver/quadrature.hpp"

namespace anisofront {
namespace {

constexpr int kDegree = 8;
constexpr int kCheckDegree = 6;
constexpr int kMaxDepth = 12;
/// Largest deviation of u from linear inside a sub-triangle, relative to the largest |u|.
constexpr double kLinearity = 0.05;
/// Agreement of the two rules, relative to the sub-triangle and to the mean over the mesh.
constexpr double kRelative = 1e-4;
constexpr double kAbsolute = 1e-5;

struct Integrals {
  double e2 = 0, grad_e2 = 0;  ///< of the error
  double u2 = 0, grad_u2 = 0;  ///< of the exact solution

  void add(double w, const Integrals& b) {
    e2 += w * b.e2;
    grad_e2 += w * b.grad_e2;
    u2 += w * b.u2;
    grad_u2 += w * b.grad_u2;
  }
};

/// The integrand on one triangle of the mesh, where u_h is linear.
struct Integrand {
  const ExactSolution& exact;
  Point origin;
  double value;     ///< u_h at the origin
  Vector gradient;  ///< of u_h

  Integrals at(Point p, double u) const {
    const Vector g = exact.gradient(p);
    const double e = u - value - dot(gradient, p - origin);
    return {e * e, squared_norm(g - gradient), u * u, squared_norm(g)};
  }
};

/// What is fixed for the whole mesh.
struct Scales {
  double a, c;                                ///< coefficients of the energy
  double max_value;                           ///< max |u|
  double error_energy = 0, exact_energy = 0;  ///< admissible absolute difference per triangle
};

struct RuleResult {
  Integrals integrals;
  double max_value = 0;     ///< max |u| over the points
  double nonlinearity = 0;  ///< max deviation of u from the linear interpolant of the corners
};

RuleResult apply_rule(int degree, const Integrand& integrand, const std::array<Point, 3>& corners) {
  const double area = 0.5 * twice_area(corners[0], corners[1], corners[2]);
  std::array<double, 3> u{};
  for (int i = 0; i < 3; ++i) u[i] = integrand.exact.value(corners[i]);
  RuleResult result;
  for (const auto& [l, weight] : triangle_quadrature(degree)) {
    const Point p = point_at(corners, l);
    const double value = integrand.exact.value(p);
    const double linear = l[0] * u[0] + l[1] * u[1] + l[2] * u[2];
    result.max_value = std::max(result.max_value, std::abs(value));
    result.nonlinearity = std::max(result.nonlinearity, std::abs(value - linear));
    result.integrals.add(area * weight, integrand.at(p, value));
  }
  return result;
}

bool agree(const Integrals& x, const Integrals& y, const Scales& s) {
  const auto close = [](double p, double q, double absolute) {
    return std::abs(p - q) <= kRelative * std::abs(p) + absolute;
  };
  return close(s.a * x.grad_e2 + s.c * x.e2, s.a * y.grad_e2 + s.c * y.e2, s.error_energy) &&
         close(s.a * x.grad_u2 + s.c * x.u2, s.a * y.grad_u2 + s.c * y.u2, s.exact_energy);
}

std::array<std::array<Point, 3>, 4> quarters(const std::array<Point, 3>& p) {
  const Point a = lerp(p[1], p[2], 0.5), b = lerp(p[2], p[0], 0.5), c = lerp(p[0], p[1], 0.5);
  return {{{p[0], c, b}, {c, p[1], a}, {b, a, p[2]}, {a, b, c}}};
}

Integrals integrate(const Integrand& integrand, const std::array<Point, 3>& corners,
                    const Scales& scales, int depth = 0) {
  const RuleResult fine = apply_rule(kDegree, integrand, corners);
  const RuleResult check = apply_rule(kCheckDegree, integrand, corners);
  const bool smooth = fine.nonlinearity <= kLinearity * scales.max_value;
  if (depth == kMaxDepth || (smooth && agree(fine.integrals, check.integrals, scales)))
    return fine.integrals;
  Integrals sum;
  for (const auto& quarter : quarters(corners))
    sum.add(1, integrate(integrand, quarter, scales, depth + 1));
  return sum;
}

Integrand integrand_on(const Mesh& mesh, const Triangle& t, const ExactSolution& exact,
                       std::span<const double> values) {
  const P1Element element(corners_of(mesh, t));
  return {exact, mesh.points[t[0]], values[t[0]], element.gradient(values_at(values, t))};
}

/// Absolute tolerances from one plain pass of the rule over the mesh.
Scales scales_of(const Mesh& mesh, const ScalarProblem& problem, const ExactSolution& exact,
                 std::span<const double> values) {
  Scales s{problem.diffusion, problem.reaction, 0};
  Integrals sum;
  for (const Triangle& t : mesh.triangles) {
    const RuleResult result =
        apply_rule(kCheckDegree, integrand_on(mesh, t, exact, values), corners_of(mesh, t));
    s.max_value = std::max(s.max_value, result.max_value);
    sum.add(1, result.integrals);
  }
  const double share = kAbsolute / static_cast<double>(mesh.triangles.size());
  s.error_energy = share * (s.a * sum.grad_e2 + s.c * sum.e2);
  s.exact_energy = share * (s.a * sum.grad_u2 + s.c * sum.u2);
  return s;
}

}  // namespace

ErrorNorms error_norms(const Mesh& mesh, const ScalarProblem& problem, const ExactSolution& exact,
                       std::span<const double> values) {
  const Scales scales = scales_of(mesh, problem, exact, values);
  Integrals sum;
  for (const Triangle& t : mesh.triangles)
    sum.add(1, integrate(integrand_on(mesh, t, exact, values), corners_of(mesh, t), scales));
  return {std::sqrt(sum.e2), std::sqrt(sum.grad_e2),
          std::sqrt(problem.diffusion * sum.grad_e2 + problem.reaction * sum.e2),
          std::sqrt(problem.diffusion * sum.grad_u2 + problem.reaction * sum.u2)};
}

}  // namespace anisofront
