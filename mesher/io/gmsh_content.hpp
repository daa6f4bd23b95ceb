#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mesher/io/gmsh.hpp"
#include "mesher/io/gmsh_stream.hpp"

namespace anisofront {

// Between the text of a .msh file and the Mesh made of it: sections as they were read, with node
// numbers replaced by positions in the list of nodes. Internal to the Gmsh reader.

struct GmshElement {
  std::int64_t number = 0;
  std::array<Index, 4> vertices{kNoIndex, kNoIndex, kNoIndex, kNoIndex};
  Index physical = 0;
  Index elementary = 0;
};

/// The section $Anisofront: what the Gmsh format has no place for (see gmsh_marks.hpp).
struct GmshMarks {
  struct EdgeCurve {
    Index curve = kNoIndex;
    std::array<double, 2> parameters{};
  };
  std::vector<Index> corners;
  std::vector<Index> required_vertices;
  std::vector<EdgeCurve> curves;  ///< one per curve edge
};

struct GmshContent {
  GmshContent(std::string file_name, const Monitor& receiver)
      : name(std::move(file_name)), monitor(receiver) {}

  std::string name;  ///< of the file, for warnings
  const Monitor& monitor;
  std::vector<PhysicalGroup> groups;

  bool has_nodes = false;
  std::vector<std::int64_t> node_numbers;  ///< ascending
  std::vector<Point> points;
  std::vector<char> is_mid_node;  ///< of an element of second order

  bool has_elements = false;
  std::vector<GmshElement> point_elements;  ///< all four by ascending number
  std::vector<GmshElement> edges;
  std::vector<GmshElement> triangles;
  std::vector<GmshElement> quads;
  std::vector<std::int64_t> left_out;  ///< ascending numbers of repeated and interface elements
  std::int64_t second_order = 0;       ///< elements reduced to their corners

  std::vector<FileField> vertex_fields;  ///< on the nodes
  std::vector<FileField> element_fields;
  std::optional<GmshMarks> marks;

  void warning(const std::string& message) const { monitor.warning(name + ": " + message); }
};

/// A physical tag without the sign by which Gmsh marks a reversed entity.
inline Index unsigned_tag(Index tag) {
  return tag < 0 ? -std::max(tag, -std::numeric_limits<Index>::max()) : tag;
}

/// Position of a node in the list. Fails when there is none of this number.
Index find_node(const GmshStream& in, const GmshContent& content, std::int64_t number);

// Sections; the stream is behind the line "$Nodes" and so on.
void read_gmsh_nodes_2(GmshStream& in, GmshContent& content);
void read_gmsh_nodes_4(GmshStream& in, GmshContent& content);
void read_gmsh_elements_2(GmshStream& in, GmshContent& content);

/// Physical and elementary tag of the elements on a model entity (format 4.1).
struct GmshEntity {
  int dimension = 0;
  Index tag = 0;
  Index physical = 0;
  Index elementary = 0;
  bool is_interface = false;  ///< between mesh partitions
};
/// Sorted by dimension, then tag. Reads $Entities and adds $PartitionedEntities.
using GmshEntities = std::vector<GmshEntity>;
void read_gmsh_entities(GmshStream& in, GmshContent& content, GmshEntities& entities);
void read_gmsh_partitioned_entities(GmshStream& in, GmshContent& content, GmshEntities& entities);
void read_gmsh_elements_4(GmshStream& in, GmshContent& content, const GmshEntities& entities);

void read_gmsh_node_data(GmshStream& in, GmshContent& content);
void read_gmsh_element_data(GmshStream& in, GmshContent& content);
void read_gmsh_element_node_data(GmshStream& in, GmshContent& content);

void read_gmsh_marks(GmshStream& in, GmshContent& content);

/// The mesh: tags chosen, unused nodes dropped, fields restricted to the vertices that stay.
MeshFile assemble_gmsh(GmshContent& content);

}  // namespace anisofront
