#include "mesher/io/vtu.hpp"

#include "mesher/io/atomic_file.hpp"
#include "mesher/io/mesh_arrays.hpp"
#include "mesher/io/xml.hpp"

namespace anisofront {

namespace {

// Cell types of the VTK file formats document.
enum VtkCell { kVtkLine = 3, kVtkTriangle = 5, kVtkQuad = 9 };

void begin_array(AtomicFile& out, std::string_view type, const std::string& name, int components) {
  out.text("<DataArray type=\"");
  out.text(type);
  out.text("\" Name=\"" + xml_escaped(name) + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"ascii\">\n");
}

void end_array(AtomicFile& out) { out.text("\n</DataArray>\n"); }

void integers(AtomicFile& out, const std::vector<Index>& values) {
  for (const Index value : values) {
    out.integer(value);
    out.byte('\n');
  }
}

void repeat(AtomicFile& out, Index value, std::size_t times) {
  for (std::size_t i = 0; i < times; ++i) {
    out.integer(value);
    out.byte('\n');
  }
}

template <class Element>
void connectivity(AtomicFile& out, const Element& element) {
  for (const Index v : element) {
    out.integer(v);
    out.byte(' ');
  }
  out.byte('\n');
}

void write_points(AtomicFile& out, const Mesh& mesh) {
  out.text("<Points>\n");
  begin_array(out, "Float64", "points", 3);
  for (const Point p : mesh.points) {
    out.real(p.x);
    out.byte(' ');
    out.real(p.y);
    out.text(" 0\n");
  }
  end_array(out);
  out.text("</Points>\n");
}

void write_offsets(AtomicFile& out, const Mesh& mesh) {
  std::int64_t offset = 0;
  const auto step = [&](std::size_t times, int corners) {
    for (std::size_t i = 0; i < times; ++i) {
      out.integer(offset += corners);
      out.byte('\n');
    }
  };
  begin_array(out, "Int64", "offsets", 1);
  step(mesh.edges.size(), 2);
  step(mesh.triangles.size(), 3);
  step(mesh.quads.size(), 4);
  end_array(out);
}

void write_cells(AtomicFile& out, const Mesh& mesh) {
  out.text("<Cells>\n");
  begin_array(out, "Int64", "connectivity", 1);
  for (const CurveEdge& edge : mesh.edges) connectivity(out, edge.vertices);
  for (const Triangle& triangle : mesh.triangles) connectivity(out, triangle);
  for (const Quad& quad : mesh.quads) connectivity(out, quad);
  end_array(out);
  write_offsets(out, mesh);
  begin_array(out, "UInt8", "types", 1);
  repeat(out, kVtkLine, mesh.edges.size());
  repeat(out, kVtkTriangle, mesh.triangles.size());
  repeat(out, kVtkQuad, mesh.quads.size());
  end_array(out);
  out.text("</Cells>\n");
}

/// `leading_zeros` entries of zeros, then the field.
void write_field(AtomicFile& out, const FileField& field, const std::string& name,
                 std::size_t leading_zeros) {
  const auto components = static_cast<std::size_t>(field.components);
  begin_array(out, "Float64", name, field.components);
  repeat(out, 0, leading_zeros * components);
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    out.real(field.values[i]);
    out.byte((i + 1) % components == 0 ? '\n' : ' ');
  }
  end_array(out);
}

/// Arrays need different names: fields of the same name get their step appended.
void write_fields(AtomicFile& out, const std::vector<FileField>& fields,
                  std::size_t leading_zeros) {
  for (const FileField& field : fields) {
    int same = 0;
    for (const FileField& other : fields) same += other.name == field.name;
    const std::string suffix = same > 1 ? " (step " + std::to_string(field.step) + ")" : "";
    write_field(out, field, field.name + suffix, leading_zeros);
  }
}

void write_point_data(AtomicFile& out, const MeshFile& file) {
  out.text("<PointData>\n");
  if (!file.mesh.vertex_tags.empty()) {
    begin_array(out, "Int32", "vertex_tag", 1);
    integers(out, file.mesh.vertex_tags);
    end_array(out);
  }
  write_fields(out, file.vertex_fields, 0);
  out.text("</PointData>\n");
}

void write_cell_data(AtomicFile& out, const MeshFile& file) {
  const Mesh& mesh = file.mesh;
  out.text("<CellData>\n");
  begin_array(out, "Int32", "tag", 1);
  for (const CurveEdge& edge : mesh.edges) repeat(out, edge.tag, 1);
  repeat(out, 0, mesh.triangles.size() + mesh.quads.size());
  end_array(out);
  begin_array(out, "Int32", "region", 1);
  repeat(out, 0, mesh.edges.size());
  integers(out, mesh.triangle_regions);
  integers(out, mesh.quad_regions);
  end_array(out);
  write_fields(out, file.element_fields, mesh.edges.size());
  out.text("</CellData>\n");
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const MeshFile& file) {
  require_writable(file, path.string());
  const Mesh& mesh = file.mesh;
  AtomicFile out(path);
  out.text(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  out.text("<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
           std::to_string(mesh.edges.size() + mesh.triangles.size() + mesh.quads.size()) + "\">\n");
  write_points(out, mesh);
  write_cells(out, mesh);
  write_point_data(out, file);
  write_cell_data(out, file);
  out.text("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  out.commit();
}

}  // namespace anisofront
