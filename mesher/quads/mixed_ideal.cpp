#include "mesher/quads/mixed_ideal.hpp"

#include "mesher/front/paper_formation.hpp"

namespace anisofront {
namespace {

/// The mean of ideal places.
struct Centroid {
  Point sum{0, 0};
  int count = 0;
  void add(Point p) {
    sum = sum + p;
    ++count;
  }
  Point mean() const { return (1. / count) * sum; }
};

/// p moved along the line from q until it has the wanted distance from q.
Point at_distance(const BackgroundMesh& background, const WorkVertex& q, const WorkVertex& p,
                  double distance) {
  return q.p + (distance / paper_length(background, q, p)) * (p.p - q.p);
}

/// The end of ab when ab is made a unit long and turned about a in the metric of a.
Point turned(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b,
             double cosine, double sine) {
  return a.p +
         (1 / paper_length(background, a, b)) * rotate(metric_of(a.r), b.p - a.p, cosine, sine);
}

}  // namespace

Point ideal_place_by_lengths(const BackgroundMesh& background, const MixedMesh& mesh, Index v,
                             std::span<const Corner> corners) {
  constexpr double kSqrt2 = 1.4142135623730951;
  const WorkVertex& p = mesh.vertices[v];
  Centroid ideal;
  for (const auto& [f, k] : corners) {
    const MixedFace& face = mesh.faces[f];
    const WorkVertex& q = mesh.vertices[vertex_at(face, k + 1)];
    ideal.add(at_distance(background, q, p, 1));  // Eqn 25a
    if (!face.is_quad()) continue;
    const WorkVertex& t = mesh.vertices[vertex_at(face, k + 2)];
    ideal.add(at_distance(background, t, p, kSqrt2));  // Eqn 25b
  }
  return ideal.mean();
}

Point ideal_place_by_shapes(const BackgroundMesh& background, const MixedMesh& mesh, Index,
                            std::span<const Corner> corners) {
  constexpr double kHalfSqrt3 = 0.86602540378443865;
  Centroid ideal;
  for (const auto& [f, k] : corners) {
    const MixedFace& face = mesh.faces[f];
    const WorkVertex& q = mesh.vertices[vertex_at(face, k + 1)];
    const WorkVertex& t = mesh.vertices[vertex_at(face, k + 2)];
    if (!face.is_quad()) {
      ideal.add(turned(background, q, t, 0.5, kHalfSqrt3));  // Eqn 26
      continue;
    }
    const WorkVertex& g = mesh.vertices[vertex_at(face, k + 3)];
    const Point p1 = turned(background, q, t, 0, 1);   // Eqn 27b
    const Point p2 = turned(background, g, t, 0, -1);  // Eqn 27c
    ideal.add(0.5 * (p1 + p2));                        // Eqn 27a
  }
  return ideal.mean();
}

}  // namespace anisofront
