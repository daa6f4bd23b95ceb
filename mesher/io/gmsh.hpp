#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/geometry/monitor.hpp"
#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// A named field of a mesh file: `components` values per vertex (1 scalar, 3 vector, 9 tensor in
/// row-major order, as Gmsh stores them) or per element (triangles first, then quads).
struct FileField {
  std::string name;
  int components = 1;
  std::vector<double> values;
  double time = 0;
  int step = 0;
};

/// A mesh with its fields, as read from or written to a file.
struct MeshFile {
  Mesh mesh;
  std::vector<FileField> vertex_fields;
  std::vector<FileField> element_fields;
};

enum class GmshVersion { v2_2, v4_1 };
struct GmshFormat {
  GmshVersion version = GmshVersion::v4_1;
  bool binary = false;
};

/// Reads Gmsh .msh 2.2 and 4.1, ASCII and binary (both byte orders): physical names, entities,
/// points, lines, triangles, quads of any order up to 2 (reduced to their corners, with a warning),
/// node, element and element-node data. Triangles and quads that run clockwise are turned round.
/// Node numbers may have gaps; vertices and elements are kept in the order of their numbers.
///
/// Physical tags become CurveEdge::tag, regions and vertex_tags (such a vertex is also required);
/// in a file without any physical group the elementary tags take their place. Elementary tags
/// become CurveEdge::curve. Warnings tell of nodes that no element uses (dropped, unless they are
/// tagged points), of elements stored several times (the first is kept), of entities in several
/// physical groups (the first counts) and of data left out. Nodes or elements without an entry in
/// a field get NaN there. Element-node data is averaged over the corners of each element and
/// becomes an element field.
///
/// Throws InputError with file, line (ASCII) or byte offset (binary), what was found and what was
/// expected; UsageError when the file does not exist. Among the errors: elements without area,
/// solid elements, nodes that are not in one plane z = const, numbers out of range.
MeshFile read_gmsh(const std::filesystem::path& path, const Monitor& monitor = {});

/// read_gmsh() on the bytes of a file; `name` is what error messages call it.
MeshFile parse_gmsh(std::string_view bytes, const std::string& name, const Monitor& monitor = {});

/// Writes atomically (temporary name, then rename) with 17 significant digits; round trips are
/// bit-exact. Elements are numbered from 1: curve edges, triangles, quads, tagged points. What the
/// format has no place for (corners, required vertices, curve indices and parameters) goes to a
/// section $Anisofront, which other programs skip.
/// Throws InputError when an array does not fit the mesh, a tag is negative or the file cannot be
/// written (the old file stays).
void write_gmsh(const std::filesystem::path& path, const MeshFile& file, GmshFormat format = {});

}  // namespace anisofront
