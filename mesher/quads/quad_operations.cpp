#include "mesher/quads/quad_operations.hpp"

#include <array>

namespace anisofront {
namespace {

constexpr int kMostAround = 30;  ///< vertices with more quadrilaterals are left alone

/// Half-edges that leave a vertex, anticlockwise.
struct Fan {
  int size = 0;
  std::array<Index, kMostAround> leaving;
};

bool fan_of(const QuadMesh& mesh, Index v, Fan& fan) {
  if (mesh.valence[v] > kMostAround) return false;
  fan.size = 0;
  for_each_leaving(mesh, v, [&](Index h) { fan.leaving[fan.size++] = h; });
  return true;
}

/// Vertex v of two quadrilaterals goes, the two become one. False when that would degenerate.
bool remove_doublet(QuadWork& work, Index v) {
  QuadMesh& mesh = work.mesh;
  const Index h = mesh.leaving[v], g = anticlockwise(mesh, h);  // quads v b c d and v d e b
  const Index bc = next_in_quad(h), cd = next_in_quad(bc);
  const Index de = next_in_quad(g), eb = next_in_quad(de);
  const std::array<Index, 4> corners{mesh.corner[bc], mesh.corner[cd], mesh.corner[de],
                                     mesh.corner[eb]};
  const std::array<Index, 4> twins{mesh.twin[bc], mesh.twin[cd], mesh.twin[de], mesh.twin[eb]};
  if (is_same(mesh, corners[1], corners[3])) return false;
  const Index quad = quad_of(h);
  work.touch_quad(quad);
  work.remove_quad(quad_of(g));
  work.remove_vertex(v);
  for (int k = 0; k < 4; ++k) work.set_corner(4 * quad + k, corners[k]);
  for (int k = 0; k < 4; ++k) {
    // Two sides of the new quadrilateral may have been each other's twins.
    Index t = twins[k];
    for (int j = 0; j < 4; ++j)
      if (t == std::array<Index, 4>{bc, cd, de, eb}[j]) return false;
    work.sew(4 * quad + k, t);
  }
  for (int k = 0; k < 4; ++k) work.recount(4 * quad + k);
  return true;
}

/// Removes doublets among the vertices and those that arise from that. False: degenerate.
bool clear_doublets(QuadWork& work, std::array<Index, 8> vertices, int count) {
  QuadMesh& mesh = work.mesh;
  while (count > 0) {
    const Index v = vertices[--count];
    if (mesh.leaving[v] == kNoIndex || mesh.on_boundary(v)) continue;
    if (mesh.valence[v] < 2) return false;
    if (mesh.valence[v] > 2) continue;
    if (!mesh.is_free(v) || count + 2 > 8) return false;
    const Index b = mesh.corner[next_in_quad(mesh.leaving[v])];
    const Index d = mesh.corner[previous_in_quad(mesh.leaving[v])];
    if (!remove_doublet(work, v)) return false;
    vertices[count++] = b;
    vertices[count++] = d;
  }
  return true;
}

bool undone(QuadWork& work) {
  work.undo();
  return false;
}

/// Whether a and c, opposite in the quadrilateral of h, have neighbours in common beyond its other
/// two corners, are neighbours, or share another quadrilateral: then they must not be merged. c is
/// free, hence without copies; a, b and d may have some.
bool share_more(const QuadMesh& mesh, Index h) {
  const Index a = mesh.corner[h], c = mesh.corner[opposite_in_quad(h)];
  const Index b = mesh.corner[next_in_quad(h)], d = mesh.corner[previous_in_quad(h)];
  bool shared = false;
  for_each_leaving(mesh, c, [&](Index g) {
    if (quad_of(g) != quad_of(h) && is_same(mesh, mesh.corner[opposite_in_quad(g)], a))
      shared = true;
    const Index n = mesh.corner[next_in_quad(g)];  // every neighbour of c once
    if (is_same(mesh, n, a) || (n != b && n != d && are_adjacent(mesh, a, n))) shared = true;
  });
  return shared;
}

WorkVertex middle_of(const QuadWork& work, Index a, Index c) {
  const WorkVertex& va = work.mesh.vertices[a];
  WorkVertex middle{0.5 * (va.p + work.mesh.vertices[c].p), {}, va.hint};
  middle.r = work.background.factor_at(middle.p, middle.hint);
  return middle;
}

}  // namespace

bool collapse_diagonal(QuadWork& work, Index h) {
  QuadMesh& mesh = work.mesh;
  if (!mesh.is_free(mesh.corner[opposite_in_quad(h)])) h = opposite_in_quad(h);
  const Index ab = h, bc = next_in_quad(ab), cd = next_in_quad(bc), da = next_in_quad(cd);
  const Index a = mesh.corner[ab], b = mesh.corner[bc], c = mesh.corner[cd], d = mesh.corner[da];
  if (!mesh.is_free(c) || mesh.valence[a] + mesh.valence[c] > kMostAround) return false;
  const std::array<Index, 4> t{mesh.twin[ab], mesh.twin[bc], mesh.twin[cd], mesh.twin[da]};
  if (share_more(mesh, h)) return false;
  Fan fan;
  if (!fan_of(mesh, c, fan)) return false;
  work.begin();
  if (mesh.is_free(a)) work.move(a, middle_of(work, a, c));
  for (int i = 0; i < fan.size; ++i) {
    work.touch_quad(quad_of(fan.leaving[i]));
    work.set_corner(fan.leaving[i], a);
  }
  work.remove_quad(quad_of(h));
  work.remove_vertex(c);
  work.sew(t[1], t[0]);  // c is free, so t[1] and t[2] are no segments
  work.sew(t[2], t[3]);
  work.recount(next_in_quad(t[1]));  // b
  work.recount(t[2]);                // d
  work.recount(t[1]);                // a
  return clear_doublets(work, {b, d, a}, 3) || undone(work);
}

bool rotate_edge(QuadWork& work, Index h, int steps) {
  QuadMesh& mesh = work.mesh;
  const Index g = mesh.twin[h];
  if (g < 0 || quad_of(g) == quad_of(h)) return false;
  // The hexagon from the end of h anticlockwise.
  std::array<Index, 6> sides;
  for (int k = 0; k < 3; ++k) sides[k] = (h & ~3) | ((h + 1 + k) & 3);
  for (int k = 0; k < 3; ++k) sides[3 + k] = (g & ~3) | ((g + 1 + k) & 3);
  std::array<Index, 6> vertices, twins;
  for (int k = 0; k < 6; ++k) {
    vertices[k] = mesh.corner[sides[k]];
    twins[k] = mesh.twin[sides[k]];
    for (int j = 0; j < k; ++j)
      if (is_same(mesh, vertices[j], vertices[k])) return false;
    for (int j = 0; j < 6; ++j)
      if (twins[k] == sides[j]) return false;
  }
  const Index x = vertices[steps], y = vertices[steps + 3];
  if ((mesh.on_boundary(x) && mesh.on_boundary(y)) || are_adjacent(mesh, x, y)) return false;
  work.begin();
  const Index first = 4 * quad_of(h), second = 4 * quad_of(g);
  work.touch_quad(quad_of(h));
  work.touch_quad(quad_of(g));
  for (int k = 0; k < 4; ++k) {
    work.set_corner(first + k, vertices[(steps + k) % 6]);
    work.set_corner(second + k, vertices[(steps + 3 + k) % 6]);
  }
  for (int k = 0; k < 3; ++k) {
    work.sew(first + k, twins[(steps + k) % 6]);
    work.sew(second + k, twins[(steps + 3 + k) % 6]);
  }
  work.sew(first + 3, second + 3);
  for (int k = 0; k < 4; ++k) work.recount(first + k);
  for (int k = 1; k < 3; ++k) work.recount(second + k);
  return clear_doublets(work, {vertices[0], vertices[3]}, 2) || undone(work);
}

namespace {

/// Mean of the corners opposite v in some of the quadrilaterals around it.
template <class Leaving>
Point mean_opposite(const QuadMesh& mesh, int begin, int end, Leaving&& leaving) {
  Point sum{0, 0};
  for (int i = begin; i < end; ++i) sum = sum + mesh.vertex_at(opposite_in_quad(leaving(i))).p;
  return (1. / (end - begin)) * sum;
}

WorkVertex towards(const QuadWork& work, const WorkVertex& from, Point p, double share) {
  WorkVertex vertex{from.p + share * (p - from.p), {}, from.hint};
  vertex.r = work.background.factor_at(vertex.p, vertex.hint);
  return vertex;
}

/// The new quadrilateral after a split; `twins` lie across its four sides.
void fill_gap(QuadWork& work, const std::array<Index, 4>& corners,
              const std::array<Index, 4>& twins) {
  const Index quad = 4 * work.add_quad();
  for (int k = 0; k < 4; ++k) work.set_corner(quad + k, corners[k]);
  for (int k = 0; k < 4; ++k) work.sew(quad + k, twins[k]);
  for (int k = 0; k < 4; ++k) work.recount(quad + k);
}

}  // namespace

bool split_vertex(QuadWork& work, Index first, int count) {
  QuadMesh& mesh = work.mesh;
  const Index v = mesh.corner[first];
  Fan fan;
  // A share of one quadrilateral would make a doublet.
  if (!mesh.is_free(v) || !fan_of(mesh, v, fan) || count < 2 || count > fan.size - 2) return false;
  int offset = 0;
  while (fan.leaving[offset] != first) ++offset;
  const auto leaving = [&](int i) { return fan.leaving[(offset + i) % fan.size]; };
  const Point kept = mean_opposite(mesh, 0, count, leaving);
  const Point given = mean_opposite(mesh, count, fan.size, leaving);
  const Index e_first = mesh.corner[next_in_quad(leaving(0))];
  const Index e_count = mesh.corner[next_in_quad(leaving(count))];
  if (is_same(mesh, e_first, e_count)) return false;
  // Around the gap: v -> e_first, e_count -> v of the kept quads, and the same of the given ones.
  const std::array<Index, 4> twins{leaving(0), previous_in_quad(leaving(count - 1)), leaving(count),
                                   previous_in_quad(leaving(fan.size - 1))};
  work.begin();
  const WorkVertex old = mesh.vertices[v];
  const Index w = work.add_vertex(towards(work, old, given, 0.25));
  work.move(v, towards(work, old, kept, 0.25));
  for (int i = count; i < fan.size; ++i) work.set_corner(leaving(i), w);
  fill_gap(work, {e_first, v, e_count, w}, twins);
  return true;
}

bool split_boundary_vertex(QuadWork& work, Index v, int begin, int end) {
  QuadMesh& mesh = work.mesh;
  Fan fan;
  if (!mesh.on_boundary(v) || !fan_of(mesh, v, fan)) return false;
  if (begin < 0 || end > fan.size || end - begin < 2) return false;  // one alone: a doublet
  const auto leaving = [&](int i) { return fan.leaving[i]; };
  const Point given = mean_opposite(mesh, begin, end, leaving);
  const auto spoke = [&](int i) {  // the i-th neighbour of v, anticlockwise
    return i < fan.size ? mesh.corner[next_in_quad(leaving(i))]
                        : mesh.corner[previous_in_quad(leaving(fan.size - 1))];
  };
  const Index e_begin = spoke(begin), e_end = spoke(end);
  if (is_same(mesh, e_begin, e_end)) return false;
  // The rim of the new quad e_end, v, e_begin, w; a side of it may be on the boundary.
  const std::array<Index, 4> twins{
      end < fan.size ? leaving(end) : mesh.twin[previous_in_quad(leaving(fan.size - 1))],
      begin > 0 ? previous_in_quad(leaving(begin - 1)) : mesh.twin[leaving(0)], leaving(begin),
      previous_in_quad(leaving(end - 1))};
  work.begin();
  const Index w = work.add_vertex(towards(work, mesh.vertices[v], given, 0.35));
  for (int i = begin; i < end; ++i) {
    work.touch_quad(quad_of(leaving(i)));
    work.set_corner(leaving(i), w);
  }
  fill_gap(work, {e_end, v, e_begin, w}, twins);
  return true;
}

bool rotate_vertex(QuadWork& work, Index v) {
  QuadMesh& mesh = work.mesh;
  Fan fan;
  if (!mesh.is_free(v) || !fan_of(mesh, v, fan) || fan.size < 3 || fan.size > 7) return false;
  std::array<Index, 8> spokes, opposite, rim1, rim2;
  for (int i = 0; i < fan.size; ++i) {
    const Index h = fan.leaving[i];
    spokes[i] = mesh.corner[next_in_quad(h)];
    opposite[i] = mesh.corner[opposite_in_quad(h)];
    rim1[i] = mesh.twin[next_in_quad(h)];
    rim2[i] = mesh.twin[opposite_in_quad(h)];
    if (are_adjacent(mesh, v, opposite[i])) return false;
    for (int j = 0; j < i; ++j)
      if (is_same(mesh, opposite[j], opposite[i])) return false;
    for (const Index rim : {rim1[i], rim2[i]})
      for (int j = 0; j < fan.size; ++j)
        if (rim >= 0 && quad_of(rim) == quad_of(fan.leaving[j])) return false;
  }
  work.begin();
  for (int i = 0; i < fan.size; ++i) work.touch_quad(quad_of(fan.leaving[i]));
  for (int i = 0; i < fan.size; ++i) {  // quad i becomes v, w_i, e_(i+1), w_(i+1)
    const int j = (i + 1) % fan.size;
    const Index quad = 4 * quad_of(fan.leaving[i]);
    const std::array<Index, 4> corners{v, opposite[i], spokes[j], opposite[j]};
    for (int k = 0; k < 4; ++k) work.set_corner(quad + k, corners[k]);
    work.sew(quad + 1, rim2[i]);
    work.sew(quad + 2, rim1[j]);
    work.sew(quad + 3, 4 * quad_of(fan.leaving[j]));
  }
  for (int i = 0; i < fan.size; ++i)
    for (int k = 0; k < 3; ++k) work.recount(4 * quad_of(fan.leaving[i]) + k);
  return clear_doublets(work, spokes, fan.size) || undone(work);
}

void remove_doublets(QuadWork& work) {
  for (Index v = 0; v < static_cast<Index>(work.mesh.vertices.size()); ++v) {
    if (work.mesh.leaving[v] == kNoIndex || !work.mesh.is_free(v) || work.mesh.valence[v] > 2)
      continue;
    work.begin();
    if (!clear_doublets(work, {v}, 1)) {
      work.undo();
      continue;
    }
    int not_convex = 0;
    work.energy_change(not_convex);
    work.commit();
  }
}

}  // namespace anisofront
