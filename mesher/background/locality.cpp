#include "mesher/background/locality.hpp"

#include <algorithm>
#include <array>

namespace anisofront {
namespace {

/// Inserts a zero bit after each of the 16 low bits.
std::uint32_t spread_bits(std::uint32_t v) {
  v = (v | v << 8) & 0x00ff00ffu;
  v = (v | v << 4) & 0x0f0f0f0fu;
  v = (v | v << 2) & 0x33333333u;
  return (v | v << 1) & 0x55555555u;
}

struct KeyedIndex {
  std::uint32_t key;
  Index index;
};

/// One stable pass of a radix sort on 11 bits.
void radix_pass(const std::vector<KeyedIndex>& from, std::vector<KeyedIndex>& to, int shift) {
  std::array<std::size_t, 2049> start{};
  for (const KeyedIndex& k : from) ++start[((k.key >> shift) & 2047u) + 1];
  for (std::size_t i = 0; i < 2048; ++i) start[i + 1] += start[i];
  for (const KeyedIndex& k : from) to[start[(k.key >> shift) & 2047u]++] = k;
}

}  // namespace

std::vector<Index> spatial_order(const std::vector<Point>& points, Point low, Point high) {
  const double scale = 65535 / std::max({high.x - low.x, high.y - low.y, 1e-300});
  std::vector<KeyedIndex> keys(points.size()), buffer(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto ix = static_cast<std::uint32_t>((points[i].x - low.x) * scale);
    const auto iy = static_cast<std::uint32_t>((points[i].y - low.y) * scale);
    keys[i] = {spread_bits(ix) | spread_bits(iy) << 1, static_cast<Index>(i)};
  }
  for (const int shift : {0, 11, 22}) {
    radix_pass(keys, buffer, shift);
    keys.swap(buffer);
  }
  std::vector<Index> order(points.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](const KeyedIndex& k) { return k.index; });
  return order;
}

std::vector<Index> inverse_permutation(const std::vector<Index>& order) {
  std::vector<Index> inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) inverse[order[i]] = static_cast<Index>(i);
  return inverse;
}

}  // namespace anisofront
