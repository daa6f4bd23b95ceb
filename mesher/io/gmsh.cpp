#include "mesher/io/gmsh.hpp"

#include "mesher/io/gmsh_content.hpp"
#include "mesher/io/mapped_file.hpp"

namespace anisofront {

namespace {

struct GmshParser {
  GmshStream in;
  GmshContent content;
  GmshEntities entities;
  bool is_version_4 = false;
};

/// The binary header holds the number 1, which shows the byte order.
void read_byte_order(GmshStream& in) {
  in.text.skip_line();
  GmshStream probe = in;
  probe.set_binary(false);
  const Index one = probe.integer("the number 1 that shows the byte order");
  constexpr Index kSwappedOne = 0x01000000;
  if (one != 1 && one != kSwappedOne)
    in.fail("the number that shows the byte order is neither 1 nor its swap");
  in.set_binary(one == kSwappedOne);
  in.integer("the number 1");
}

void read_format(GmshParser& parser) {
  GmshStream& in = parser.in;
  if (in.text.peek() == "$NOD") in.fail("Gmsh format 1: save it as format 4.1 or 2.2");
  in.text.expect("$MeshFormat");
  const std::string_view version = in.text.word("a format version");
  parser.is_version_4 = version == "4.1";
  if (!parser.is_version_4 && version != "2.2" && version != "2.1" && version != "2" &&
      version != "2.0")
    in.fail("Gmsh format " + std::string(version.substr(0, 8)) +
            ": expected 2.2 or 4.1; convert it by gmsh IN.msh -save -format msh41 -o OUT.msh");
  const std::int64_t is_binary = in.text.integer("the file type, 0 (ASCII) or 1 (binary)");
  if (in.text.integer("the size of a number") != 8) in.fail("expected numbers of 8 bytes");
  if (is_binary != 0) read_byte_order(in);
  in.text.expect("$EndMeshFormat");
}

void read_physical_names(GmshStream& in, GmshContent& content) {
  constexpr std::size_t kLeastBytes = 7;  // 1 1 ""
  const Index n = in.text.count("the number of physical names", kLeastBytes);
  for (Index i = 0; i < n; ++i) {
    PhysicalGroup group;
    group.dimension = in.text.index("the dimension of a physical group");
    group.tag = in.text.index("the tag of a physical group");
    group.name = in.text.quoted("a physical name");
    content.groups.push_back(std::move(group));
  }
}

void skip_to_end(GmshStream& in, const std::string& end) {
  const std::size_t at = in.text.rest().find(end);
  if (at == std::string_view::npos) in.fail("the section is not closed: no " + end);
  in.text.move_to(in.text.offset() + at);
}

/// Reads what is between "$Name" and "$EndName"; unknown sections ($Periodic, $Comments, ...) are
/// skipped.
void read_section_body(GmshParser& parser, std::string_view name, const std::string& end) {
  auto& [in, content, entities, is_version_4] = parser;
  const bool has_binary_header = is_version_4 && in.binary();
  if (has_binary_header && (name == "Nodes" || name == "Elements" || name == "Entities" ||
                            name == "PartitionedEntities"))
    in.text.skip_line();
  if (name == "PhysicalNames") return read_physical_names(in, content);
  if (name == "Entities" && is_version_4) return read_gmsh_entities(in, content, entities);
  if (name == "PartitionedEntities" && is_version_4)
    return read_gmsh_partitioned_entities(in, content, entities);
  if (name == "Nodes")
    return is_version_4 ? read_gmsh_nodes_4(in, content) : read_gmsh_nodes_2(in, content);
  if (name == "Elements")
    return is_version_4 ? read_gmsh_elements_4(in, content, entities)
                        : read_gmsh_elements_2(in, content);
  if (name == "NodeData") return read_gmsh_node_data(in, content);
  if (name == "ElementData") return read_gmsh_element_data(in, content);
  if (name == "ElementNodeData") return read_gmsh_element_node_data(in, content);
  if (name == "Anisofront") return read_gmsh_marks(in, content);
  skip_to_end(in, end);
}

void read_section(GmshParser& parser) {
  TextCursor& text = parser.in.text;
  const std::string_view header = text.peek();
  if (header.size() < 2 || header.front() != '$') text.fail_expected("a section such as $Nodes");
  text.word("a section");
  const std::string_view name = header.substr(1);
  const std::string end = "$End" + std::string(name);
  read_section_body(parser, name, end);
  if (text.peek() != end)
    parser.in.fail("expected " + end + " after the announced number of entries");
  text.expect(end);
}

}  // namespace

MeshFile parse_gmsh(std::string_view bytes, const std::string& name, const Monitor& monitor) {
  GmshParser parser{
      .in = GmshStream(bytes, name), .content = GmshContent(name, monitor), .entities = {}};
  read_format(parser);
  while (!parser.in.text.at_end()) read_section(parser);
  if (!parser.content.has_nodes) parser.in.fail("the file has no section $Nodes");
  if (!parser.content.has_elements) parser.in.fail("the file has no section $Elements");
  return assemble_gmsh(parser.content);
}

MeshFile read_gmsh(const std::filesystem::path& path, const Monitor& monitor) {
  const MappedFile file(path);
  return parse_gmsh(file.bytes(), path.string(), monitor);
}

}  // namespace anisofront
