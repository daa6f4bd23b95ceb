#include "mesher/mesh/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>
#include <tuple>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/predicates.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {

namespace {

constexpr int kSentencesPerKind = 10;

/// Collects at most ten sentences of one kind of defect.
class Kind {
 public:
  explicit Kind(MeshReport& report) : report_(report) {}
  /// `sentence` is only called while there is room.
  template <class Sentence>
  void add(Sentence sentence) {
    if (count_++ < kSentencesPerKind) report_.defects.push_back(sentence());
  }
  bool none() const { return count_ == 0; }

 private:
  MeshReport& report_;
  std::int64_t count_ = 0;
};

/// "vertex 3 at (0, 1)".
std::string vertex_text(const Mesh& mesh, Index v) {
  return "vertex " + std::to_string(v + 1) + " at " + describe(mesh.points[v]);
}

/// "triangle 3" or "quad 2" for an element numbered like in VertexStars.
std::string element_text(const Mesh& mesh, Index element) {
  const Index quad = element - static_cast<Index>(mesh.triangles.size());
  return quad < 0 ? "triangle " + std::to_string(element + 1) : "quad " + std::to_string(quad + 1);
}

std::string edge_text(const Mesh& mesh, Index from, Index to) {
  return "edge " + std::to_string(from + 1) + " " + std::to_string(to + 1) + " from " +
         describe(mesh.points[from]) + " to " + describe(mesh.points[to]);
}

bool in_range(const Mesh& mesh, Index v) {
  return v >= 0 && v < static_cast<Index>(mesh.points.size());
}

void check_size(MeshReport& report, const char* name, std::size_t found, std::size_t expected) {
  if (found != expected)
    report.defects.push_back(std::string(name) + " has " + std::to_string(found) +
                             " entries, expected " + std::to_string(expected));
}

void check_sizes(const Mesh& mesh, MeshReport& report) {
  check_size(report, "triangle_regions", mesh.triangle_regions.size(), mesh.triangles.size());
  check_size(report, "quad_regions", mesh.quad_regions.size(), mesh.quads.size());
  if (!mesh.vertex_tags.empty())
    check_size(report, "vertex_tags", mesh.vertex_tags.size(), mesh.points.size());
  if (mesh.triangles.empty() && mesh.quads.empty())
    report.defects.push_back("the mesh has no triangles and no quads");
}

void check_coordinates(const Mesh& mesh, MeshReport& report) {
  Kind kind(report);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!std::isfinite(mesh.points[v].x) || !std::isfinite(mesh.points[v].y))
      kind.add([&] { return vertex_text(mesh, static_cast<Index>(v)) + " is not finite"; });
}

template <class Vertices>
void check_range(const Mesh& mesh, const char* name, std::size_t number, const Vertices& vertices,
                 Kind& kind) {
  for (const Index v : vertices)
    if (!in_range(mesh, v))
      kind.add([&] {
        return std::string(name) + " " + std::to_string(number + 1) + " refers to vertex " +
               std::to_string(std::int64_t{v} + 1) + ", expected 1 to " +
               std::to_string(mesh.points.size());
      });
}

void check_ranges(const Mesh& mesh, MeshReport& report) {
  Kind kind(report);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    check_range(mesh, "triangle", t, mesh.triangles[t], kind);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    check_range(mesh, "quad", q, mesh.quads[q], kind);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    check_range(mesh, "curve edge", e, mesh.edges[e].vertices, kind);
  check_range(mesh, "corners, entry", 0, mesh.corners, kind);
  check_range(mesh, "required_vertices, entry", 0, mesh.required_vertices, kind);
}

void check_orientation(const Mesh& mesh, MeshReport& report) {
  Kind flat_triangles(report), bad_quads(report);
  const std::vector<Point>& p = mesh.points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (orientation(p[a], p[b], p[c]) <= 0)
      flat_triangles.add([&] {
        return "triangle " + std::to_string(t + 1) + " with vertices " + std::to_string(a + 1) +
               " " + std::to_string(b + 1) + " " + std::to_string(c + 1) +
               " is flat or clockwise, first " + vertex_text(mesh, a);
      });
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (std::size_t k = 0; k < 4; ++k) {
      const Quad& quad = mesh.quads[q];
      if (orientation(p[quad[(k + 3) % 4]], p[quad[k]], p[quad[(k + 1) % 4]]) <= 0)
        bad_quads.add([&] {
          return "quad " + std::to_string(q + 1) + " is flat, concave or clockwise at its corner " +
                 vertex_text(mesh, quad[k]);
        });
    }
}

/// Bits of a coordinate, equal for equal numbers (-0 becomes +0).
std::uint64_t bits(double x) {
  const double normal = x + 0.0;
  std::uint64_t result;
  std::memcpy(&result, &normal, sizeof result);
  return result;
}

/// Open addressing over vertex numbers: one look at a random place per vertex, no sort.
void check_duplicates(const Mesh& mesh, MeshReport& report) {
  Kind kind(report);
  int log_size = 4;
  while ((std::size_t{1} << log_size) < 2 * mesh.points.size()) ++log_size;
  const std::size_t mask = (std::size_t{1} << log_size) - 1;
  std::vector<Index> table(mask + 1, kNoIndex);
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v) {
    const Point p = mesh.points[v];
    const std::uint64_t mixed =
        (bits(p.x) * 0x9e3779b97f4a7c15U ^ (bits(p.y) >> 29)) * 0xbf58476d1ce4e5b9U +
        bits(p.y) * 0x94d049bb133111ebU;
    std::size_t place = (mixed ^ (mixed >> 31)) * 0x9e3779b97f4a7c15U >> (64 - log_size);
    while (table[place] != kNoIndex && mesh.points[table[place]] != p) place = (place + 1) & mask;
    if (table[place] == kNoIndex)
      table[place] = v;
    else
      kind.add([&] {
        return vertex_text(mesh, v) + " coincides with vertex " + std::to_string(table[place] + 1);
      });
  }
}

Index check_unused(const Mesh& mesh, MeshReport& report) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) used[v] = 1;
  for (const Quad& q : mesh.quads)
    for (const Index v : q) used[v] = 1;
  Kind kind(report);
  Index count = 0;
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v) {
    count += used[v];
    if (!used[v]) kind.add([&] { return vertex_text(mesh, v) + " belongs to no element"; });
  }
  return count;
}

void report_conflicts(const Mesh& mesh, std::span<const EdgeConflict> conflicts,
                      MeshReport& report) {
  const HalfEdges edges = half_edges(mesh);
  Kind directions(report), shared(report);
  for (const EdgeConflict& conflict : conflicts) {
    const HalfEdge e = edges[conflict.second];
    const auto sentence = [&] {
      return edge_text(mesh, e.from, e.to) +
             (conflict.same_direction ? " is run through in one direction by "
                                      : " belongs to more than two elements, among them ") +
             element_text(mesh, edges.element(conflict.first)) + " and " +
             element_text(mesh, edges.element(conflict.second));
    };
    (conflict.same_direction ? directions : shared).add(sentence);
  }
}

/// Curve edges sorted by vertices, with the buckets of their smaller vertex.
struct CurveEdgeTable {
  struct Entry {
    Index smaller, larger, edge;
    bool found = false;
  };
  std::vector<Entry> entries;
  std::vector<Index> first;

  explicit CurveEdgeTable(const Mesh& mesh) : first(mesh.points.size() + 1, 0) {
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto [a, b] = mesh.edges[e].vertices;
      entries.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(e)});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.smaller, a.larger, a.edge) < std::tie(b.smaller, b.larger, b.edge);
    });
    for (const Entry& e : entries) ++first[static_cast<std::size_t>(e.smaller) + 1];
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  }

  /// Marks the curve edges between two vertices (a file may list one twice); false if none.
  bool mark(Index a, Index b) {
    const Index smaller = std::min(a, b), larger = std::max(a, b);
    const auto end = entries.begin() + first[static_cast<std::size_t>(smaller) + 1];
    auto entry = std::lower_bound(entries.begin() + first[smaller], end, larger,
                                  [](const Entry& e, Index v) { return e.larger < v; });
    const bool known = entry != end && entry->larger == larger;
    for (; entry != end && entry->larger == larger; ++entry) entry->found = true;
    return known;
  }
};

void check_curve_edges(const Mesh& mesh, std::span<const Index> twin, MeshReport& report) {
  if (mesh.edges.empty()) return;
  CurveEdgeTable table(mesh);
  const HalfEdges edges = half_edges(mesh);
  Kind missing(report), strangers(report);
  for (Index h = 0; h < edges.count(); ++h) {
    if (twin[h] != kNoIndex && twin[h] < h) continue;
    const HalfEdge e = edges[h];
    if (!table.mark(e.from, e.to) && twin[h] == kNoIndex)
      missing.add([&] { return "boundary " + edge_text(mesh, e.from, e.to) + " is on no curve"; });
  }
  for (const CurveEdgeTable::Entry& entry : table.entries)
    if (!entry.found)
      strangers.add([&] {
        const auto [a, b] = mesh.edges[entry.edge].vertices;
        return "curve " + edge_text(mesh, a, b) + " is no edge of any element";
      });
}

Index root_of(std::vector<Index>& parent, Index e) {
  while (parent[e] != e) e = parent[e] = parent[parent[e]];
  return e;
}

Index count_components(const Mesh& mesh, std::span<const Index> twin) {
  const HalfEdges edges = half_edges(mesh);
  const std::size_t elements = mesh.triangles.size() + mesh.quads.size();
  std::vector<Index> parent(elements);
  std::iota(parent.begin(), parent.end(), 0);
  Index components = static_cast<Index>(elements);
  for (Index h = 0; h < edges.count(); ++h) {
    if (twin[h] <= h) continue;
    const Index a = root_of(parent, edges.element(h));
    const Index b = root_of(parent, edges.element(twin[h]));
    if (a == b) continue;
    parent[std::max(a, b)] = std::min(a, b);
    --components;
  }
  return components;
}

/// Compensated sum (Neumaier): areas of 1e6 elements still agree to rounding.
class Sum {
 public:
  void add(double x) {
    const double t = sum_ + x;
    rest_ += std::fabs(sum_) >= std::fabs(x) ? (sum_ - t) + x : (x - t) + sum_;
    sum_ = t;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0, rest_ = 0;
};

double element_area(const Mesh& mesh) {
  const std::vector<Point>& p = mesh.points;
  Sum sum;
  for (const Triangle& t : mesh.triangles) sum.add(twice_area(p[t[0]], p[t[1]], p[t[2]]));
  for (const Quad& q : mesh.quads) sum.add(cross(p[q[2]] - p[q[0]], p[q[3]] - p[q[1]]));
  return 0.5 * sum.value();
}

void check_area(const Mesh& mesh, std::span<const Index> twin, MeshReport& report) {
  const HalfEdges edges = half_edges(mesh);
  const Point origin = mesh.points.front();
  Sum sum, magnitude;
  for (Index h = 0; h < edges.count(); ++h) {
    if (twin[h] != kNoIndex) continue;
    const Vector a = mesh.points[edges[h].from] - origin, b = mesh.points[edges[h].to] - origin;
    sum.add(cross(a, b));
    magnitude.add(std::fabs(a.x * b.y) + std::fabs(a.y * b.x));
  }
  report.area = element_area(mesh);
  report.boundary_area = 0.5 * sum.value();
  // The second term is the rounding of the shoelace formula, which long thin domains show.
  const double tolerance = 1e-12 * report.area + 1e-15 * magnitude.value();
  if (!(std::fabs(report.area - report.boundary_area) <= tolerance))
    report.defects.push_back("the areas of the elements sum to " + describe(report.area) +
                             ", the boundary encloses " + describe(report.boundary_area) +
                             ", the difference is " + describe(report.area - report.boundary_area));
}

void check_topology(const Mesh& mesh, MeshReport& report) {
  const Index used = check_unused(mesh, report);
  const HalfEdgeTwins twins = half_edge_twins(half_edges(mesh), report.vertices);
  report_conflicts(mesh, twins.conflicts, report);
  const std::span<const Index> twin = twins.twin;
  report.boundary_edges = static_cast<Index>(std::count(twin.begin(), twin.end(), kNoIndex));
  const Index half_edge_count = static_cast<Index>(twin.size());
  report.edges = report.boundary_edges + (half_edge_count - report.boundary_edges) / 2;
  report.components = count_components(mesh, twin);
  const Index elements = report.triangles + report.quads;
  report.holes = report.components - (used - report.edges + elements);
  check_curve_edges(mesh, twin, report);
  if (twins.conflicts.empty() && elements > 0) check_area(mesh, twin, report);
}

}  // namespace

MeshReport check_mesh(const Mesh& mesh) {
  MeshReport report;
  report.vertices = static_cast<Index>(mesh.points.size());
  report.triangles = static_cast<Index>(mesh.triangles.size());
  report.quads = static_cast<Index>(mesh.quads.size());
  check_coordinates(mesh, report);
  check_ranges(mesh, report);
  const bool readable = report.defects.empty();
  check_sizes(mesh, report);
  if (!readable) return report;  // what follows relies on numbers and coordinates
  check_orientation(mesh, report);
  check_duplicates(mesh, report);
  check_topology(mesh, report);
  return report;
}

namespace {

std::string message_of(std::string message, const MeshReport& report) {
  for (const std::string& defect : report.defects) message += "\n  " + defect;
  return message;
}

}  // namespace

void require_valid(const Mesh& mesh) {
  const MeshReport report = check_mesh(mesh);
  if (!report.valid()) throw MeshingError(message_of("the mesh is not valid:", report));
}

void require_usable(const Mesh& mesh, const std::string& name) {
  MeshReport report;
  check_coordinates(mesh, report);
  check_ranges(mesh, report);
  const bool readable = report.defects.empty();
  check_sizes(mesh, report);
  if (readable) check_orientation(mesh, report);
  if (readable) check_duplicates(mesh, report);
  if (!report.valid())
    throw InputError(message_of(name + ": the mesh cannot be used, mend it first:", report));
}

}  // namespace anisofront
