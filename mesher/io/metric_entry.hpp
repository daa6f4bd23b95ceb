#pragma once

#include "mesher/metric/metric.hpp"

namespace anisofront {

/// nullptr for a finite positive definite tensor, else what is wrong with it. The test
/// |m12| < sqrt(m11) sqrt(m22) neither overflows nor underflows as the determinant would.
inline const char* metric_defect(const Metric& m) {
  if (!std::isfinite(m.m11) || !std::isfinite(m.m12) || !std::isfinite(m.m22))
    return "is not finite";
  if (!(m.m11 > 0 && m.m22 > 0 && std::fabs(m.m12) < std::sqrt(m.m11) * std::sqrt(m.m22)))
    return "is not positive definite";
  return nullptr;
}

/// The isotropic metric of size h, M = I/h^2.
inline Metric metric_of_size(double h) {
  const double m = 1 / (h * h);
  return {m, 0, m};
}

/// nullptr for a usable size, else what is wrong with it.
inline const char* size_defect(double h) {
  if (!std::isfinite(h)) return "is not finite";
  if (!(h > 0)) return "is not positive";
  return metric_defect(metric_of_size(h)) ? "is too large or too small to be squared" : nullptr;
}

}  // namespace anisofront
