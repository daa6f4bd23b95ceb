#include "mesher/front/boundary_validity.hpp"

#include <algorithm>

#include "mesher/background/alternating_digital_tree.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

struct Ends {
  Point a, b;
};

Ends ends_of(const WorkMesh& mesh, Index segment) {
  const Segment& s = mesh.segments[segment];
  return {mesh.vertices[s.a].p, mesh.vertices[s.b].p};
}

Box box_of(const Ends& e) {
  return {{std::min(e.a.x, e.b.x), std::min(e.a.y, e.b.y)},
          {std::max(e.a.x, e.b.x), std::max(e.a.y, e.b.y)}};
}

/// Whether p, known to lie on the line of the segment, lies on the closed segment.
bool covers(const Ends& e, Point p) { return overlap(box_of(e), {p, p}); }

Point crossing_point(const Ends& e, const Ends& f) {
  const Vector u = e.b - e.a, v = f.b - f.a;
  const double det = cross(u, v);
  return det == 0 ? 0.5 * (e.a + e.b) : e.a + (cross(f.a - e.a, v) / det) * u;
}

std::optional<Point> meet_apart(const Ends& e, const Ends& f) {
  const int fa = orientation(e.a, e.b, f.a), fb = orientation(e.a, e.b, f.b);
  const int ea = orientation(f.a, f.b, e.a), eb = orientation(f.a, f.b, e.b);
  if (fa * fb < 0 && ea * eb < 0) return crossing_point(e, f);
  if (fa == 0 && covers(e, f.a)) return f.a;
  if (fb == 0 && covers(e, f.b)) return f.b;
  if (ea == 0 && covers(f, e.a)) return e.a;
  if (eb == 0 && covers(f, e.b)) return e.b;
  return std::nullopt;
}

std::optional<Point> meeting_place(const WorkMesh& mesh, Index i, Index j) {
  const Segment &s = mesh.segments[i], &t = mesh.segments[j];
  const Ends e = ends_of(mesh, i), f = ends_of(mesh, j);
  const bool aa = s.a == t.a, ab = s.a == t.b, ba = s.b == t.a, bb = s.b == t.b;
  const int common = aa + ab + ba + bb;
  if (common == 0) return meet_apart(e, f);
  if (common > 1) return 0.5 * (e.a + e.b);
  const Point shared = aa || ab ? e.a : e.b;
  const Point p = aa || ab ? e.b : e.a;
  const Point q = aa || ba ? f.b : f.a;
  if (orientation(shared, p, q) == 0 && dot(p - shared, q - shared) > 0) return shared;
  return std::nullopt;
}

AlternatingDigitalTree segment_tree(const WorkMesh& mesh) {
  Box bounds{mesh.vertices.front().p, mesh.vertices.front().p};
  for (const WorkVertex& v : mesh.vertices) bounds = enclosing(bounds, v.p);
  AlternatingDigitalTree tree(bounds);
  tree.reserve(mesh.segments.size());
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
    tree.insert(box_of(ends_of(mesh, static_cast<Index>(i))));
  return tree;
}

Point nearest_on(const Ends& e, Point p) {
  const Vector u = e.b - e.a;
  return lerp(e.a, e.b, std::clamp(dot(p - e.a, u) / squared_norm(u), 0., 1.));
}

}  // namespace

std::vector<SegmentConflict> find_conflicts(const WorkMesh& mesh) {
  const AlternatingDigitalTree tree = segment_tree(mesh);
  std::vector<SegmentConflict> conflicts;
  for (Index i = 0; i < static_cast<Index>(mesh.segments.size()); ++i) {
    tree.query(box_of(ends_of(mesh, i)), [&](Index j) {
      if (j <= i) return;
      if (const auto place = meeting_place(mesh, i, j)) conflicts.push_back({i, j, *place});
    });
  }
  return conflicts;
}

std::optional<SegmentConflict> find_narrow_gap(const WorkMesh& mesh, double distance) {
  const AlternatingDigitalTree tree = segment_tree(mesh);
  std::optional<SegmentConflict> gap;
  for (Index i = 0; i < static_cast<Index>(mesh.segments.size()) && !gap; ++i) {
    const Segment& s = mesh.segments[i];
    const WorkVertex& vertex = mesh.vertices[s.a];  // most vertices start one segment
    const MetricFactor& r = vertex.r;
    const Vector half{distance * std::sqrt(r.b * r.b + r.c * r.c) / (r.a * r.c), distance / r.c};
    tree.query({vertex.p - half, vertex.p + half}, [&](Index j) {
      const Segment& t = mesh.segments[j];
      if (gap || t.a == s.a || t.a == s.b || t.b == s.a || t.b == s.b) return;
      const Point near = nearest_on(ends_of(mesh, j), vertex.p);
      if (length(r, near - vertex.p) < distance) gap = SegmentConflict{i, j, vertex.p};
    });
  }
  return gap;
}

bool is_inside(const WorkMesh& mesh, const std::vector<Index>& segments, Point p) {
  bool inside = false;
  for (const Index id : segments) {
    Ends e = ends_of(mesh, id);
    if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
    if (e.a.y > e.b.y) std::swap(e.a, e.b);
    if (orientation(e.a, e.b, p) > 0) inside = !inside;
  }
  return inside;
}

}  // namespace anisofront
