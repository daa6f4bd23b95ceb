// O. C. Zienkiewicz, J. Z. Zhu, The superconvergent patch recovery and a posteriori error
// estimates, Int. J. Numer. Meth. Engng 33 (1992) 1331-1382, doi:10.1002/nme.1620330702 and
// doi:10.1002/nme.1620330703.
//
// At the boundary own patches see one row of elements only, in which the curvature across is hardly
// determined; continued from the inside, quadratics blow up where sizes jump (linear ones do not);
// with a second ring there are two rows. Effectivity measured
//   on Shishkin meshes of n x n cells (P1, P2: reaction-diffusion, eps = .01, n = 64; MITC: plate
//   on soft supports, t = .01, n = 8 and 32) and on adapted meshes (cycles 3 to 5):
//                            P1    P2     MITC7       MITC9        P2 adapted  MITC7 adapted
//   own patch                .76   .79  .79 to .90  1.28 to 1.00  .81 .92 .99   .80 .91 .97
//   interior-patch rule      .90   .92  4.2 to .98    12 to .99   .99 1.03 1.14 .90 .99 1.00
//   ring, elements alike     .86   .90  .86 to .97  1.28 to 1.00  1.12 1.18 1.08 .88 .98 1.01
//   ring counts a third            .90  .84 to .96  1.18 to .98   1.01 1.06 1.05 .87 .97 .99
#include "adapt/recovery.hpp"

#include <algorithm>

#include "adapt/element_loop.hpp"
#include "adapt/fit_samples.hpp"
#include "adapt/flux_patches.hpp"
#include "solver/space/basis.hpp"

namespace anisofront {
namespace {

/// Rings in which interior patches are looked for, and by which patches grow.
constexpr int kMaxRings = 3;
/// What an element of the rings around a patch counts against one of the patch.
constexpr double kOuterWeight = 1. / 3;

struct Recovery {
  const FeMesh& mesh;
  const FluxSamples& samples;
  FluxPatches patches;

  std::span<const Index> elements_of(Index p) const {
    return std::span(patches.elements)
        .subspan(patches.first[p], patches.first[p + 1] - patches.first[p]);
  }
};

PatchFrame frame_of(const Recovery& r, Index p, std::span<const Index> elements) {
  const Point near = r.mesh.mesh.points[r.patches.vertex[p]];
  PatchMoments moments;
  for (const Index e : elements) {
    const Element element = element_at(r.mesh, e);
    for (int k = 0; k < element.corners; ++k) moments.add(element.nodes[k] - near);
  }
  return patch_frame(near, moments);
}

/// Within the patch all elements count alike: by area, the large ones next to a layer would drown
/// the thin ones.
PatchFit fit_of(const Recovery& r, Index p, std::span<const Index> elements) {
  const auto own = r.elements_of(p);
  const auto weight_of = [&](Index e) {
    const bool is_own = elements.size() == own.size() || std::ranges::binary_search(own, e);
    return is_own ? 1 : kOuterWeight;
  };
  PatchFit fit(frame_of(r, p, elements), r.samples.degree, r.samples.components);
  FitSamples samples;
  for (const Index e : elements) {
    collect_fit_samples(r.samples, element_at(r.mesh, e), samples);
    const double weight = weight_of(e);
    for (int i = 0; i < samples.count; ++i)
      fit.add(samples.points[i], weight * samples.weights[i], samples.values[i].data());
  }
  return fit;
}

/// Of the patch grown by `rings`, and by more until it determines all terms.
PatchPolynomial fitted(const Recovery& r, Index p, int rings) {
  if (rings == 0) {
    const PatchFit fit = fit_of(r, p, r.elements_of(p));
    if (fit.is_determined()) return fit.solve();
    rings = 1;
  }
  for (; rings < kMaxRings; ++rings) {
    const PatchFit fit = fit_of(r, p, grown_patch(r.patches, p, rings));
    if (fit.is_determined()) return fit.solve();
  }
  return fit_of(r, p, grown_patch(r.patches, p, kMaxRings)).solve();
}

/// Interior patches of the corners of these elements, each once, ascending.
std::vector<Index> interior_patches(const FluxPatches& patches, std::span<const Index> elements) {
  std::vector<Index> found;
  for (const Index e : elements)
    for (const Index q : patches.at_corner[e])
      if (q != kNoIndex && patches.is_interior[q]) found.push_back(q);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Of the innermost ring that has any.
std::vector<Index> nearest_interior(const FluxPatches& patches, Index p) {
  for (int rings = 0; rings < kMaxRings; ++rings) {
    const auto found = interior_patches(patches, grown_patch(patches, p, rings));
    if (!found.empty()) return found;
  }
  return {};
}

void add(double weight, const PatchPolynomial& polynomial, PatchPolynomial& sum) {
  for (int i = 0; i < kMaxTerms; ++i)
    for (int c = 0; c < kMaxFluxComponents; ++c)
      sum.coefficients[i][c] += weight * polynomial.coefficients[i][c];
}

/// The mean of the polynomials of interior patches, in a frame of the patch itself.
PatchPolynomial mean_of(const Recovery& r, Index p, std::span<const Index> sources,
                        const PatchPolynomials& polynomials) {
  PatchPolynomial mean{frame_of(r, p, r.elements_of(p)), {}};
  for (const Index q : sources)
    add(1. / static_cast<double>(sources.size()), in_frame(mean.frame, polynomials[q]), mean);
  return mean;
}

PatchPolynomial at_boundary(const Recovery& r, Index p, const PatchPolynomials& polynomials) {
  if (r.samples.degree > 1) return fitted(r, p, 1);
  const auto sources = nearest_interior(r.patches, p);
  return sources.empty() ? fitted(r, p, 1) : mean_of(r, p, sources, polynomials);
}

PatchPolynomials recovered(const Recovery& r) {
  PatchPolynomials polynomials(r.patches.count(), r.samples.degree, r.samples.components);
  for_each_index(r.patches.count(), [&](Index p) {
    if (r.patches.is_interior[p]) polynomials.set(p, fitted(r, p, 0));
  });
  for_each_index(r.patches.count(), [&](Index p) {
    if (!r.patches.is_interior[p]) polynomials.set(p, at_boundary(r, p, polynomials));
  });
  return polynomials;
}

}  // namespace

std::array<double, 4> corner_functions(Shape shape, ReferencePoint at) {
  if (shape == Shape::quadrilateral) return bilinear_quad(at).value;
  return {1 - at.xi - at.eta, at.xi, at.eta, 0};
}

RecoveredFlux::RecoveredFlux(const FeMesh& mesh, const FluxSamples& samples)
    : components_(samples.components) {
  Recovery recovery{mesh, samples, flux_patches(mesh, samples.jumps)};
  polynomials_ = recovered(recovery);
  set_vertex_values(mesh, recovery.patches.vertex);
  patch_at_corner_ = std::move(recovery.patches.at_corner);
}

void RecoveredFlux::evaluate(const Element& element, Point x, const std::array<double, 4>& weights,
                             double* result) const {
  std::fill_n(result, components_, 0.);
  for (int k = 0; k < element.corners; ++k)
    polynomials_.add_value(patch_at_corner_[element.number][k], x, weights[k], result);
}

void RecoveredFlux::set_vertex_values(const FeMesh& mesh,
                                      const std::vector<Index>& patch_vertices) {
  const std::size_t vertices = mesh.mesh.points.size();
  std::vector<int> count(vertices, 0);
  for (const Index v : patch_vertices) ++count[v];
  vertex_values_.assign(vertices * components_, 0.);
  for (std::size_t p = 0; p < patch_vertices.size(); ++p) {
    const auto v = static_cast<std::size_t>(patch_vertices[p]);
    polynomials_.add_value(static_cast<Index>(p), mesh.mesh.points[v], 1. / count[v],
                           &vertex_values_[v * components_]);
  }
}

}  // namespace anisofront
