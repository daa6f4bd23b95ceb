#include "solver/scalar/scalar_kernel.hpp"

#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "solver/scalar/supg.hpp"

namespace anisofront {
namespace {

constexpr int kTriangleDegree = 6;
constexpr int kQuadDegree = 7;
/// Exact for the mass matrix of Q2 on straight quadrilaterals.
constexpr int kConstantQuadDegree = 5;

[[noreturn]] void throw_sign(const char* what, double value, Point p, const char* expected) {
  throw InputError(std::string(what) + " is " + describe(value) + " at " + describe(p) +
                   ", expected " + expected);
}

/// The coefficients of one region.
struct Coefficients {
  const Coefficient &a, &c, &f, &b_x, &b_y;

  Coefficients(const ScalarProblem& problem, Index region)
      : a(problem.diffusion.in(region)),
        c(problem.reaction.in(region)),
        f(problem.source.in(region)),
        b_x(problem.velocity_x.in(region)),
        b_y(problem.velocity_y.in(region)) {}

  bool has_convection() const { return !b_x.is_zero() || !b_y.is_zero(); }
  bool has_constant_matrix() const {
    return a.is_constant() && c.is_constant() && b_x.is_constant() && b_y.is_constant();
  }
  double diffusion(Point p) const {
    const double value = finite_value(a, p, "the diffusion");
    if (!(value > 0)) throw_sign("the diffusion", value, p, "a positive number");
    return value;
  }
  double reaction(Point p) const {
    const double value = finite_value(c, p, "the reaction");
    if (!(value >= 0)) throw_sign("the reaction", value, p, "no negative number");
    return value;
  }
  double source(Point p) const { return finite_value(f, p, "the source"); }
  Vector velocity(Point p) const {
    return {finite_value(b_x, p, "the velocity"), finite_value(b_y, p, "the velocity")};
  }
};

/// Integrals over the reference triangle: with them the matrix of a straight triangle is a
/// combination of four.
struct ReferenceMatrices {
  int count = 0;
  double xi_xi[6][6]{}, mixed[6][6]{}, eta_eta[6][6]{}, mass[6][6]{};
  double load[6]{};
};

ReferenceMatrices reference_matrices(int order) {
  ReferenceMatrices m;
  for (const auto& [at, weight, basis] : scalar_rule(Shape::triangle, order, 4)) {
    m.count = basis.count;
    for (int i = 0; i < basis.count; ++i) {
      const Vector g = basis.gradient[i];
      m.load[i] += weight * basis.value[i];
      for (int j = 0; j < basis.count; ++j) {
        const Vector h = basis.gradient[j];
        m.xi_xi[i][j] += weight * (g.x * h.x);
        m.mixed[i][j] += weight * (g.x * h.y + g.y * h.x);
        m.eta_eta[i][j] += weight * (g.y * h.y);
        m.mass[i][j] += weight * (basis.value[i] * basis.value[j]);
      }
    }
  }
  return m;
}

void add_source(const Coefficients& coefficients, int order, int degree, const Element& element,
                ElementSystem& system) {
  for (const auto& [at, weight, basis] : scalar_rule(element.shape, order, degree)) {
    const MapPoint map = map_at(element, at);
    const double f = weight * map.determinant() * coefficients.source(map.x);
    for (int i = 0; i < basis.count; ++i) system.rhs[i] += f * basis.value[i];
  }
}

/// Straight triangle, constant a and c, no convection.
void fill_constant(const Coefficients& coefficients, int order, const Element& element,
                   ElementSystem& system) {
  static const ReferenceMatrices references[] = {reference_matrices(1), reference_matrices(2)};
  const ReferenceMatrices& r = references[order - 1];
  const MapPoint map = map_at(element, {1. / 3, 1. / 3});
  const double det = positive_determinant(map, element), a = coefficients.diffusion(map.x) / det;
  const double xi_xi = a * dot(map.d_eta, map.d_eta), mixed = -a * dot(map.d_xi, map.d_eta),
               eta_eta = a * dot(map.d_xi, map.d_xi), mass = coefficients.reaction(map.x) * det;
  for (int j = 0; j < r.count; ++j)
    for (int i = 0; i < r.count; ++i)
      system.matrix(i, j) = xi_xi * r.xi_xi[i][j] + mixed * r.mixed[i][j] +
                            eta_eta * r.eta_eta[i][j] + mass * r.mass[i][j];
  if (!coefficients.f.is_constant())
    return add_source(coefficients, order, kTriangleDegree, element, system);
  const double f = coefficients.source(map.x) * det;
  for (int i = 0; i < r.count; ++i) system.rhs[i] = f * r.load[i];
}

/// What the terms of the equation need at one quadrature point.
struct PointTerms {
  const ScalarBasis& basis;
  double measure = 0;  ///< weight times area element
  double a = 0, c = 0, f = 0;
  Vector b{};
  std::array<Vector, 9> gradients{};  ///< of the basis in x
};

PointTerms terms_at(const Coefficients& coefficients, const Element& element,
                    const ScalarBasisPoint& point) {
  const MapPoint map = map_at(element, point.at);
  PointTerms terms{.basis = point.basis,
                   .measure = point.weight * positive_determinant(map, element),
                   .a = coefficients.diffusion(map.x),
                   .c = coefficients.reaction(map.x),
                   .f = coefficients.source(map.x)};
  if (coefficients.has_convection()) terms.b = coefficients.velocity(map.x);
  for (int i = 0; i < point.basis.count; ++i)
    terms.gradients[i] = map.gradient(point.basis.gradient[i]);
  return terms;
}

void add_galerkin(const PointTerms& t, ElementSystem& system) {
  for (int j = 0; j < t.basis.count; ++j) {
    const double low_order = dot(t.b, t.gradients[j]) + t.c * t.basis.value[j];
    for (int i = 0; i < t.basis.count; ++i)
      system.matrix(i, j) +=
          t.measure * (t.a * dot(t.gradients[i], t.gradients[j]) + t.basis.value[i] * low_order);
    system.rhs[j] += t.measure * t.f * t.basis.value[j];
  }
}

double flow_length_at(Vector b, const Element& element, ReferencePoint at) {
  const MapPoint map = map_at(element, at);
  const ScalarBasis linear = scalar_basis(element.shape, 1, at);
  std::array<Vector, 9> gradients{};
  for (int i = 0; i < linear.count; ++i) gradients[i] = map.gradient(linear.gradient[i]);
  return flow_length(b, linear.count, gradients);
}

void add_supg(const PointTerms& t, int order, const Element& element, ReferencePoint at,
              ElementSystem& system) {
  const double tau = supg_time(t.b, t.a, flow_length_at(t.b, element, at) / order);
  if (tau == 0) return;
  const auto laplacians = basis_laplacians(element, order, at, t.gradients);
  std::array<double, 9> residual{};
  for (int j = 0; j < t.basis.count; ++j)
    residual[j] = dot(t.b, t.gradients[j]) + t.c * t.basis.value[j] - t.a * laplacians[j];
  for (int i = 0; i < t.basis.count; ++i) {
    const double test = t.measure * tau * dot(t.b, t.gradients[i]);
    for (int j = 0; j < t.basis.count; ++j) system.matrix(i, j) += test * residual[j];
    system.rhs[i] += test * t.f;
  }
}

void fill_by_quadrature(const Coefficients& coefficients, int order, const Element& element,
                        ElementSystem& system) {
  const bool constant =
      coefficients.has_constant_matrix() && coefficients.f.is_constant() && !element.bent;
  const int degree = element.shape == Shape::triangle ? kTriangleDegree
                     : constant                       ? kConstantQuadDegree
                                                      : kQuadDegree;
  for (const ScalarBasisPoint& point : scalar_rule(element.shape, order, degree)) {
    const PointTerms terms = terms_at(coefficients, element, point);
    add_galerkin(terms, system);
    if (coefficients.has_convection()) add_supg(terms, order, element, point.at, system);
  }
}

}  // namespace

ElementKernel scalar_kernel(const ScalarProblem& problem, int order) {
  return [&problem, order](const Element& element, ElementSystem& system) {
    const Coefficients coefficients(problem, element.region);
    const bool is_triangle = element.shape == Shape::triangle;
    system.set_zero(is_triangle ? 3 * order : order == 1 ? 4 : 9);
    if (is_triangle && !element.bent && coefficients.has_constant_matrix() &&
        !coefficients.has_convection())
      fill_constant(coefficients, order, element, system);
    else
      fill_by_quadrature(coefficients, order, element, system);
  };
}

}  // namespace anisofront
