#include "mesher/enhance/paper_smooth.hpp"

#include "mesher/front/ideal_point.hpp"
#include "mesher/front/paper_formation.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

/// Product of alpha~ (Eqn 15) around the vertex placed at x; negative when a triangle turns over.
double product_of_alphas(const Patch& patch, const Ring& ring, const WorkVertex& x) {
  double product = 1;
  for (int i = 0; i < ring.size; ++i) {
    const WorkVertex &y = patch.vertex(ring.vertices[i]), &z = patch.vertex(ring.vertices[i + 1]);
    if (orientation(x.p, y.p, z.p) <= 0) return -1;
    product *= least_alpha(x, y, z);
  }
  return product;
}

/// Moves vertex v to p, taking the metric there from the background, if the product grows.
void move_if_better(Patch& patch, const Ring& ring, Index v, Point p) {
  const WorkVertex& x = patch.vertex(v);
  WorkVertex y{p, {}, x.hint};
  y.r = patch.background.factor_at(p, y.hint);
  if (product_of_alphas(patch, ring, y) <= product_of_alphas(patch, ring, x)) return;
  patch.mesh.vertices[v] = y;
  ++patch.statistics.moves;
  for (int i = 0; i < ring.size; ++i) patch.update_alpha(ring.triangles[i]);
}

/// Moves each interior vertex towards the mean of ideal(vertex, ring, i) over its ring.
template <class Ideal>
void smooth(Patch& patch, Ideal&& ideal) {
  Ring ring;
  for (Index v = 0; v < static_cast<Index>(patch.mesh.vertices.size()); ++v) {
    if (patch.fixed[v] || patch.triangle_of[v] == kNoIndex || !closed_ring(patch, v, ring))
      continue;
    Point sum{0, 0};
    for (int i = 0; i < ring.size; ++i) sum = sum + ideal(patch.vertex(v), ring, i);
    move_if_better(patch, ring, v, (1. / ring.size) * sum);
  }
}

}  // namespace

void paper_length_smoothing(Patch& patch) {
  smooth(patch, [&](const WorkVertex& p, const Ring& ring, int i) {
    const WorkVertex& q = patch.vertex(ring.vertices[i]);
    return q.p + (1 / paper_length(patch.background, q, p)) * (p.p - q.p);  // Eqn 25a
  });
}

void paper_quality_smoothing(Patch& patch) {
  smooth(patch, [&](const WorkVertex&, const Ring& ring, int i) {
    const WorkVertex &g = patch.vertex(ring.vertices[i]), &h = patch.vertex(ring.vertices[i + 1]);
    // Eqn 26: GH turned by 60 degrees in the metric of G. It has unit length in the metric of G
    // first, and is scaled to the Appendix B length that the equation divides by.
    const Point unit = offset_from_a(metric_of(g.r), g.p, h.p);
    const double scale = length(g.r, h.p - g.p) / paper_length(patch.background, g, h);
    return g.p + scale * (unit - g.p);
  });
}

}  // namespace anisofront
