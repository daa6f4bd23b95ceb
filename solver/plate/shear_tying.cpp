#include "solver/plate/shear_tying.hpp"

#include <array>

#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

constexpr std::array<Vector, 3> kTriangleCorners{{{0, 0}, {1, 0}, {0, 1}}};
constexpr std::array<Vector, 4> kSquareCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

template <std::size_t N>
std::vector<TieSample> ties_along(const std::array<Vector, N>& corners) {
  std::vector<TieSample> samples;
  for (std::size_t k = 0; k < N; ++k)
    for (const auto& [t, weight] : edge_quadrature(3)) {
      const Vector along = corners[(k + 1) % N] - corners[k], p = corners[k] + t * along;
      samples.push_back({static_cast<int>(samples.size()), {p.x, p.y}, along});
    }
  return samples;
}

}  // namespace

std::vector<TieSample> edge_ties(Shape shape) {
  return shape == Shape::triangle ? ties_along(kTriangleCorners) : ties_along(kSquareCorners);
}

std::vector<TieSample> mean_ties(Shape shape, int first) {
  std::vector<TieSample> samples;
  for (const auto& [at, weight] : reference_quadrature(shape, shape == Shape::triangle ? 4 : 5)) {
    samples.push_back({first, at, {weight, 0}});
    samples.push_back({first + 1, at, {0, weight}});
  }
  return samples;
}

std::vector<TieSample> edge_and_mean_ties(Shape shape) {
  std::vector<TieSample> samples = edge_ties(shape);
  const auto means = mean_ties(shape, static_cast<int>(samples.size()));
  samples.insert(samples.end(), means.begin(), means.end());
  return samples;
}

}  // namespace anisofront
