#include "mesher/quads/mixed_topology.hpp"

#include <algorithm>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {
namespace {

/// The faces as triangles and quads, and the half-edge (see HalfEdges) of each of their sides.
struct SortedFaces {
  std::vector<Triangle> triangles;
  std::vector<Quad> quads;

  explicit SortedFaces(const MixedMesh& mesh) {
    const Index count = triangle_count(mesh);
    triangles.reserve(count);
    quads.reserve(mesh.faces.size() - count);
    for (const MixedFace& face : mesh.faces) {
      const auto& v = face.vertices;
      if (face.is_quad())
        quads.push_back(v);
      else
        triangles.push_back({v[0], v[1], v[2]});
    }
  }
};

/// Segments by the smaller of their vertices.
class SegmentFinder {
 public:
  explicit SegmentFinder(const MixedMesh& mesh)
      : segments_(mesh.segments), first_(mesh.vertices.size() + 2, 0), ids_(segments_.size()) {
    for (const Segment& s : segments_) ++first_[std::min(s.a, s.b) + 2];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    for (std::size_t i = 0; i < ids_.size(); ++i)
      ids_[first_[std::min(segments_[i].a, segments_[i].b) + 1]++] = static_cast<Index>(i);
  }
  Index operator()(Index a, Index b) const {
    const Index low = std::min(a, b), high = std::max(a, b);
    for (Index i = first_[low]; i < first_[low + 1]; ++i)
      if (std::max(segments_[ids_[i]].a, segments_[ids_[i]].b) == high) return ids_[i];
    return kNoIndex;
  }

 private:
  const std::vector<Segment>& segments_;
  std::vector<Index> first_;
  std::vector<Index> ids_;
};

[[noreturn]] void throw_conflict(const HalfEdges& edges, const EdgeConflict& conflict) {
  const HalfEdge e = edges[conflict.second];
  throw MeshingError("the edge between vertices " + std::to_string(e.from) + " and " +
                     std::to_string(e.to) +
                     (conflict.same_direction ? " is run through in the same direction by two faces"
                                              : " is shared by more than two faces") +
                     "; expected one face on each side");
}

std::vector<Index> twins_of(const MixedMesh& mesh) {
  const SortedFaces faces(mesh);
  const HalfEdges half_edges{faces.triangles, faces.quads};
  HalfEdgeTwins twins = half_edge_twins(half_edges, static_cast<Index>(mesh.vertices.size()));
  if (!twins.conflicts.empty()) throw_conflict(half_edges, twins.conflicts.front());
  return std::move(twins.twin);
}

}  // namespace

Index triangle_count(const MixedMesh& mesh) {
  return static_cast<Index>(std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                          [](const MixedFace& f) { return !f.is_quad(); }));
}

MixedEdges mixed_edges(const MixedMesh& mesh) {
  const std::vector<Index> twin = twins_of(mesh);
  const SegmentFinder segment_of(mesh);
  std::vector<Index> edge_of(twin.size(), kNoIndex);
  MixedEdges result;
  result.edges.reserve((twin.size() + mesh.segments.size()) / 2);
  result.of_face.resize(mesh.faces.size());
  Index next_triangle = 0, next_quad = 3 * triangle_count(mesh);
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    const MixedFace& face = mesh.faces[f];
    const int size = face.size();
    Index& first = face.is_quad() ? next_quad : next_triangle;
    for (int k = 0; k < size; ++k) {
      const Index h = first + (size == 4 ? k : kPrevious[k]);  // half-edge opposite vertex k + 2
      if (twin[h] != kNoIndex && edge_of[twin[h]] != kNoIndex) {
        edge_of[h] = edge_of[twin[h]];
        result.edges[edge_of[h]].right = f;
      } else {
        edge_of[h] = static_cast<Index>(result.edges.size());
        const Index a = face.vertices[k], b = vertex_at(face, k + 1);
        result.edges.push_back({a, b, f, kNoIndex, segment_of(a, b)});
      }
      result.of_face[f][k] = edge_of[h];
    }
    if (size == 3) result.of_face[f][3] = kNoIndex;
    first += size;
  }
  return result;
}

FaceStars face_stars(const MixedMesh& mesh) {
  FaceStars stars;
  std::vector<Index>& first = stars.first;
  first.assign(mesh.vertices.size() + 2, 0);
  for (const MixedFace& face : mesh.faces)
    for (int k = 0; k < face.size(); ++k) ++first[face.vertices[k] + 2];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  stars.corners.resize(first.back());
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f)
    for (int k = 0; k < mesh.faces[f].size(); ++k)
      stars.corners[first[mesh.faces[f].vertices[k] + 1]++] = {f, k};
  first.pop_back();
  return stars;
}

std::vector<char> fixed_vertices(const MixedMesh& mesh) {
  std::vector<char> fixed = mesh.required;
  for (const Segment& s : mesh.segments) fixed[s.a] = fixed[s.b] = 1;
  return fixed;
}

}  // namespace anisofront
