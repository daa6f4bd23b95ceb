#pragma once

#include <array>
#include <vector>

#include "adapt/flux.hpp"
#include "adapt/patch_fit.hpp"

namespace anisofront {

/// Stresses recovered by polynomials fitted to the samples around each vertex (superconvergent
/// patch recovery, Zienkiewicz and Zhu 1992) and blended in the elements: f*(x) = sum_i L_i(x)
/// p_i(x) with the (bi)linear corner functions L_i.
/// Patches are normalised by the root of their covariance, hold elements of one region only (at an
/// interface a vertex has one polynomial per region; so it has on the two sides of edges marked in
/// FluxSamples::jumps), and count all their elements alike. Where the patch does not close around
/// its vertex, linear polynomials are those of the nearest interior vertices, averaged (interior-
/// patch rule), quadratic ones are fitted to a patch grown by another ring that counts less
/// (measured, see the .cpp). Patches whose samples do not determine the polynomial grow by further
/// rings; where that does not help (a mesh of a few elements) the degree falls.
/// Laws: polynomials of the fit degree are recovered exactly; affine maps of the mesh commute; the
/// result does not depend on the number of threads.
class RecoveredFlux {
 public:
  RecoveredFlux(const FeMesh& mesh, const FluxSamples& samples);

  int components() const { return components_; }
  /// f* at a point x of an element whose corner functions there are `weights` (sum 1).
  void evaluate(const Element& element, Point x, const std::array<double, 4>& weights,
                double* result) const;
  /// Values at the vertices, `components` each; at interfaces the mean over the regions.
  const std::vector<double>& vertex_values() const { return vertex_values_; }

 private:
  void set_vertex_values(const FeMesh& mesh, const std::vector<Index>& patch_vertices);

  int components_ = 0;
  PatchPolynomials polynomials_;
  std::vector<std::array<Index, 4>> patch_at_corner_;  ///< per element
  std::vector<double> vertex_values_;
};

/// The (bi)linear functions of the corners at a reference point.
std::array<double, 4> corner_functions(Shape shape, ReferencePoint at);

}  // namespace anisofront
