#include "mesher/quads/quad_mesh.hpp"

#include <algorithm>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {
namespace {

/// A segment under the ordered numbers of its ends.
struct SegmentKey {
  Index low, high, segment;
  friend bool operator<(const SegmentKey& x, const SegmentKey& y) {
    return x.low < y.low || (x.low == y.low && x.high < y.high);
  }
};

std::vector<SegmentKey> sorted_keys(const std::vector<Segment>& segments) {
  std::vector<SegmentKey> keys;
  keys.reserve(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s)
    keys.push_back({std::min(segments[s].a, segments[s].b), std::max(segments[s].a, segments[s].b),
                    static_cast<Index>(s)});
  std::sort(keys.begin(), keys.end());
  return keys;
}

void connect(const MixedMesh& mesh, QuadMesh& result) {
  std::vector<Quad> quads;
  quads.reserve(mesh.faces.size());
  for (const MixedFace& face : mesh.faces) quads.push_back(face.vertices);
  HalfEdgeTwins twins = half_edge_twins({{}, quads}, static_cast<Index>(mesh.vertices.size()));
  if (!twins.conflicts.empty())
    throw MeshingError("the quadrilaterals do not fit together; please report this case");
  result.twin = std::move(twins.twin);
  result.corner.reserve(4 * quads.size());
  for (const Quad& quad : quads)
    result.corner.insert(result.corner.end(), quad.begin(), quad.end());
}

/// Half-edges along segments get these for twins.
void mark_segments(const MixedMesh& mesh, QuadMesh& result) {
  const std::vector<SegmentKey> keys = sorted_keys(mesh.segments);
  for (const Segment& s : mesh.segments)
    result.kind[s.a] = result.kind[s.b] = QuadVertexKind::boundary;
  for (Index h = 0; h < static_cast<Index>(result.corner.size()); ++h) {
    const Index a = result.corner[h], b = result.corner[next_in_quad(h)];
    if (!result.on_boundary(a) || !result.on_boundary(b)) continue;
    const SegmentKey key{std::min(a, b), std::max(a, b), 0};
    const auto found = std::lower_bound(keys.begin(), keys.end(), key);
    if (found == keys.end() || key < *found) continue;
    result.twin[h] = ~found->segment;
  }
}

Index first_of_fan(const QuadMesh& mesh, Index h) {
  const Index start = h;
  while (mesh.twin[h] >= 0) {
    h = clockwise(mesh, h);
    if (h == start) break;
  }
  return h;
}

Index add_copy(QuadMesh& mesh, Index v) {
  mesh.vertices.push_back(mesh.vertices[v]);
  mesh.leaving.push_back(kNoIndex);
  mesh.valence.push_back(0);
  mesh.kind.push_back(mesh.kind[v]);
  mesh.original.push_back(v);
  mesh.next_copy.push_back(mesh.next_copy[v]);
  mesh.next_copy[v] = static_cast<Index>(mesh.vertices.size()) - 1;
  return static_cast<Index>(mesh.vertices.size()) - 1;
}

/// One vertex per fan: the first fan keeps the vertex, the others get copies.
void cut_open(QuadMesh& mesh) {
  std::vector<char> assigned(mesh.corner.size(), 0);
  for (Index h = 0; h < static_cast<Index>(mesh.corner.size()); ++h) {
    if (assigned[h]) continue;
    const Index start = first_of_fan(mesh, h);
    const Index v = mesh.corner[h];
    const Index copy = mesh.leaving[v] == kNoIndex ? v : add_copy(mesh, v);
    mesh.leaving[copy] = start;
    int count = 0;
    for_each_leaving(mesh, copy, [&](Index l) {
      assigned[l] = 1;
      mesh.corner[l] = copy;
      ++count;
    });
    if (count > 255)
      throw MeshingError("more than 255 quadrilaterals meet in one vertex; ask for smaller sizes");
    mesh.valence[copy] = static_cast<std::uint8_t>(count);
  }
}

}  // namespace

bool are_adjacent(const QuadMesh& mesh, Index u, Index v) {
  bool found = false;
  Index copy = u;
  do {
    for_each_leaving(mesh, copy, [&](Index h) {
      found = found || is_same(mesh, mesh.corner[next_in_quad(h)], v) ||
              is_same(mesh, mesh.corner[previous_in_quad(h)], v);
    });
    copy = mesh.next_copy[copy];
  } while (copy != u && !found);
  return found;
}

QuadMesh make_quad_mesh(const MixedMesh& mesh) {
  QuadMesh result;
  const std::size_t n = mesh.vertices.size();
  result.vertices = mesh.vertices;
  result.leaving.assign(n, kNoIndex);
  result.valence.assign(n, 0);
  result.kind.assign(n, QuadVertexKind::free);
  result.original.resize(n);
  result.next_copy.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    result.original[v] = result.next_copy[v] = static_cast<Index>(v);
    if (v < mesh.required.size() && mesh.required[v]) result.kind[v] = QuadVertexKind::required;
  }
  connect(mesh, result);
  mark_segments(mesh, result);
  cut_open(result);
  return result;
}

MixedMesh glued(const QuadMesh& mesh, std::vector<Segment> segments) {
  MixedMesh result;
  std::vector<Index> number(mesh.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    const bool copy = mesh.original[v] != kNoIndex && mesh.original[v] != static_cast<Index>(v);
    number[v] = copy ? mesh.original[v] : static_cast<Index>(result.vertices.size());
    if (copy) continue;
    result.vertices.push_back(mesh.vertices[v]);
    result.required.push_back(mesh.kind[v] == QuadVertexKind::required);
  }
  for (Index q = 0; q < mesh.quad_count(); ++q) {
    if (mesh.is_dead(q)) continue;
    MixedFace face;
    for (int k = 0; k < 4; ++k) face.vertices[k] = number[mesh.corner[4 * q + k]];
    result.faces.push_back(face);
  }
  result.segments = std::move(segments);
  return result;
}

}  // namespace anisofront
