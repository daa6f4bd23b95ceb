#include "mesher/quads/mixed_quality.hpp"

#include <algorithm>

#include "mesher/geometry/predicates.hpp"
#include "mesher/metric/quality.hpp"

namespace anisofront {

bool is_strictly_convex(const MixedMesh& mesh, const MixedFace& face) {
  const auto p = [&](int k) { return mesh.vertices[face.vertices[k]].p; };
  if (!face.is_quad()) return orientation(p(0), p(1), p(2)) > 0;
  return orientation(p(3), p(0), p(1)) > 0 && orientation(p(0), p(1), p(2)) > 0 &&
         orientation(p(1), p(2), p(3)) > 0 && orientation(p(2), p(3), p(0)) > 0;
}

double shape_quality(const MixedMesh& mesh, const MixedFace& face) {
  const auto v = [&](int k) -> const WorkVertex& { return mesh.vertices[face.vertices[k]]; };
  if (!face.is_quad()) return least_alpha(v(0), v(1), v(2));
  return beta(std::array{v(0).r, v(1).r, v(2).r, v(3).r},
              std::array{v(0).p, v(1).p, v(2).p, v(3).p});
}

void Shape::add(const MixedMesh& mesh, const MixedFace& face) {
  const double quality = is_strictly_convex(mesh, face) ? shape_quality(mesh, face) : -1;
  if (quality <= 0) {
    ++broken;
    return;
  }
  product *= quality;
  worst = std::min(worst, quality);
}

}  // namespace anisofront
