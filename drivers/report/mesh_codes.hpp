#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/report/mesh_walk.hpp"

namespace anisofront {

// Numbers of a mesh blob: values become integer codes on a scale, codes become small residuals
// against what was expected from the codes before, residuals become bytes.

using Codes = std::vector<std::int64_t>;

/// A code that stands for no number (NaN, infinity).
inline constexpr std::int64_t kNoNumberCode = 1 << 30;
/// A code that stands for 0 on a logarithmic scale.
inline constexpr std::int64_t kZeroCode = -(1 << 30);

/// value = code * step, or 2^(code * step). Between two codes the one nearer to 0 is taken, with
/// some slack, so that a bound which lies there belongs to the codes below it.
struct CodeScale {
  bool logarithmic = false;
  double step = 1;
};

/// For values of which nothing is known: logarithmic to 0.07 % where all are positive and a tenth
/// of them lies below a thousandth of the largest, or where `positive` says that ratios count;
/// else linear to 2^-12 of the largest size.
CodeScale scale_for(std::span<const double> values, bool ratios_count);

Codes codes_of(std::span<const double> values, CodeScale scale);

/// Residuals in the order of the walk; `codes` holds one per vertex.
Codes after_neighbours(const Codes& codes, const std::vector<VertexGuess>& walk);
/// Differences to the code before, the first to 0.
Codes after_previous(const Codes& codes);

/// The numbers 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ...: their lowest bytes, then their second
/// bytes and so on, as many times as the largest needs, at least once.
/// Precondition: sizes below 2^31.
std::vector<std::string> byte_planes(const Codes& residuals);

}  // namespace anisofront
