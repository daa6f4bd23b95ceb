#include "drivers/report/mesh_blob.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/report/blob_writer.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/statistics.hpp"

namespace anisofront {
namespace {

/// Box of the points; of extent 1 where they are one point.
struct Frame {
  Point centre;
  double extent = 1;
};

Frame frame_of(const std::vector<Point>& points) {
  if (points.empty()) return {};
  Point low = points[0], high = points[0];
  for (const Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double extent = std::max(high.x - low.x, high.y - low.y);
  return {0.5 * (low + high), extent > 0 ? extent : 1};
}

std::vector<Index> corners_of(const Mesh& mesh) {
  std::vector<Index> corners;
  for (const Triangle& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  for (const Quad& q : mesh.quads) corners.insert(corners.end(), q.begin(), q.end());
  return corners;
}

void add_corners(const Mesh& mesh, BlobWriter& blob) {
  constexpr std::size_t kRecent = 127;
  constexpr std::int64_t kFar = -1;
  std::vector<Index> recent;  // latest last
  Index highest = kNoIndex;
  Codes codes, far;
  for (const Index v : corners_of(mesh)) {
    const auto place = std::find(recent.rbegin(), recent.rend(), v);
    if (place != recent.rend()) {
      codes.push_back(place - recent.rbegin() + 1);
      recent.erase(std::next(place).base());
    } else if (v == highest + 1) {
      codes.push_back(0);
    } else {
      codes.push_back(kFar);
      far.push_back(v);
    }
    highest = std::max(highest, v);
    recent.push_back(v);
    if (recent.size() > kRecent) recent.erase(recent.begin());
  }
  blob.add("corner-recent", "corner", {codes}, After::nothing);
  blob.add("corner-far", "corner", {far}, After::previous);
}

/// Of the unit in which a vertex is placed.
std::vector<int> point_exponents(const Mesh& mesh, const Frame& frame,
                                 const std::vector<std::array<Index, 2>>& edges) {
  constexpr int kEdgeBits = 11, kMeshBits = 28;
  const int finest = std::ilogb(frame.extent) - kMeshBits;
  std::vector<double> shortest(mesh.points.size(), 0);
  for (const auto& edge : edges) {
    const double length = norm(mesh.points[edge[1]] - mesh.points[edge[0]]);
    for (const Index v : edge)
      shortest[v] = shortest[v] > 0 ? std::min(shortest[v], length) : length;
  }
  std::vector<int> exponents(shortest.size(), finest);
  for (std::size_t v = 0; v < shortest.size(); ++v)
    if (shortest[v] > 0) exponents[v] = std::max(finest, std::ilogb(shortest[v]) - kEdgeBits);
  return exponents;
}

void add_points(const Mesh& mesh, const Frame& frame,
                const std::vector<std::array<Index, 2>>& edges, BlobWriter& blob) {
  const std::vector<int> exponents = point_exponents(mesh, frame, edges);
  blob.add("point-exponent", "vertex", {Codes(exponents.begin(), exponents.end())},
           After::neighbours);
  std::vector<Point> from_centre;
  for (const Point p : mesh.points) from_centre.push_back(p - frame.centre);
  blob.add_points(from_centre, exponents);
}

Json names_of(const Mesh& mesh, int dimension, const std::set<Index>& tags) {
  Json names = Json::object();
  for (const Index tag : tags) names[std::to_string(tag)] = group_name(mesh, dimension, tag);
  return names;
}

void add_curves(const Mesh& mesh, BlobWriter& blob) {
  Codes vertices, tags;
  for (const CurveEdge& edge : mesh.edges) {
    vertices.insert(vertices.end(), edge.vertices.begin(), edge.vertices.end());
    tags.push_back(edge.tag);
  }
  blob.set("curves", names_of(mesh, 1, {tags.begin(), tags.end()}));
  blob.add("curve-edge", "curve-edge", {vertices}, After::previous);
  blob.add("curve-tag", "curve-edge", {tags}, After::previous);
}

void add_regions(const Mesh& mesh, BlobWriter& blob) {
  Codes regions(mesh.triangle_regions.begin(), mesh.triangle_regions.end());
  regions.insert(regions.end(), mesh.quad_regions.begin(), mesh.quad_regions.end());
  const std::set<Index> tags(regions.begin(), regions.end());
  blob.set("regions", names_of(mesh, 2, tags));
  if (tags.size() > 1) blob.add("region", "element", {regions}, After::previous);
}

/// log2(M^(-1/2)) as its entries xx, xy, yy.
Components log_sizes(const MetricField& field) {
  Components entries(3);
  for (const Metric& metric : field) {
    const PrincipalAxes axes = principal_axes(metric);
    const double l1 = std::log2(axes.h1), l2 = std::log2(axes.h2);
    entries[0].push_back(l1 * axes.e1.x * axes.e1.x + l2 * axes.e2.x * axes.e2.x);
    entries[1].push_back(l1 * axes.e1.x * axes.e1.y + l2 * axes.e2.x * axes.e2.y);
    entries[2].push_back(l1 * axes.e1.y * axes.e1.y + l2 * axes.e2.y * axes.e2.y);
  }
  return entries;
}

void add_metric(const Mesh& mesh, const MetricFunction& metric, BlobWriter& blob) {
  MetricField field;
  for (const Point p : mesh.points) field.push_back(metric(p));
  blob.add_values("metric", "vertex", log_sizes(field), After::neighbours, {false, 1. / 256});
  blob.add_values("quality", "element", {element_qualities(mesh, field)}, After::previous,
                  {false, 1. / 1024});
  // 63 steps to a factor of 2: its square root lies between two codes.
  blob.add_values("edge-length", "edge", {edge_lengths(mesh, metric)}, After::nothing,
                  {true, 1. / 63});
}

std::vector<double> component(const FileField& field, std::size_t first) {
  std::vector<double> values;
  for (std::size_t i = first; i < field.values.size(); i += field.components)
    values.push_back(field.values[i]);
  return values;
}

std::vector<double> sizes_of_vectors(const FileField& field) {
  std::vector<double> sizes = component(field, 0);
  const std::vector<double> y = component(field, 1), z = component(field, 2);
  for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = std::hypot(sizes[i], y[i], z[i]);
  return sizes;
}

struct Scalars {
  std::string name;
  std::vector<double> values;
};

/// What the viewer can colour by.
std::vector<Scalars> scalars_of(const FileField& field) {
  if (field.components == 1) return {{field.name, field.values}};
  if (field.components == 3 && field.name != "moments")
    return {{"|" + field.name + "|", sizes_of_vectors(field)}};
  if (field.components == 9 && field.name == "metric") return {};
  const std::array<std::size_t, 3> entries = field.components == 9
                                                 ? std::array<std::size_t, 3>{0, 4, 1}
                                                 : std::array<std::size_t, 3>{0, 1, 2};
  return {{field.name + " xx", component(field, entries[0])},
          {field.name + " yy", component(field, entries[1])},
          {field.name + " xy", component(field, entries[2])}};
}

void add_fields(const MeshFile& file, BlobWriter& blob) {
  for (const FileField& field : file.vertex_fields)
    for (const auto& [name, values] : scalars_of(field))
      blob.add_values(name, "vertex", {values}, After::neighbours, scale_for(values, false));
  for (const FileField& field : file.element_fields)
    for (const auto& [name, values] : scalars_of(field))
      blob.add_values(name, "element", {values}, After::previous, scale_for(values, true));
}

}  // namespace

std::vector<std::string> mesh_blob(const MeshFile& file, const MetricFunction& metric,
                                   const std::string& note) {
  const Mesh& mesh = file.mesh;
  const std::vector<std::array<Index, 2>> edges = mesh_edges(mesh);
  const Frame frame = frame_of(mesh.points);
  BlobWriter blob(mesh);
  blob.set("vertices", mesh.points.size());
  blob.set("triangles", mesh.triangles.size());
  blob.set("quads", mesh.quads.size());
  blob.set("edges", edges.size());
  blob.set("centre", {frame.centre.x, frame.centre.y});
  if (!note.empty()) blob.set("note", note);
  add_corners(mesh, blob);
  add_points(mesh, frame, edges, blob);
  add_curves(mesh, blob);
  add_regions(mesh, blob);
  if (metric && !edges.empty()) add_metric(mesh, metric, blob);
  add_fields(file, blob);
  return blob.blocks();
}

}  // namespace anisofront
