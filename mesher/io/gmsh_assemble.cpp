#include <algorithm>

#include "mesher/io/gmsh_content.hpp"

namespace anisofront {

namespace {

bool has_physical_tags(const GmshContent& content) {
  if (!content.groups.empty() || content.marks) return true;
  for (const auto* elements :
       {&content.point_elements, &content.edges, &content.triangles, &content.quads})
    for (const GmshElement& element : *elements)
      if (element.physical != 0) return true;
  return false;
}

/// In a file without physical groups the elementary tags take their place.
void choose_tags(GmshContent& content) {
  if (has_physical_tags(content)) return;
  for (auto* elements : {&content.edges, &content.triangles, &content.quads})
    for (GmshElement& element : *elements) element.physical = unsigned_tag(element.elementary);
}

std::vector<char> used_nodes(const GmshContent& content) {
  std::vector<char> used(content.points.size(), 0);
  for (const auto* elements : {&content.edges, &content.triangles, &content.quads})
    for (const GmshElement& element : *elements)
      for (const Index v : element.vertices)
        if (v != kNoIndex) used[static_cast<std::size_t>(v)] = 1;
  for (const GmshElement& element : content.point_elements)
    if (element.physical != 0) used[static_cast<std::size_t>(element.vertices[0])] = 1;
  return used;
}

void warn_unused(const GmshContent& content, const std::vector<char>& used) {
  std::int64_t unused = 0;
  std::size_t first = 0;
  for (std::size_t v = used.size(); v-- > 0;)
    if (!used[v] && !content.is_mid_node[v]) {
      ++unused;
      first = v;
    }
  if (unused > 0)
    content.warning(std::to_string(unused) +
                    " nodes belong to no element and were left out, among "
                    "them node " +
                    std::to_string(content.node_numbers[first]));
}

/// New numbers of the used nodes, kNoIndex for the others.
std::vector<Index> renumbering(const std::vector<char>& used) {
  std::vector<Index> numbers(used.size(), kNoIndex);
  Index next = 0;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) numbers[v] = next++;
  return numbers;
}

/// Keeps the entries of `size` values each whose node keeps a number.
template <class Value>
void compress(std::vector<Value>& values, const std::vector<Index>& numbers, std::size_t size) {
  std::size_t kept = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v)
    for (std::size_t k = 0; numbers[v] != kNoIndex && k < size; ++k)
      values[kept++] = values[v * size + k];
  values.resize(kept);
}

Index renumbered(const std::vector<Index>& numbers, Index v) {
  return numbers[static_cast<std::size_t>(v)];
}

template <std::size_t N>
void fill_elements(const std::vector<GmshElement>& from, const std::vector<Index>& numbers,
                   std::vector<std::array<Index, N>>& elements, std::vector<Index>& regions) {
  elements.reserve(from.size());
  regions.reserve(from.size());
  for (const GmshElement& element : from) {
    std::array<Index, N>& vertices = elements.emplace_back();
    for (std::size_t k = 0; k < N; ++k) vertices[k] = renumbered(numbers, element.vertices[k]);
    regions.push_back(element.physical);
  }
}

void fill_edges(const GmshContent& content, const std::vector<Index>& numbers, Mesh& mesh) {
  for (const GmshElement& element : content.edges)
    mesh.edges.push_back({.vertices = {renumbered(numbers, element.vertices[0]),
                                       renumbered(numbers, element.vertices[1])},
                          .tag = element.physical,
                          .curve = element.elementary});
}

void fill_points(const GmshContent& content, const std::vector<Index>& numbers, Mesh& mesh) {
  for (const GmshElement& element : content.point_elements) {
    if (element.physical == 0) continue;
    const Index v = renumbered(numbers, element.vertices[0]);
    mesh.vertex_tags.resize(mesh.points.size());
    mesh.vertex_tags[static_cast<std::size_t>(v)] = element.physical;
    mesh.required_vertices.push_back(v);
  }
}

std::vector<Index> kept_vertices(const std::vector<Index>& vertices,
                                 const std::vector<Index>& numbers) {
  std::vector<Index> kept;
  for (const Index v : vertices)
    if (renumbered(numbers, v) != kNoIndex) kept.push_back(renumbered(numbers, v));
  return kept;
}

void apply_marks(const GmshContent& content, const std::vector<Index>& numbers, Mesh& mesh) {
  if (!content.marks) return;
  const GmshMarks& marks = *content.marks;
  mesh.corners = kept_vertices(marks.corners, numbers);
  mesh.required_vertices = kept_vertices(marks.required_vertices, numbers);
  if (marks.curves.empty()) return;
  if (marks.curves.size() != mesh.edges.size())
    return content.warning("$Anisofront holds curves of " + std::to_string(marks.curves.size()) +
                           " edges, the mesh has " + std::to_string(mesh.edges.size()) +
                           "; curves and parameters were left out");
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    mesh.edges[e].curve = marks.curves[e].curve;
    mesh.edges[e].parameters = marks.curves[e].parameters;
  }
}

}  // namespace

MeshFile assemble_gmsh(GmshContent& content) {
  choose_tags(content);
  const std::vector<char> used = used_nodes(content);
  warn_unused(content, used);
  const std::vector<Index> numbers = renumbering(used);
  MeshFile file;
  Mesh& mesh = file.mesh;
  mesh.points = std::move(content.points);
  compress(mesh.points, numbers, 1);
  fill_elements(content.triangles, numbers, mesh.triangles, mesh.triangle_regions);
  fill_elements(content.quads, numbers, mesh.quads, mesh.quad_regions);
  fill_edges(content, numbers, mesh);
  fill_points(content, numbers, mesh);
  apply_marks(content, numbers, mesh);
  mesh.groups = std::move(content.groups);
  file.vertex_fields = std::move(content.vertex_fields);
  for (FileField& field : file.vertex_fields)
    compress(field.values, numbers, static_cast<std::size_t>(field.components));
  file.element_fields = std::move(content.element_fields);
  return file;
}

}  // namespace anisofront
