#include "mesher/quads/face_links.hpp"

#include <algorithm>
#include <array>

#include "mesher/mesh/topology.hpp"

namespace anisofront {
namespace {

/// The twins of topology.hpp, which has triangles and quads apart, in our numbers.
std::vector<Index> twins_of(const MixedMesh& mesh) {
  std::vector<Triangle> triangles;
  std::vector<Quad> quads;
  std::vector<Index> ours, ours_of_quads;  // per half-edge of topology.hpp
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    const auto& [a, b, c, d] = mesh.faces[f].vertices;
    if (mesh.faces[f].is_quad()) {
      quads.push_back({a, b, c, d});
      for (Index k = 0; k < 4; ++k) ours_of_quads.push_back(4 * f + k);
    } else {
      triangles.push_back({a, b, c});
      for (const Index k : {1, 2, 0}) ours.push_back(4 * f + k);  // opposite vertices 0, 1, 2
    }
  }
  ours.insert(ours.end(), ours_of_quads.begin(), ours_of_quads.end());
  const std::vector<Index> theirs =
      half_edge_twins({triangles, quads}, static_cast<Index>(mesh.vertices.size())).twin;
  std::vector<Index> twin(4 * mesh.faces.size(), kNoIndex);
  for (std::size_t h = 0; h < theirs.size(); ++h)
    if (theirs[h] != kNoIndex) twin[ours[h]] = ours[theirs[h]];
  return twin;
}

using VertexPair = std::array<Index, 2>;

VertexPair sorted_pair(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<VertexPair> sorted_segments(const MixedMesh& mesh) {
  std::vector<VertexPair> pairs;
  pairs.reserve(mesh.segments.size());
  for (const Segment& s : mesh.segments) pairs.push_back(sorted_pair(s.a, s.b));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void close_segments(const MixedMesh& mesh, FaceLinks& links) {
  const std::vector<VertexPair> segments = sorted_segments(mesh);
  std::vector<char> on_segment(mesh.vertices.size(), 0);
  for (const Segment& s : mesh.segments) on_segment[s.a] = on_segment[s.b] = 1;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < mesh.faces[f].size(); ++k) {
      const auto h = static_cast<Index>(4 * f) + k;
      const Index a = links.from(h), b = links.to(h);
      links.closed[h] = links.twin[h] == kNoIndex ||
                        (on_segment[a] && on_segment[b] &&
                         std::binary_search(segments.begin(), segments.end(), sorted_pair(a, b)));
    }
}

void mark_pinched(const MixedMesh& mesh, FaceLinks& links) {
  std::vector<char> reached(mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < mesh.faces[f].size(); ++k) {
      const auto h = static_cast<Index>(4 * f) + k;
      if (links.twin[h] != kNoIndex) continue;
      const Index v = links.from(h);
      links.pinched[v] = reached[v];
      reached[v] = 1;
    }
}

}  // namespace

FaceLinks link_faces(MixedMesh& mesh) {
  const std::size_t half_edges = 4 * mesh.faces.size();
  FaceLinks links{mesh.faces, twins_of(mesh), std::vector<char>(half_edges, 1),
                  std::vector<char>(mesh.vertices.size(), 0)};
  close_segments(mesh, links);
  mark_pinched(mesh, links);
  return links;
}

Index side_towards(const FaceLinks& links, Index f, Index g) {
  for (Index h = 4 * f; h < 4 * f + links.faces[f].size(); ++h)
    if (links.across(h) == g) return h;
  return kNoIndex;
}

bool is_joined(const FaceLinks& links, Index h, Index v) {
  if (links.pinched[links.from(h)] && links.pinched[v]) return true;
  Index spoke = h;
  do {  // anticlockwise
    const Index in = links.previous(spoke);
    if (links.to(spoke) == v || links.from(in) == v) return true;
    spoke = links.twin[in];
  } while (spoke != kNoIndex && spoke != h);
  if (spoke == h) return false;
  for (Index back = links.twin[h]; back != kNoIndex; back = links.twin[spoke]) {  // clockwise
    spoke = links.next(back);
    if (links.to(spoke) == v) return true;
  }
  return false;
}

void renumber(FaceLinks& links, std::span<const Index> before, std::span<const Index> after) {
  std::array<Index, 6> twin;  // no face has more sides outside than a hexagon
  std::array<char, 6> closed;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Index old = links.twin[before[i]];
    const auto same = std::find(before.begin(), before.end(), old);
    twin[i] = same == before.end() ? old : after[same - before.begin()];
    closed[i] = links.closed[before[i]];
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    links.twin[after[i]] = twin[i];
    links.closed[after[i]] = closed[i];
    if (twin[i] != kNoIndex) links.twin[twin[i]] = after[i];
  }
}

void join(FaceLinks& links, Index g, Index h) {
  links.twin[g] = h;
  links.twin[h] = g;
  links.closed[g] = links.closed[h] = 0;
}

}  // namespace anisofront
