#pragma once

#include <map>
#include <span>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Closed loops of vertices, the last joined to the first.
using Loops = std::vector<std::vector<Index>>;

/// Outlines of the sets of elements that share a class (one number per element: triangles, then
/// quads), by class, each set on the left of its loops. Elements with a negative class belong to
/// none. Far fewer points than the elements have, and without seams between them.
std::map<Index, Loops> class_outlines(const Mesh& mesh, std::span<const Index> classes);

}  // namespace anisofront
