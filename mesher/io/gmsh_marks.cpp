#include "mesher/io/gmsh_marks.hpp"

#include <cmath>

#include "mesher/io/gmsh_content.hpp"

namespace anisofront {

namespace {

std::vector<Index> read_vertices(GmshStream& in, const GmshContent& content,
                                 std::string_view keyword) {
  in.text.expect(keyword);
  std::vector<Index> vertices(static_cast<std::size_t>(in.text.count("a number of nodes", 2)));
  for (Index& v : vertices) v = find_node(in, content, in.text.integer("a node number"));
  return vertices;
}

void write_vertices(AtomicFile& out, std::string_view keyword, const std::vector<Index>& vertices) {
  out.text(keyword);
  out.byte(' ');
  out.integer(static_cast<std::int64_t>(vertices.size()));
  out.byte('\n');
  for (const Index v : vertices) {
    out.integer(v + 1);
    out.byte('\n');
  }
}

bool is_plus_zero(double t) { return t == 0 && !std::signbit(t); }

bool curves_are_elementary(const Mesh& mesh, const GmshEntityPlan& plan) {
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const CurveEdge& edge = mesh.edges[e];
    if (edge.curve != plan.entities[1][plan.edge_curves[e]].tag ||
        !is_plus_zero(edge.parameters[0]) || !is_plus_zero(edge.parameters[1]))
      return false;
  }
  return true;
}

}  // namespace

void read_gmsh_marks(GmshStream& in, GmshContent& content) {
  constexpr std::size_t kLeastBytes = 6;  // "0 0 0\n"
  if (!content.has_elements) in.fail("$Anisofront before $Elements");
  GmshMarks marks;
  marks.corners = read_vertices(in, content, "corners");
  marks.required_vertices = read_vertices(in, content, "required");
  in.text.expect("curves");
  marks.curves.resize(static_cast<std::size_t>(in.text.count("a number of edges", kLeastBytes)));
  for (GmshMarks::EdgeCurve& edge : marks.curves) {
    edge.curve = in.text.index("the number of a curve");
    for (double& t : edge.parameters) t = in.text.real("a curve parameter");
  }
  content.marks = std::move(marks);
}

void write_gmsh_marks(AtomicFile& out, const Mesh& mesh, const GmshEntityPlan& plan) {
  out.text("$Anisofront\n");
  write_vertices(out, "corners", mesh.corners);
  write_vertices(out, "required", mesh.required_vertices);
  const bool omit = curves_are_elementary(mesh, plan);
  out.text("curves ");
  out.integer(omit ? 0 : static_cast<std::int64_t>(mesh.edges.size()));
  out.byte('\n');
  for (std::size_t e = 0; !omit && e < mesh.edges.size(); ++e) {
    out.integer(mesh.edges[e].curve);
    for (const double t : mesh.edges[e].parameters) {
      out.byte(' ');
      out.real(t);
    }
    out.byte('\n');
  }
  out.text("$EndAnisofront\n");
}

}  // namespace anisofront
