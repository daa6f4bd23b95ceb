#pragma once

#include <filesystem>

#include "mesher/io/gmsh.hpp"

namespace anisofront {

/// Writes a VTK unstructured grid (.vtu, ASCII XML, loads in ParaView): curve edges as lines with
/// their tag, triangles and quads with their region, all fields. Cell arrays "tag", "region" and
/// the element fields are 0 on the cells they do not concern. Atomic. Throws InputError when an
/// array does not fit the mesh or the file cannot be written.
void write_vtu(const std::filesystem::path& path, const MeshFile& file);

}  // namespace anisofront
