#include "solver/space/reference_quadrature.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/space/quadrature.hpp"

namespace anisofront {
namespace {

constexpr int kMaxGauss = 7;  ///< exact up to degree 13

struct GaussPoint {
  double x, weight;  ///< on [-1, 1]
};

/// Roots of the Legendre polynomial P_n by Newton steps from Chebyshev's estimates.
std::vector<GaussPoint> gauss_rule(int n) {
  std::vector<GaussPoint> rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 20; ++step) {
      double p = 1, before = 0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    if (2 * i + 1 == n) x = 0;
    rule.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return rule;
}

int points_for(int degree, int highest) {
  if (degree < 0 || degree > highest)
    throw std::out_of_range("no quadrature rule of degree " + std::to_string(degree));
  return degree / 2 + 1;
}

using Rule = std::vector<WeightedPoint>;

Rule square_rule(int n) {
  Rule rule;
  const auto gauss = gauss_rule(n);
  for (const auto& [y, wy] : gauss)
    for (const auto& [x, wx] : gauss) rule.push_back({{x, y}, wx * wy});
  return rule;
}

Rule triangle_rule(int degree) {
  Rule rule;
  for (const auto& [l, weight] : triangle_quadrature(degree))
    rule.push_back({{l[1], l[2]}, 0.5 * weight});
  return rule;
}

}  // namespace

std::span<const WeightedPoint> reference_quadrature(Shape shape, int degree) {
  static const auto triangles = [] {
    std::vector<Rule> rules;
    for (int d = 0; d <= kMaxQuadratureDegree; ++d) rules.push_back(triangle_rule(d));
    return rules;
  }();
  static const auto squares = [] {
    std::vector<Rule> rules;
    for (int n = 1; n <= kMaxGauss; ++n) rules.push_back(square_rule(n));
    return rules;
  }();
  const int n = points_for(degree, kMaxQuadratureDegree);
  return shape == Shape::triangle ? triangles[degree] : squares[n - 1];
}

std::span<const EdgeQuadraturePoint> edge_quadrature(int degree) {
  static const auto rules = [] {
    std::vector<std::vector<EdgeQuadraturePoint>> all(kMaxGauss);
    for (int n = 1; n <= kMaxGauss; ++n)
      for (const auto& [x, weight] : gauss_rule(n))
        all[n - 1].push_back({0.5 * (1 + x), 0.5 * weight});
    return all;
  }();
  return rules[points_for(degree, 2 * kMaxGauss - 1) - 1];
}

}  // namespace anisofront
