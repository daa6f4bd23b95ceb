#include "mesher/io/medit.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "mesher/io/element_orientation.hpp"
#include "mesher/io/mapped_file.hpp"
#include "mesher/io/text_cursor.hpp"

namespace anisofront {

namespace {

/// What is known after the sections have been read. Vertex numbers can only be checked once all
/// sections are known; `*_start` are the byte offsets of the first entry of a section.
struct MeditFile {
  TextCursor text;
  const Monitor& monitor;
  int dimension = 2;
  Mesh mesh;
  double z = 0;
  bool has_end = false;
  std::size_t edges_start = 0, triangles_start = 0, quads_start = 0, corners_start = 0,
              required_start = 0;
};

using Sections = std::size_t MeditFile::*;

[[noreturn]] void fail_dimension(MeditFile& file, const std::string& what) {
  file.text.fail(what + ": expected a mesh in the plane (Dimension 2, or constant z)");
}

/// A vertex number, made 0-based; whether such a vertex exists is checked at the end.
Index read_vertex(TextCursor& text) {
  const Index number = text.index("a vertex number");
  return number > 0 ? number - 1 : kNoIndex;
}

void read_vertices(MeditFile& file) {
  constexpr std::size_t kLeastBytes = 6;  // "0 0 0\n"
  TextCursor& text = file.text;
  if (!file.mesh.points.empty()) text.fail("a second section Vertices");
  const auto n = static_cast<std::size_t>(text.count("the number of vertices", kLeastBytes));
  file.mesh.points.resize(n);
  file.mesh.vertex_tags.resize(n);
  bool tagged = false;
  for (std::size_t v = 0; v < n; ++v) {
    Point& point = file.mesh.points[v];
    point.x = text.finite_real("the finite coordinate x");
    point.y = text.finite_real("the finite coordinate y");
    if (file.dimension == 3) {
      const double z = text.finite_real("the finite coordinate z");
      if (v == 0) file.z = z;
      if (z != file.z) fail_dimension(file, "z varies at vertex " + std::to_string(v + 1));
    }
    file.mesh.vertex_tags[v] = text.index("a vertex reference");
    tagged = tagged || file.mesh.vertex_tags[v] != 0;
  }
  if (!tagged) file.mesh.vertex_tags = {};
}

template <std::size_t N>
void read_elements(MeditFile& file, std::vector<std::array<Index, N>>& elements,
                   std::vector<Index>& regions, Sections start) {
  TextCursor& text = file.text;
  if (!elements.empty()) text.fail("a second section of the same name");
  const auto n = static_cast<std::size_t>(text.count("the number of elements", 2 * N + 2));
  file.*start = text.offset();
  elements.resize(n);
  regions.resize(n);
  for (std::size_t e = 0; e < n; ++e) {
    for (Index& v : elements[e]) v = read_vertex(text);
    regions[e] = text.index("an element reference");
  }
}

void read_edges(MeditFile& file) {
  constexpr std::size_t kLeastBytes = 6;  // "1 2 0\n"
  TextCursor& text = file.text;
  if (!file.mesh.edges.empty()) text.fail("a second section Edges");
  file.mesh.edges.resize(static_cast<std::size_t>(text.count("the number of edges", kLeastBytes)));
  file.edges_start = text.offset();
  for (CurveEdge& edge : file.mesh.edges) {
    for (Index& v : edge.vertices) v = read_vertex(text);
    edge.tag = text.index("an edge reference");
  }
}

void read_vertex_list(MeditFile& file, std::vector<Index>& vertices, Sections start) {
  const Index n = file.text.count("the number of vertices", 2);
  file.*start = file.text.offset();
  vertices.resize(static_cast<std::size_t>(n));
  for (Index& v : vertices) v = read_vertex(file.text);
}

/// Skips numbers up to the next keyword.
void skip_section(MeditFile& file) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  while (!file.text.at_end() && !is_letter(file.text.peek().front())) file.text.word("a number");
}

void skip_known_section(MeditFile& file, std::string_view keyword) {
  constexpr std::array<std::string_view, 4> kSolids{"Tetrahedra", "Hexahedra", "Prisms",
                                                    "Pyramids"};
  constexpr std::array<std::string_view, 3> kRequired{"RequiredEdges", "RequiredTriangles",
                                                      "RequiredQuadrilaterals"};
  const bool solid = std::find(kSolids.begin(), kSolids.end(), keyword) != kSolids.end();
  const bool required = std::find(kRequired.begin(), kRequired.end(), keyword) != kRequired.end();
  if (solid && file.text.integer("a number of elements") != 0)
    fail_dimension(file, "the section " + std::string(keyword) + " is three-dimensional");
  if (required && file.text.integer("a number of entries") != 0)
    file.monitor.warning(file.text.name() + ": " + std::string(keyword) +
                         " is not kept: remeshing may split what it lists");
  skip_section(file);
}

void read_section(MeditFile& file) {
  const std::string_view keyword = file.text.word("a keyword");
  Mesh& mesh = file.mesh;
  if (keyword == "Vertices") return read_vertices(file);
  if (keyword == "Edges") return read_edges(file);
  if (keyword == "Triangles")
    return read_elements(file, mesh.triangles, mesh.triangle_regions, &MeditFile::triangles_start);
  if (keyword == "Quadrilaterals")
    return read_elements(file, mesh.quads, mesh.quad_regions, &MeditFile::quads_start);
  if (keyword == "Corners") return read_vertex_list(file, mesh.corners, &MeditFile::corners_start);
  if (keyword == "RequiredVertices")
    return read_vertex_list(file, mesh.required_vertices, &MeditFile::required_start);
  if (keyword == "End") {
    file.has_end = true;
    return file.text.move_to(file.text.offset() + file.text.remaining());
  }
  skip_known_section(file, keyword);
}

void read_header(MeditFile& file) {
  file.text.expect("MeshVersionFormatted");
  const std::int64_t version = file.text.integer("a format version");
  if (version < 1 || version > 4) file.text.fail("expected format version 1 or 2");
  file.text.expect("Dimension");
  file.dimension = file.text.index("2 or 3, the dimension");
  if (file.dimension != 2 && file.dimension != 3) fail_dimension(file, "wrong dimension");
}

/// Fails at entry `number` (0-based) of the section that starts at byte `start`.
[[noreturn]] void fail_entry(MeditFile& file, std::size_t start, std::size_t entry_words,
                             std::size_t number, const std::string& message) {
  file.text.move_to(start);
  for (std::size_t word = 0; word < number * entry_words; ++word) file.text.word("a number");
  file.text.at_end();
  file.text.fail(message);
}

std::string vertex_range(const MeditFile& file, Index v) {
  return "vertex number " + std::to_string(static_cast<std::int64_t>(v) + 1) + ", expected 1 to " +
         std::to_string(file.mesh.points.size());
}

bool vertices_exist(const MeditFile& file, std::span<const Index> vertices) {
  const auto n = static_cast<std::uint32_t>(file.mesh.points.size());
  return std::all_of(vertices.begin(), vertices.end(),
                     [n](Index v) { return static_cast<std::uint32_t>(v) < n; });
}

/// The first vertex number that is out of range, in words.
std::string bad_vertex(const MeditFile& file, std::span<const Index> vertices) {
  const auto bad = std::find_if(vertices.begin(), vertices.end(),
                                [&](Index v) { return !vertices_exist(file, std::span(&v, 1)); });
  return vertex_range(file, *bad);
}

template <std::size_t N>
void check_elements(MeditFile& file, std::vector<std::array<Index, N>>& elements,
                    std::size_t start) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::string_view kind = N == 3 ? "triangle " : "quadrilateral ";
    if (!vertices_exist(file, elements[e]))
      fail_entry(file, start, N + 1, e,
                 std::string(kind) + std::to_string(e + 1) + ": " + bad_vertex(file, elements[e]));
    if (const char* defect = make_anticlockwise(elements[e], file.mesh.points))
      fail_entry(file, start, N + 1, e, std::string(kind) + std::to_string(e + 1) + " " + defect);
  }
}

void check_edges(MeditFile& file) {
  const std::vector<CurveEdge>& edges = file.mesh.edges;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = edges[e].vertices;
    const std::string edge = "edge " + std::to_string(e + 1);
    if (!vertices_exist(file, edges[e].vertices))
      fail_entry(file, file.edges_start, 3, e, edge + ": " + bad_vertex(file, edges[e].vertices));
    if (file.mesh.points[a] == file.mesh.points[b])
      fail_entry(file, file.edges_start, 3, e, edge + " has no length");
  }
}

void check_vertex_list(MeditFile& file, const std::vector<Index>& vertices, std::size_t start) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!vertices_exist(file, std::span(&vertices[i], 1)))
      fail_entry(file, start, 1, i, vertex_range(file, vertices[i]));
}

}  // namespace

Mesh parse_medit(std::string_view bytes, const std::string& name, const Monitor& monitor) {
  MeditFile file{.text = TextCursor(bytes, name), .monitor = monitor, .mesh = {}};
  read_header(file);
  while (!file.text.at_end()) read_section(file);
  check_edges(file);
  check_elements(file, file.mesh.triangles, file.triangles_start);
  check_elements(file, file.mesh.quads, file.quads_start);
  check_vertex_list(file, file.mesh.corners, file.corners_start);
  check_vertex_list(file, file.mesh.required_vertices, file.required_start);
  if (!file.has_end) monitor.warning(name + ": no End; the file may have been truncated");
  return std::move(file.mesh);
}

Mesh read_medit(const std::filesystem::path& path, const Monitor& monitor) {
  const MappedFile file(path);
  return parse_medit(file.bytes(), path.string(), monitor);
}

}  // namespace anisofront
