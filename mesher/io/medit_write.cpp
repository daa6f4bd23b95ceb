#include "mesher/io/atomic_file.hpp"
#include "mesher/io/medit.hpp"
#include "mesher/io/mesh_arrays.hpp"

namespace anisofront {

namespace {

void begin_section(AtomicFile& out, std::string_view keyword, std::size_t count) {
  out.text("\n");
  out.text(keyword);
  out.text("\n");
  out.integer(static_cast<std::int64_t>(count));
  out.text("\n");
}

void write_vertices(AtomicFile& out, const Mesh& mesh) {
  begin_section(out, "Vertices", mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    out.real(mesh.points[v].x);
    out.byte(' ');
    out.real(mesh.points[v].y);
    out.byte(' ');
    out.integer(mesh.vertex_tags.empty() ? 0 : mesh.vertex_tags[v]);
    out.byte('\n');
  }
}

template <class Vertices>
void write_entry(AtomicFile& out, const Vertices& vertices, Index reference) {
  for (const Index v : vertices) {
    out.integer(v + 1);
    out.byte(' ');
  }
  out.integer(reference);
  out.byte('\n');
}

void write_edges(AtomicFile& out, const Mesh& mesh) {
  if (mesh.edges.empty()) return;
  begin_section(out, "Edges", mesh.edges.size());
  for (const CurveEdge& edge : mesh.edges) write_entry(out, edge.vertices, edge.tag);
}

template <class Element>
void write_elements(AtomicFile& out, std::string_view keyword, const std::vector<Element>& elements,
                    const std::vector<Index>& regions) {
  if (elements.empty()) return;
  begin_section(out, keyword, elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e) write_entry(out, elements[e], regions[e]);
}

void write_vertex_list(AtomicFile& out, std::string_view keyword,
                       const std::vector<Index>& vertices) {
  if (vertices.empty()) return;
  begin_section(out, keyword, vertices.size());
  for (const Index v : vertices) {
    out.integer(v + 1);
    out.byte('\n');
  }
}

}  // namespace

void write_medit(const std::filesystem::path& path, const Mesh& mesh) {
  require_writable(mesh, path.string());
  AtomicFile out(path);
  out.text("MeshVersionFormatted 2\nDimension 2\n");
  write_vertices(out, mesh);
  write_edges(out, mesh);
  write_elements(out, "Triangles", mesh.triangles, mesh.triangle_regions);
  write_elements(out, "Quadrilaterals", mesh.quads, mesh.quad_regions);
  write_vertex_list(out, "Corners", mesh.corners);
  write_vertex_list(out, "RequiredVertices", mesh.required_vertices);
  out.text("\nEnd\n");
  out.commit();
}

void write_medit_metric(const std::filesystem::path& path, const MetricField& field) {
  AtomicFile out(path);
  out.text("MeshVersionFormatted 2\nDimension 2\n");
  begin_section(out, "SolAtVertices", field.size());
  out.text("1 3\n");
  for (const Metric& m : field) {
    out.real(m.m11);
    out.byte(' ');
    out.real(m.m12);
    out.byte(' ');
    out.real(m.m22);
    out.byte('\n');
  }
  out.text("\nEnd\n");
  out.commit();
}

}  // namespace anisofront
