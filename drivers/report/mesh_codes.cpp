#include "drivers/report/mesh_codes.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

bool spans_decades(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto tenth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 10);
  std::nth_element(sorted.begin(), tenth, sorted.end());
  return *tenth < 1e-3 * *std::max_element(sorted.begin(), sorted.end());
}

std::int64_t nearest_code(double position) {
  constexpr double kSlack = 1e-9;
  return std::llround(std::copysign(std::ceil(std::fabs(position) - 0.5 - kSlack), position));
}

std::int64_t code_of(double value, CodeScale scale) {
  if (!std::isfinite(value)) return kNoNumberCode;
  if (!scale.logarithmic) return nearest_code(value / scale.step);
  return value > 0 ? nearest_code(std::log2(value) / scale.step) : kZeroCode;
}

/// What a guess makes of a code.
std::int64_t as_number(std::int64_t code) {
  return code == kNoNumberCode || code == kZeroCode ? 0 : code;
}

}  // namespace

CodeScale scale_for(std::span<const double> values, bool ratios_count) {
  constexpr double kFineRatio = 1. / 512;
  constexpr int kBits = 12;
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double value) { return std::isfinite(value); });
  if (finite.empty()) return {};
  const auto [least, most] = std::minmax_element(finite.begin(), finite.end());
  const double size = std::max(-*least, *most);
  if (*least >= 0 && size > 0 && (ratios_count || (*least > 0 && spans_decades(finite))))
    return {true, kFineRatio};
  int exponent = kBits;
  if (size > 0) std::frexp(size, &exponent);
  return {false, std::ldexp(1, exponent - kBits)};
}

Codes codes_of(std::span<const double> values, CodeScale scale) {
  Codes codes(values.size());
  std::transform(values.begin(), values.end(), codes.begin(),
                 [&](double value) { return code_of(value, scale); });
  return codes;
}

Codes after_neighbours(const Codes& codes, const std::vector<VertexGuess>& walk) {
  Codes residuals;
  residuals.reserve(walk.size());
  for (const VertexGuess& guess : walk) {
    const auto known = [&](int i) {
      return guess.from[i] == kNoIndex ? 0 : as_number(codes[guess.from[i]]);
    };
    const std::int64_t twice =
        guess.weight * known(0) + (4 - guess.weight) * known(1) - known(2) - known(3);
    residuals.push_back(codes[guess.vertex] - ((twice + 1) >> 1));
  }
  return residuals;
}

Codes after_previous(const Codes& codes) {
  Codes residuals(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
    residuals[i] = codes[i] - (i == 0 ? 0 : as_number(codes[i - 1]));
  return residuals;
}

std::vector<std::string> byte_planes(const Codes& residuals) {
  std::vector<std::uint64_t> folded(residuals.size());
  std::transform(residuals.begin(), residuals.end(), folded.begin(), [](std::int64_t r) {
    return static_cast<std::uint64_t>(r < 0 ? -2 * r - 1 : 2 * r);
  });
  const std::uint64_t most = folded.empty() ? 0 : *std::max_element(folded.begin(), folded.end());
  std::vector<std::string> planes;
  for (int shift = 0; shift == 0 || most >> shift != 0; shift += 8) {
    std::string& plane = planes.emplace_back();
    for (const std::uint64_t value : folded)
      plane += static_cast<char>(static_cast<unsigned char>(value >> shift & 0xff));
  }
  return planes;
}

}  // namespace anisofront
