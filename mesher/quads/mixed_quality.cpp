#include "mesher/quads/mixed_quality.hpp"

#include <algorithm>
#include <array>

#include "mesher/geometry/predicates.hpp"
#include "mesher/metric/metric_length.hpp"
#include "mesher/metric/quality.hpp"
#include "mesher/quads/convexity.hpp"

namespace anisofront {

bool is_strictly_convex(const MixedMesh& mesh, const MixedFace& face) {
  const auto p = [&](int k) { return mesh.vertices[face.vertices[k]].p; };
  return face.is_quad() ? is_convex_quad({p(0), p(1), p(2), p(3)})
                        : orientation(p(0), p(1), p(2)) > 0;
}

double shape_quality(const MixedMesh& mesh, const MixedFace& face) {
  const auto v = [&](int k) -> const WorkVertex& { return mesh.vertices[face.vertices[k]]; };
  if (!face.is_quad()) return least_alpha(v(0), v(1), v(2));
  return beta(std::array{v(0).r, v(1).r, v(2).r, v(3).r},
              std::array{v(0).p, v(1).p, v(2).p, v(3).p});
}

double combined_quality(const MixedMesh& mesh, const MixedFace& face) {
  std::array<double, 4> lengths{};
  const int size = face.size();
  for (int k = 0; k < size; ++k) {
    const WorkVertex& a = mesh.vertices[face.vertices[k]];
    const WorkVertex& b = mesh.vertices[face.vertices[k + 1 < size ? k + 1 : 0]];
    const Vector u = b.p - a.p;
    lengths[k] = trapezoid_length(squared_length(a.r, u), squared_length(b.r, u));  // A12
  }
  return mu(shape_quality(mesh, face), {lengths.data(), static_cast<std::size_t>(size)});
}

void Shape::add(const MixedMesh& mesh, const MixedFace& face, FaceQuality quality) {
  const double q = is_strictly_convex(mesh, face) ? quality(mesh, face) : -1;
  if (q <= 0) {
    ++broken;
    return;
  }
  product *= q;
  worst = std::min(worst, q);
}

}  // namespace anisofront
