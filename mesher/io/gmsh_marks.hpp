#pragma once

#include "mesher/io/atomic_file.hpp"
#include "mesher/io/gmsh_entity_plan.hpp"
#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Writes the section $Anisofront, always as text, so that meshes survive a round trip:
///   corners N, required N: followed by N node numbers;
///   curves N: CurveEdge::curve and parameters of every curve edge, or none when all parameters
///   are 0 and the curves are the elementary tags.
/// Its presence also says that tags of 0 mean "none" in a file without any physical group.
void write_gmsh_marks(AtomicFile& out, const Mesh& mesh, const GmshEntityPlan& plan);

}  // namespace anisofront
