#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/solver/square_mesh.hpp"

namespace anisofront::acceptance {

/// Lines 0 = x_0 < ... < x_n = length for a function with a layer e^(-x/width) at 0 (Bakhvalov's
/// idea, smooth): about half of the intervals lie in the layer, there growing like e^(x/(3 width)),
/// which is what elements of second degree need to have equal errors.
inline std::vector<double> layer_lines(Index n, double length, double width) {
  const double reach = 3 * width, full = -std::expm1(-length / reach);
  const auto share = [&](double x) {
    return 0.5 * x / length - 0.5 * std::expm1(-x / reach) / full;
  };
  std::vector<double> lines{0};
  for (Index i = 1; i < n; ++i) {
    double low = lines.back(), high = length;
    for (int step = 0; step < 100; ++step) {
      const double middle = 0.5 * (low + high);
      (share(middle) < static_cast<double>(i) / n ? low : high) = middle;
    }
    lines.push_back(high);
  }
  lines.push_back(length);
  return lines;
}

/// Width of the layer at a soft or free edge: t / sqrt(12 k).
inline double plate_layer(double thickness) { return thickness / std::sqrt(10.); }

/// Sizes across a side: `least` at the side, growing by `growth` per distance up to `most`; the
/// stretch of elements is bounded by `stretch`.
struct LayerSizes {
  double least = 0, growth = 0.4, most = 0.06, stretch = 100;

  double at(double distance) const { return std::min(most, least + growth * distance); }
};

/// Lines from 0 to `length` with about these sizes.
inline std::vector<double> size_lines(const LayerSizes& sizes, double length) {
  std::vector<double> lines{0};
  while (lines.back() < length) lines.push_back(lines.back() + sizes.at(lines.back()));
  const double scale = length / lines.back();
  for (double& x : lines) x *= scale;
  return lines;
}

/// n equal intervals.
inline std::vector<double> equal_lines(Index n, double length) {
  std::vector<double> lines;
  for (Index i = 0; i <= n; ++i) lines.push_back(length * i / n);
  return lines;
}

/// Columns between the x lines, rows between the y lines; `mesh` is one of square_mesh(),
/// square_quads(), mixed_square() with as many cells.
inline Mesh on_lines(Mesh mesh, const std::vector<double>& x, const std::vector<double>& y) {
  return test::mapped(std::move(mesh), [&](Point p) {
    const auto index = [](double s, const std::vector<double>& lines) {
      return static_cast<std::size_t>(std::lround(s * static_cast<double>(lines.size() - 1)));
    };
    return Point{x[index(p.x, x)], y[index(p.y, y)]};
  });
}

inline Index intervals(const std::vector<double>& lines) {
  return static_cast<Index>(lines.size()) - 1;
}

inline Mesh quads_on(const std::vector<double>& x, const std::vector<double>& y) {
  return on_lines(test::square_quads(intervals(x), intervals(y)), x, y);
}
inline Mesh triangles_on(const std::vector<double>& x, const std::vector<double>& y) {
  return on_lines(test::square_mesh(intervals(x), intervals(y)), x, y);
}
inline Mesh mixed_on(const std::vector<double>& x, const std::vector<double>& y) {
  return on_lines(test::mixed_square(intervals(x), intervals(y)), x, y);
}

}  // namespace anisofront::acceptance
