#include "solver/scalar/exact_solutions.hpp"

#include <cmath>
#include <numbers>

namespace anisofront {
namespace {

constexpr double kPi = std::numbers::pi;

/// g(s) of product_layer() in scaled form: with p = e^(-s/eps), q = e^(-(1-s)/eps) and
/// pq = e^(-1/eps), g = (1 - p)(1 - q) / (1 + pq), which neither overflows nor cancels.
struct Layer {
  double epsilon;
  double divisor = 1 + std::exp(-1 / epsilon);  ///< 1 + pq

  double value(double s) const {
    return std::expm1(-s / epsilon) * std::expm1(-(1 - s) / epsilon) / divisor;
  }
  double slope(double s) const {
    return (std::exp(-s / epsilon) - std::exp(-(1 - s) / epsilon)) / (epsilon * divisor);
  }
  /// g'' = (g - 1) / eps^2.
  double bend(double s) const { return (value(s) - 1) / (epsilon * epsilon); }
  /// int eps^2 g'^2 = eps T - 1 / (2 cosh^2(1/(2 eps))), T = tanh(1/(2 eps)).
  double slope_energy() const {
    const double e = std::exp(-1 / epsilon);
    return epsilon * tanh_half() - 2 * e / ((1 + e) * (1 + e));
  }
  /// int g^2, from int eps^2 g'^2 + g^2 = int g = 1 - 2 eps T.
  double square() const { return 1 - 2 * epsilon * tanh_half() - slope_energy(); }

 private:
  double tanh_half() const { return std::tanh(1 / (2 * epsilon)); }
};

/// X(x) of exponential_layer(): -eps X'' + X' = 1, X(0) = X(1) = 0.
struct Outflow {
  double epsilon;

  double value(double x) const {
    return x - (std::exp((x - 1) / epsilon) - std::exp(-1 / epsilon)) / -std::expm1(-1 / epsilon);
  }
  double slope(double x) const {
    return 1 + std::exp((x - 1) / epsilon) / (epsilon * std::expm1(-1 / epsilon));
  }
};

/// sin(pi y) with the interface of Layer.
struct Sine {
  double value(double s) const { return std::sin(kPi * s); }
  double slope(double s) const { return kPi * std::cos(kPi * s); }
  double bend(double s) const { return -kPi * kPi * value(s); }
};

/// X(x) Y(y): with -a X'' + b X' = b, f = b Y - a X Y'' + c X Y.
template <class Profile>
ExactSolution outflow_times(Profile y, double a, double c, double speed) {
  const Outflow x{a / speed};
  return {
      [x, y](Point p) { return x.value(p.x) * y.value(p.y); },
      [x, y](Point p) {
        return Vector{x.slope(p.x) * y.value(p.y), x.value(p.x) * y.slope(p.y)};
      },
      [x, y, a, c, speed](Point p) {
        const double u = x.value(p.x) * y.value(p.y);
        return speed * y.value(p.y) - a * x.value(p.x) * y.bend(p.y) + c * u;
      },
      {},
  };
}

/// The angle in (-pi / 4, 7 pi / 4]: its jump lies in the missing quadrant.
double corner_angle(Point p) {
  const double theta = std::atan2(p.y, p.x);
  return theta < -kPi / 4 ? theta + 2 * kPi : theta;
}

/// Signed distance to a front, its gradient and Laplacian.
struct Distance {
  double value;
  Vector gradient;
  double laplacian;
};

Distance distance_to(const Front& front, Point p) {
  const Vector d = p - front.point;
  if (front.radius == 0) {
    const Vector normal{std::cos(front.angle), std::sin(front.angle)};
    return {dot(d, normal), normal, 0};
  }
  const double r = norm(d);
  if (r == 0) return {-front.radius, {}, 0};
  return {r - front.radius, (1 / r) * d, 1 / r};
}

/// 1 - tanh^2 s without cancellation.
double tanh_slope(double s) {
  const double c = std::exp(-std::abs(s)), q = 2 * c / (1 + c * c);
  return q * q;
}

}  // namespace

ExactSolution product_layer(double diffusion, double reaction) {
  const Layer g{std::sqrt(diffusion / reaction)};
  const double g0 = g.square(), g1 = g.slope_energy();
  return {
      [g](Point p) { return g.value(p.x) * g.value(p.y); },
      [g](Point p) {
        return Vector{g.slope(p.x) * g.value(p.y), g.value(p.x) * g.slope(p.y)};
      },
      // -eps^2 g'' + g = 1 in each variable.
      [g, reaction](Point p) {
        const double x = g.value(p.x), y = g.value(p.y);
        return reaction * (x + y - x * y);
      },
      reaction * (2 * g0 * g1 + g0 * g0),
  };
}

ExactSolution sine_product(double diffusion, double reaction) {
  const double factor = 2 * kPi * kPi * diffusion + reaction;
  return {
      [](Point p) { return std::sin(kPi * p.x) * std::sin(kPi * p.y); },
      [](Point p) {
        return kPi * Vector{std::cos(kPi * p.x) * std::sin(kPi * p.y),
                            std::sin(kPi * p.x) * std::cos(kPi * p.y)};
      },
      [factor](Point p) { return factor * std::sin(kPi * p.x) * std::sin(kPi * p.y); },
      factor / 4,
  };
}

ExactSolution corner_singularity(double diffusion, double reaction) {
  const auto value = [](Point p) {
    return std::pow(squared_norm(p), 1. / 3) * std::sin(2. / 3 * corner_angle(p));
  };
  ExactSolution exact;
  exact.value = value;
  // u = Im z^(2/3): grad u = (Im, Re) of 2/3 z^(-1/3).
  exact.gradient = [](Point p) {
    if (p == Point{}) return Vector{};
    const double size = 2. / 3 * std::pow(squared_norm(p), -1. / 6), t = corner_angle(p) / 3;
    return size * Vector{-std::sin(t), std::cos(t)};
  };
  exact.source = [value, reaction](Point p) { return reaction * value(p); };
  // FE.md 3.1.
  if (reaction == 0) exact.squared_energy = diffusion * 1.836226661875162634;
  return exact;
}

ExactSolution exponential_layer(double diffusion, double reaction, double speed) {
  return outflow_times(Sine{}, diffusion, reaction, speed);
}

ExactSolution parabolic_layers(double diffusion, double reaction, double speed) {
  return outflow_times(Layer{std::sqrt(diffusion / speed)}, diffusion, reaction, speed);
}

ExactSolution internal_front(double diffusion, double reaction, const Front& front) {
  return {
      [front](Point p) { return std::tanh(distance_to(front, p).value / front.width); },
      [front](Point p) {
        const Distance d = distance_to(front, p);
        return tanh_slope(d.value / front.width) / front.width * d.gradient;
      },
      [front, diffusion, reaction](Point p) {
        const Distance d = distance_to(front, p);
        const double s = d.value / front.width, u = std::tanh(s);
        const double laplacian = tanh_slope(s) / front.width *
                                 (d.laplacian - 2 * u * squared_norm(d.gradient) / front.width);
        return -diffusion * laplacian + reaction * u;
      },
      {},
  };
}

}  // namespace anisofront
