#pragma once

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include "mesher/geometry/error.hpp"
#include "mesher/io/gmsh.hpp"

namespace anisofront::test {

/// A directory that vanishes with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "anisofront-io-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~Scratch() { std::filesystem::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// The message of the error that `action` throws, "" when it throws none.
template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Collects warnings.
struct Warnings {
  std::vector<std::string> messages;
  Monitor monitor{.warn = [this](const std::string& m) { messages.push_back(m); }, .progress = {}};
};

/// Equal bits: tells 0 from -0 and finds NaN equal to itself.
inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

inline std::vector<double> coordinates(const Mesh& mesh) {
  std::vector<double> values;
  for (const Point p : mesh.points) values.insert(values.end(), {p.x, p.y});
  return values;
}

inline std::vector<double> parameters(const Mesh& mesh) {
  std::vector<double> values;
  for (const CurveEdge& e : mesh.edges)
    values.insert(values.end(), {e.parameters[0], e.parameters[1]});
  return values;
}

inline bool same_edges(const Mesh& a, const Mesh& b) {
  const auto same = [](const CurveEdge& e, const CurveEdge& f) {
    return e.vertices == f.vertices && e.tag == f.tag && e.curve == f.curve;
  };
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), same) &&
         same_bits(parameters(a), parameters(b));
}

/// The names of the arrays that differ, "" for equal meshes.
inline std::string differences(const Mesh& a, const Mesh& b) {
  std::string names;
  if (!same_bits(coordinates(a), coordinates(b))) names += " points";
  if (a.triangles != b.triangles) names += " triangles";
  if (a.quads != b.quads) names += " quads";
  if (a.triangle_regions != b.triangle_regions) names += " triangle_regions";
  if (a.quad_regions != b.quad_regions) names += " quad_regions";
  if (!same_edges(a, b)) names += " edges";
  if (a.vertex_tags != b.vertex_tags) names += " vertex_tags";
  if (a.corners != b.corners) names += " corners";
  if (a.required_vertices != b.required_vertices) names += " required_vertices";
  if (a.groups != b.groups) names += " groups";
  return names;
}

inline bool same_fields(const std::vector<FileField>& a, const std::vector<FileField>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const FileField& f, const FileField& g) {
        return f.name == g.name && f.components == g.components && same_bits(f.values, g.values) &&
               same_bits({f.time}, {g.time}) && f.step == g.step;
      });
}

inline std::string differences(const MeshFile& a, const MeshFile& b) {
  std::string names = differences(a.mesh, b.mesh);
  if (!same_fields(a.vertex_fields, b.vertex_fields)) names += " vertex_fields";
  if (!same_fields(a.element_fields, b.element_fields)) names += " element_fields";
  return names;
}

/// The unit square with two triangles (regions 1 and 2) and, to its right, one quad (region 2):
///   3---2---5
///   | / |   |
///   0---1---4
inline MeshFile small_file() {
  MeshFile file;
  Mesh& mesh = file.mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_regions = {1, 2};
  mesh.quads = {{1, 4, 5, 2}};
  mesh.quad_regions = {2};
  mesh.edges = {{{0, 1}, 10, 3, {0, 0}}, {{1, 4}, 10, 3, {0, 0}}, {{3, 0}, 11, 5, {0, 0}}};
  mesh.groups = {{1, 10, "the wall"}, {2, 1, "left part"}, {0, 4, "corner"}};
  return file;
}

inline constexpr GmshFormat kFlavours[] = {{GmshVersion::v2_2, false},
                                           {GmshVersion::v2_2, true},
                                           {GmshVersion::v4_1, false},
                                           {GmshVersion::v4_1, true}};

}  // namespace anisofront::test
