#pragma once

#include <filesystem>

#include "mesher/io/gmsh.hpp"
#include "mesher/io/medit.hpp"

namespace anisofront {

/// Reads .msh or .mesh by suffix. Throws InputError for other suffixes (naming those supported) and
/// UsageError when the file does not exist.
MeshFile read_mesh_file(const std::filesystem::path& path, const Monitor& monitor = {});

/// Writes .msh, .mesh, .vtu or .svg by suffix. A vertex field named "metric" with 3 or 9 components
/// becomes NAME.sol beside a .mesh. Throws InputError for other suffixes.
void write_mesh_file(const std::filesystem::path& path, const MeshFile& file,
                     GmshFormat format = {});

/// Metric on the vertices of a mesh from a .sol, or from a .msh with tensor (9 components) or
/// scalar (size h) node data: the field named "metric" if there is one, else the first.
MetricField read_metric_file(const std::filesystem::path& path, Index vertex_count);

/// A metric as a file field (9 components, the third row and column zero except the last entry 0).
FileField metric_file_field(const MetricField& field);

}  // namespace anisofront
