#include "solver/space/basis.hpp"

namespace anisofront {
namespace {

/// Reference gradients of L1 = 1 - xi - eta, L2 = xi, L3 = eta.
constexpr std::array<Vector, 3> kBarycentricGradients{{{-1, -1}, {1, 0}, {0, 1}}};

std::array<double, 3> barycentric(ReferencePoint at) { return {1 - at.xi - at.eta, at.xi, at.eta}; }

/// Corners of the reference square, and the points of its edges and centre.
constexpr std::array<Vector, 9> kSquareNodes{
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};

/// The quadratic Lagrange function of node n in {-1, 0, 1} on [-1, 1], and its derivative.
struct Quadratic {
  double value, slope;
};
Quadratic quadratic(double node, double t) {
  if (node == 0) return {1 - t * t, -2 * t};
  return {0.5 * t * (t + node), t + 0.5 * node};
}

}  // namespace

Basis<3> linear_triangle(ReferencePoint at) { return {barycentric(at), kBarycentricGradients}; }

Basis<6> quadratic_triangle(ReferencePoint at) {
  const auto l = barycentric(at);
  Basis<6> basis;
  for (int k = 0; k < 3; ++k) {
    basis.value[k] = l[k] * (2 * l[k] - 1);
    basis.gradient[k] = (4 * l[k] - 1) * kBarycentricGradients[k];
    const int j = (k + 1) % 3;
    basis.value[3 + k] = 4 * l[k] * l[j];
    basis.gradient[3 + k] =
        4 * l[k] * kBarycentricGradients[j] + 4 * l[j] * kBarycentricGradients[k];
  }
  return basis;
}

Basis<4> bilinear_quad(ReferencePoint at) {
  Basis<4> basis;
  for (int k = 0; k < 4; ++k) {
    const Vector n = kSquareNodes[k];
    basis.value[k] = 0.25 * (1 + n.x * at.xi) * (1 + n.y * at.eta);
    basis.gradient[k] = {0.25 * n.x * (1 + n.y * at.eta), 0.25 * n.y * (1 + n.x * at.xi)};
  }
  return basis;
}

Basis<8> serendipity_quad(ReferencePoint at) {
  const double x = at.xi, y = at.eta;
  Basis<8> basis;
  for (int k = 0; k < 4; ++k) {
    const auto [a, b] = kSquareNodes[k];
    const double fx = 1 + a * x, fy = 1 + b * y, s = a * x + b * y - 1;
    basis.value[k] = 0.25 * fx * fy * s;
    basis.gradient[k] = {0.25 * a * fy * (s + fx), 0.25 * b * fx * (s + fy)};
  }
  for (int k = 4; k < 8; ++k) {
    const auto [a, b] = kSquareNodes[k];
    const double fx = 1 + a * x, fy = 1 + b * y;
    if (a == 0) {  // on an edge along xi
      basis.value[k] = 0.5 * (1 - x * x) * fy;
      basis.gradient[k] = {-x * fy, 0.5 * b * (1 - x * x)};
    } else {
      basis.value[k] = 0.5 * (1 - y * y) * fx;
      basis.gradient[k] = {0.5 * a * (1 - y * y), -y * fx};
    }
  }
  return basis;
}

Basis<9> biquadratic_quad(ReferencePoint at) {
  Basis<9> basis;
  for (int k = 0; k < 9; ++k) {
    const Quadratic f = quadratic(kSquareNodes[k].x, at.xi);
    const Quadratic g = quadratic(kSquareNodes[k].y, at.eta);
    basis.value[k] = f.value * g.value;
    basis.gradient[k] = {f.slope * g.value, f.value * g.slope};
  }
  return basis;
}

Basis<3> crouzeix_raviart(ReferencePoint at) {
  const auto l = barycentric(at);
  Basis<3> basis;
  for (int k = 0; k < 3; ++k) {
    const int opposite = (k + 2) % 3;
    basis.value[k] = 1 - 2 * l[opposite];
    basis.gradient[k] = -2 * kBarycentricGradients[opposite];
  }
  return basis;
}

Basis<1> triangle_bubble(ReferencePoint at) {
  const auto [a, b, c] = barycentric(at);
  const auto& g = kBarycentricGradients;
  return {{27 * a * b * c}, {27 * (b * c * g[0] + a * c * g[1] + a * b * g[2])}};
}

std::array<double, 2> linear_trace(double t) { return {1 - t, t}; }

std::array<double, 3> quadratic_trace(double t) {
  return {(1 - t) * (1 - 2 * t), t * (2 * t - 1), 4 * t * (1 - t)};
}

}  // namespace anisofront
