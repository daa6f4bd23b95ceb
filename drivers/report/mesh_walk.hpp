#pragma once

#include <array>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Where a value at a vertex is guessed from before it is known: half of
///   weight v[0] + (4 - weight) v[1] - v[2] - v[3]
/// with the values v at the vertices `from`, 0 where these are kNoIndex. Weight 2 completes the
/// parallelogram of the element behind the edge v[0] v[1], weight 3 goes straight on beyond v[0].
struct VertexGuess {
  Index vertex = kNoIndex;
  std::array<Index, 4> from{kNoIndex, kNoIndex, kNoIndex, kNoIndex};
  int weight = 2;
};

/// Every vertex once, each guessed from earlier ones: the elements are walked breadth first across
/// their edges, pieces of the mesh in the order of their first element; vertices without element
/// come last. Linear functions are guessed exactly in a regular mesh of triangles or of
/// parallelograms. Page scripts repeat this walk (page/mesh_walk.js).
/// Idea: C. Touma, C. Gotsman, Triangle mesh compression, Graphics Interface 1998, 26-34.
/// Precondition: vertex numbers in range.
std::vector<VertexGuess> mesh_walk(const Mesh& mesh);

}  // namespace anisofront
