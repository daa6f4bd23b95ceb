#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

using ScalarFunction = std::function<double(Point)>;
using VectorFunction = std::function<Vector(Point)>;

/// A number or a function of the point. Functions are called from several threads at once and must
/// allow it.
class Coefficient {
 public:
  Coefficient(double value = 0) : value_(value) {}
  template <std::invocable<Point> Function>
  Coefficient(Function function) : function_(std::move(function)) {}

  bool is_constant() const { return !function_; }
  /// True for the constant 0.
  bool is_zero() const { return is_constant() && value_ == 0; }
  double operator()(Point p) const { return function_ ? function_(p) : value_; }

 private:
  double value_ = 0;
  ScalarFunction function_;
};

/// A coefficient that may differ between regions.
class RegionCoefficient {
 public:
  RegionCoefficient(double value = 0) : everywhere_(value) {}
  RegionCoefficient(Coefficient everywhere) : everywhere_(std::move(everywhere)) {}
  template <std::invocable<Point> Function>
  RegionCoefficient(Function function) : everywhere_(std::move(function)) {}

  /// In regions with this physical tag from now on; replaces what was set for it.
  void set(Index region, Coefficient value);

  const Coefficient& in(Index region) const;
  bool is_zero() const;
  /// Regions with a value of their own.
  const std::vector<std::pair<Index, Coefficient>>& regions() const { return regions_; }
  const Coefficient& everywhere() const { return everywhere_; }

 private:
  Coefficient everywhere_;
  std::vector<std::pair<Index, Coefficient>> regions_;
};

/// Value at p. Throws InputError "<what> is <value> at (x, y), expected a finite number".
double finite_value(const Coefficient& coefficient, Point p, const char* what);

}  // namespace anisofront
