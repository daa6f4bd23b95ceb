#include "solver/scalar/norms.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/scalar/element_sum.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

constexpr int kDegree = 8;
constexpr int kCheckDegree = 6;
constexpr int kMaxDepth = 12;
/// Largest deviation of u from linear inside a part, relative to the largest |u|.
constexpr double kLinearity = 0.05;
/// Agreement of the two rules, relative to the part and to the mean over the mesh.
constexpr double kRelative = 1e-4;
constexpr double kAbsolute = 1e-5;
/// Squared errors below this share of the squared energy of u are rounding.
constexpr double kRounding = 1e-20;

struct Integrals {
  double e2 = 0, grad_e2 = 0;                 ///< of the error
  double error_energy = 0, exact_energy = 0;  ///< a |grad|^2 + c ^2 of the error and of u

  Integrals& operator+=(const Integrals& b) {
    e2 += b.e2;
    grad_e2 += b.grad_e2;
    error_energy += b.error_energy;
    exact_energy += b.exact_energy;
    return *this;
  }
  bool is_finite() const { return std::isfinite(e2 + grad_e2 + error_energy + exact_energy); }
};

/// Without this, elements would be divided to the last depth everywhere.
[[noreturn]] void refuse(Point at, const ScalarState& field) {
  const bool is_field = !std::isfinite(field.value + field.gradient.x + field.gradient.y);
  throw InputError(std::string(is_field ? "the field" : "the exact solution or a coefficient") +
                   " is not finite at " + describe(at) + "; error norms need finite values");
}

/// The integrand on one element.
struct Integrand {
  const ExactSolution& exact;
  const Coefficient &diffusion, &reaction;
  ScalarOnElement field;

  Integrals at(ReferencePoint at, const MapPoint& map, double u, double weight) const {
    const ScalarState state = field.at(at);
    const Vector g = exact.gradient(map.x);
    const double dx = weight * map.determinant(), a = diffusion(map.x), c = reaction(map.x);
    const double e2 = (u - state.value) * (u - state.value);
    const double grad_e2 = squared_norm(g - state.gradient);
    const Integrals result{dx * e2, dx * grad_e2, dx * (a * grad_e2 + c * e2),
                           dx * (a * squared_norm(g) + c * u * u)};
    if (!result.is_finite()) refuse(map.x, state);
    return result;
  }
};

/// A part of the reference element: the image of the whole one under origin + xi u + eta v.
struct Part {
  ReferencePoint origin{0, 0};
  Vector u{1, 0}, v{0, 1};

  ReferencePoint operator()(double xi, double eta) const {
    return {origin.xi + xi * u.x + eta * v.x, origin.eta + xi * u.y + eta * v.y};
  }
};

std::array<Part, 4> quarters(Shape shape, const Part& p) {
  const Vector u = 0.5 * p.u, v = 0.5 * p.v;
  if (shape == Shape::quadrilateral)
    return {
        {{p(-0.5, -0.5), u, v}, {p(0.5, -0.5), u, v}, {p(0.5, 0.5), u, v}, {p(-0.5, 0.5), u, v}}};
  return {{{p.origin, u, v}, {p(0.5, 0), u, v}, {p(0, 0.5), u, v}, {p(0.5, 0.5), -u, -v}}};
}

/// What is fixed for the whole mesh.
struct Scales {
  double max_value = 0;                       ///< max |u|
  double error_energy = 0, exact_energy = 0;  ///< admissible absolute difference per element
};

struct RuleResult {
  Integrals integrals;
  double max_value = 0;     ///< max |u| over the points
  double nonlinearity = 0;  ///< max deviation of u from the (bi)linear interpolant of the corners

  RuleResult& operator+=(const RuleResult& b) {
    integrals += b.integrals;
    max_value = std::max(max_value, b.max_value);
    nonlinearity = std::max(nonlinearity, b.nonlinearity);
    return *this;
  }
};

/// u at the corners of a part, and its (bi)linear interpolant.
struct CornerValues {
  Shape shape;
  std::array<double, 4> u{};

  CornerValues(const Integrand& integrand, const Part& part)
      : shape(integrand.field.element.shape) {
    const double low = shape == Shape::triangle ? 0 : -1;
    const ReferencePoint corners[] = {part(low, low), part(1, low),
                                      shape == Shape::triangle ? part(low, 1) : part(1, 1),
                                      part(low, 1)};
    for (int k = 0; k < integrand.field.element.corners; ++k)
      u[k] = integrand.exact.value(map_at(integrand.field.element, corners[k]).x);
  }
  double at(ReferencePoint p) const {
    if (shape == Shape::triangle) return (1 - p.xi - p.eta) * u[0] + p.xi * u[1] + p.eta * u[2];
    return 0.25 * ((1 - p.eta) * ((1 - p.xi) * u[0] + (1 + p.xi) * u[1]) +
                   (1 + p.eta) * ((1 - p.xi) * u[3] + (1 + p.xi) * u[2]));
  }
};

RuleResult apply_rule(int degree, const Integrand& integrand, const Part& part,
                      const CornerValues& corners) {
  const double size = cross(part.u, part.v);
  RuleResult result;
  for (const auto& [at, weight] : reference_quadrature(corners.shape, degree)) {
    const ReferencePoint place = part(at.xi, at.eta);
    const MapPoint map = map_at(integrand.field.element, place);
    const double u = integrand.exact.value(map.x);
    result +=
        {integrand.at(place, map, u, size * weight), std::abs(u), std::abs(u - corners.at(at))};
  }
  return result;
}

bool agree(const Integrals& x, const Integrals& y, const Scales& scales) {
  const auto close = [](double p, double q, double absolute) {
    return std::abs(p - q) <= kRelative * std::abs(p) + absolute;
  };
  return close(x.error_energy, y.error_energy, scales.error_energy) &&
         close(x.exact_energy, y.exact_energy, scales.exact_energy);
}

Integrals integrate(const Integrand& integrand, const Part& part, const Scales& scales,
                    int depth = 0) {
  const CornerValues corners(integrand, part);
  const RuleResult fine = apply_rule(kDegree, integrand, part, corners);
  const RuleResult check = apply_rule(kCheckDegree, integrand, part, corners);
  const bool smooth = fine.nonlinearity <= kLinearity * scales.max_value;
  if (depth == kMaxDepth || (smooth && agree(fine.integrals, check.integrals, scales)))
    return fine.integrals;
  Integrals sum;
  for (const Part& quarter : quarters(corners.shape, part))
    sum += integrate(integrand, quarter, scales, depth + 1);
  return sum;
}

/// The field against the exact solution, element by element.
struct Comparison {
  const FeMesh& mesh;
  const ScalarProblem& problem;
  const ExactSolution& exact;
  const ScalarField& field;
  int threads;

  Integrand on(Index e) const {
    const Element element = element_at(mesh, e);
    return {exact, problem.diffusion.in(element.region), problem.reaction.in(element.region),
            on_element(mesh, field, element)};
  }
};

/// Absolute tolerances from one plain pass of the rule over the mesh.
Scales scales_of(const Comparison& c) {
  const auto whole = element_sum<RuleResult>(c.mesh.element_count(), c.threads, [&](Index e) {
    const Integrand integrand = c.on(e);
    return apply_rule(kCheckDegree, integrand, {}, CornerValues(integrand, {}));
  });
  const double elements = c.mesh.element_count();
  const Integrals& sum = whole.integrals;
  return {whole.max_value, (kAbsolute * sum.error_energy + kRounding * sum.exact_energy) / elements,
          kAbsolute * sum.exact_energy / elements};
}

}  // namespace

ErrorNorms error_norms(const FeMesh& mesh, const ScalarProblem& problem, const ExactSolution& exact,
                       const ScalarField& field, int threads) {
  const Comparison comparison{mesh, problem, exact, field, threads};
  const Scales scales = scales_of(comparison);
  const auto sum = element_sum<Integrals>(mesh.element_count(), threads, [&](Index e) {
    return integrate(comparison.on(e), {}, scales);
  });
  return {std::sqrt(sum.e2), std::sqrt(sum.grad_e2), std::sqrt(sum.error_energy),
          std::sqrt(sum.exact_energy)};
}

}  // namespace anisofront
