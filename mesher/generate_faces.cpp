#include "mesher/generate_faces.hpp"

#include <algorithm>
#include <array>

namespace anisofront {
namespace {

/// Segments by their two vertices.
class SegmentTable {
 public:
  SegmentTable(const std::vector<Segment>& segments, std::size_t vertex_count)
      : has_segment_(vertex_count, 0) {
    entries_.reserve(segments.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const auto [smaller, larger] = std::minmax(segments[s].a, segments[s].b);
      entries_.push_back({smaller, larger, static_cast<Index>(s)});
      has_segment_[smaller] = has_segment_[larger] = 1;
    }
    std::sort(entries_.begin(), entries_.end());
  }
  /// The segment between two vertices, or kNoIndex.
  Index find(Index a, Index b) const {
    if (!has_segment_[a] || !has_segment_[b]) return kNoIndex;
    const std::array<Index, 3> wanted{std::min(a, b), std::max(a, b), 0};
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), wanted);
    const bool same =
        found != entries_.end() && (*found)[0] == wanted[0] && (*found)[1] == wanted[1];
    return same ? (*found)[2] : kNoIndex;
  }

 private:
  std::vector<std::array<Index, 3>> entries_;  ///< smaller vertex, larger vertex, segment
  std::vector<char> has_segment_;              ///< per vertex
};

}  // namespace

MixedFaces::MixedFaces(const std::vector<MixedFace>& faces, const std::vector<Segment>& segments,
                       std::size_t vertex_count) {
  const auto quads = static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [](const MixedFace& face) { return face.is_quad(); }));
  quads_.reserve(quads);
  triangles_.reserve(faces.size() - quads);
  for (const auto& [v] : faces)
    if (v[3] == kNoIndex)
      triangles_.push_back({v[0], v[1], v[2]});
    else
      quads_.push_back(v);
  const HalfEdges edges = half_edges();
  across_ = half_edge_twins(edges, static_cast<Index>(vertex_count)).twin;
  const SegmentTable table(segments, vertex_count);
  for (Index side = 0; side < edges.count(); ++side) {
    const Index s = table.find(edges[side].from, edges[side].to);
    Index& across = across_[side];
    // A side without neighbour, which the check of the finished mesh will name, leads nowhere.
    across = s != kNoIndex ? ~s : edges.element(across == kNoIndex ? side : across);
  }
}

}  // namespace anisofront
