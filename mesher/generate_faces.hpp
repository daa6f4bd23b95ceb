#pragma once

#include <vector>

#include "mesher/front/work_mesh.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

// Two kinds of finished work, seen alike: faces with sides, numbered like the half-edges of
// topology.hpp. A side begins at from() and across() it lies a face, or ~s for segment s.

/// Triangles; dead ones have no sides.
struct TriangleFaces {
  const WorkMesh& work;

  Index count() const { return static_cast<Index>(work.triangles.size()); }
  Index begin_side(Index f) const { return 3 * f; }
  Index end_side(Index f) const { return work.triangles[f].dead() ? 3 * f : 3 * f + 3; }
  Index from(Index side) const { return work.triangles[side / 3].vertices[kNext[side % 3]]; }
  Index across(Index side) const { return work.triangles[side / 3].neighbours[side % 3]; }
};

/// Triangles and quadrilaterals, triangles first.
class MixedFaces {
 public:
  /// Precondition: vertex numbers in range.
  MixedFaces(const std::vector<MixedFace>& faces, const std::vector<Segment>& segments,
             std::size_t vertex_count);

  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Quad>& quads() const { return quads_; }

  Index count() const { return static_cast<Index>(triangles_.size() + quads_.size()); }
  Index begin_side(Index f) const {
    const auto triangles = static_cast<Index>(triangles_.size());
    return f < triangles ? 3 * f : 4 * f - triangles;
  }
  Index end_side(Index f) const { return begin_side(f + 1); }
  Index from(Index side) const { return half_edges()[side].from; }
  Index across(Index side) const { return across_[side]; }

 private:
  HalfEdges half_edges() const { return {triangles_, quads_}; }

  std::vector<Triangle> triangles_;
  std::vector<Quad> quads_;
  std::vector<Index> across_;
};

/// Region of each face, spread from the segments over the neighbours; kNoIndex where none arrives.
template <class Faces>
std::vector<Index> face_regions(const Faces& faces, const std::vector<Segment>& segments) {
  std::vector<Index> region(static_cast<std::size_t>(faces.count()), kNoIndex);
  std::vector<Index> queue;
  for (Index f = 0; f < faces.count(); ++f)
    for (Index side = faces.begin_side(f); side < faces.end_side(f); ++side) {
      if (faces.across(side) >= 0) continue;
      const Segment& s = segments[~faces.across(side)];
      region[f] = faces.from(side) == s.a ? s.left_region : s.right_region;
      if (region[f] == kNoIndex) continue;
      queue.push_back(f);
      break;
    }
  while (!queue.empty()) {
    const Index f = queue.back();
    queue.pop_back();
    for (Index side = faces.begin_side(f); side < faces.end_side(f); ++side) {
      const Index n = faces.across(side);
      if (n < 0 || region[n] != kNoIndex) continue;
      region[n] = region[f];
      queue.push_back(n);
    }
  }
  return region;
}

/// Numbers of the vertices in the result: those in use, in order of creation.
template <class Faces>
std::vector<Index> compact_numbers(const Faces& faces, std::size_t vertex_count) {
  std::vector<Index> number(vertex_count, kNoIndex);
  for (Index f = 0; f < faces.count(); ++f)
    for (Index side = faces.begin_side(f); side < faces.end_side(f); ++side)
      number[faces.from(side)] = 0;
  Index next = 0;
  for (Index& n : number)
    if (n != kNoIndex) n = next++;
  return number;
}

}  // namespace anisofront
