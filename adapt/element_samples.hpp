#pragma once

#include "adapt/flux.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {

/// A point of an element with the sample whose computed stresses hold there.
struct SampledPoint {
  ReferencePoint at;
  Point x;
  Index sample;
};

/// body(weight, point) over an element, to integrate products of recovered and computed stresses:
/// at its samples, and where a single one stands for a triangle, in which the computed stresses are
/// constant and the recovered ones are not, at points that integrate blended linear polynomials
/// exactly.
template <class Body>
void for_each_sampled_point(const FluxSamples& samples, const Element& element, const Body& body) {
  constexpr int kBlendDegree = 4;
  const Index first = samples.first[element.number], end = samples.first[element.number + 1];
  if (end - first == 1 && element.shape == Shape::triangle) {
    for (const auto& [at, weight] : reference_quadrature(element.shape, kBlendDegree))
      body(2 * weight * samples.weights[first], SampledPoint{at, map_at(element, at).x, first});
    return;
  }
  for (Index s = first; s < end; ++s)
    body(samples.weights[s], SampledPoint{samples.at[s], samples.points[s], s});
}

}  // namespace anisofront
