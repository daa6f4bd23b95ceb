#pragma once

#include <span>
#include <vector>

#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// Which faces of a MixedMesh meet where. Half-edge 4 f + k runs from corner k of face f to the
/// next corner, with f on its left (4 f + 3 of a triangle is none).
struct FaceLinks {
  std::vector<MixedFace>& faces;
  std::vector<Index> twin;    ///< per half-edge: the opposite one, kNoIndex on the boundary
  std::vector<char> closed;   ///< per half-edge: on a segment or on the boundary, never crossed
  std::vector<char> pinched;  ///< per vertex: the boundary passes through it more than once

  Index from(Index h) const { return faces[h / 4].vertices[h % 4]; }
  Index to(Index h) const { return from(next(h)); }
  Index next(Index h) const { return h % 4 == faces[h / 4].size() - 1 ? h - h % 4 : h + 1; }
  Index previous(Index h) const { return h % 4 == 0 ? h + faces[h / 4].size() - 1 : h - 1; }

  /// The face on the other side, or kNoIndex where the half-edge is closed.
  Index across(Index h) const { return closed[h] ? kNoIndex : twin[h] / 4; }
};

/// Precondition: the mesh is conforming (no directed edge twice) and outlives the links.
FaceLinks link_faces(MixedMesh& mesh);

/// The first half-edge of face f that leads openly to face g, or kNoIndex.
Index side_towards(const FaceLinks& links, Index f, Index g);

/// Whether an edge, possibly a segment, joins the vertex that h leaves with v. Two vertices in
/// which the boundary touches itself count as joined, for h sees only one of the fans there.
bool is_joined(const FaceLinks& links, Index h, Index v);

/// Half-edges have got new numbers: `after[i]` takes the place of `before[i]`.
void renumber(FaceLinks& links, std::span<const Index> before, std::span<const Index> after);

/// Makes g and h twins, open.
void join(FaceLinks& links, Index g, Index h);

}  // namespace anisofront
