#include "mesher/io/mesh_arrays.hpp"

#include <algorithm>

#include "mesher/geometry/error.hpp"

namespace anisofront {

namespace {

struct Checker {
  const std::string& name;
  std::size_t vertex_count;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("cannot write " + name + ": " + what);
  }

  void length(std::size_t found, std::size_t expected, const std::string& what) const {
    if (found != expected)
      fail(what + " has " + std::to_string(found) + " entries, expected " +
           std::to_string(expected));
  }

  template <class Vertices>
  void vertices(const Vertices& numbers, const char* what) const {
    for (const Index v : numbers)
      if (v < 0 || static_cast<std::size_t>(v) >= vertex_count)
        fail(std::string(what) + " names vertex index " + std::to_string(v) + " of " +
             std::to_string(vertex_count));
  }

  void fields(const std::vector<FileField>& list, std::size_t count) const {
    for (const FileField& field : list) {
      if (field.components != 1 && field.components != 3 && field.components != 9)
        fail("field '" + field.name + "' has " + std::to_string(field.components) +
             " components, expected 1, 3 or 9");
      length(field.values.size(), count * static_cast<std::size_t>(field.components),
             "field '" + field.name + "'");
    }
  }
};

}  // namespace

void require_writable(const Mesh& mesh, const std::string& name) {
  const Checker check{name, mesh.points.size()};
  for (const Triangle& triangle : mesh.triangles) check.vertices(triangle, "a triangle");
  for (const Quad& quad : mesh.quads) check.vertices(quad, "a quad");
  for (const CurveEdge& edge : mesh.edges) check.vertices(edge.vertices, "a curve edge");
  check.vertices(mesh.corners, "the list of corners");
  check.vertices(mesh.required_vertices, "the list of required vertices");
  check.length(mesh.triangle_regions.size(), mesh.triangles.size(), "triangle_regions");
  check.length(mesh.quad_regions.size(), mesh.quads.size(), "quad_regions");
  if (!mesh.vertex_tags.empty())
    check.length(mesh.vertex_tags.size(), mesh.points.size(), "vertex_tags");
}

void require_writable(const MeshFile& file, const std::string& name) {
  require_writable(file.mesh, name);
  const Checker check{name, file.mesh.points.size()};
  check.fields(file.vertex_fields, file.mesh.points.size());
  check.fields(file.element_fields, file.mesh.triangles.size() + file.mesh.quads.size());
}

}  // namespace anisofront
