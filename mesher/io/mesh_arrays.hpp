#pragma once

#include <string>

#include "mesher/io/gmsh.hpp"

namespace anisofront {

// What every writer asks of its input, so that none of them reads outside an array.

/// Throws InputError "cannot write NAME: ..." when an array of the mesh has the wrong length or
/// holds the number of a vertex that does not exist.
void require_writable(const Mesh& mesh, const std::string& name);

/// The same for the fields too: each has `components` values per vertex or element.
void require_writable(const MeshFile& file, const std::string& name);

}  // namespace anisofront
