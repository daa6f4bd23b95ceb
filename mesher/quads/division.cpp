#include "mesher/quads/division.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "mesher/quads/mixed_centre.hpp"
#include "mesher/quads/mixed_midpoint.hpp"
#include "mesher/quads/mixed_topology.hpp"
#include "mesher/quads/pentagons.hpp"

namespace anisofront {
namespace {

/// Longest sub-segment when midpoints are looked for. Edges that are to be halved have length 2:
/// the coarse value means one sample in the middle of most.
constexpr double kAppendixB = 0.25, kCoarse = 1.25;

class Divider {
 public:
  Divider(const Domain& domain, const BackgroundMesh& background, const MixedMesh& mesh,
          double tolerance)
      : domain_(domain),
        background_(background),
        mesh_(mesh),
        topology_(mixed_edges(mesh)),
        finder_(background, tolerance),
        taken_(mesh.faces.size(), 0) {}

  MixedMesh run(bool with_pentagons) {
    renew_old_vertices();
    halve_edges();
    if (with_pentagons) join_triangles();
    collect_cells();
    find_centres();
    if (straighten_edges_of_bad_cells()) find_centres();
    number_midpoints();
    for (std::size_t c = 0; c < cells_.size(); ++c) divide(cells_[c], centres_[c]);
    result_.required.resize(result_.vertices.size(), 0);
    return std::move(result_);
  }

 private:
  const WorkVertex& old_vertex(Index v) const { return result_.vertices[v]; }

  void renew_old_vertices() {
    result_.required = mesh_.required;
    result_.vertices.reserve(mesh_.vertices.size() + topology_.edges.size() + mesh_.faces.size());
    result_.vertices = mesh_.vertices;
    for (WorkVertex& v : result_.vertices) v.r = background_.factor_at(v.p, v.hint);
  }

  void halve_edges() {
    result_.segments.resize(2 * mesh_.segments.size());
    midpoints_.reserve(topology_.edges.size());
    for (const MixedEdge& e : topology_.edges)
      midpoints_.push_back(e.segment == kNoIndex ? finder_.of_edge(old_vertex(e.a), old_vertex(e.b))
                                                 : halve_segment(e.segment));
  }

  /// The new vertex gets its number later.
  WorkVertex halve_segment(Index id) {
    const Segment& s = mesh_.segments[id];
    const auto [t, vertex] =
        finder_.of_segment(domain_.curves[s.curve].curve, s, old_vertex(s.a), old_vertex(s.b));
    Segment first = s, second = s;
    first.parameter_b = second.parameter_a = t;
    result_.segments[2 * id] = first;
    result_.segments[2 * id + 1] = second;
    return vertex;
  }

  Cell cell_of(Index face) const {
    Cell cell{mesh_.faces[face].size(), {}, {}};
    std::copy_n(mesh_.faces[face].vertices.begin(), 4, cell.vertices.begin());
    std::copy_n(topology_.of_face[face].begin(), 4, cell.edges.begin());
    return cell;
  }

  void join_triangles() {
    for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f)
      if (!mesh_.faces[f].is_quad()) join_triangle(f);
  }

  /// Makes a pentagon of the triangle and the best of its neighbours, if there is one.
  void join_triangle(Index f) {
    const Cell triangle = cell_of(f);
    double least = std::numeric_limits<double>::infinity();
    std::optional<std::pair<Index, Cell>> best;
    for (int i = 0; i < 3; ++i) {
      const MixedEdge& edge = topology_.edges[triangle.edges[i]];
      const Index g = edge.left == f ? edge.right : edge.left;
      if (edge.segment != kNoIndex || g == kNoIndex || taken_[g] || !mesh_.faces[g].is_quad())
        continue;
      const Cell pentagon = joined(triangle, i, g);
      const double deviation = deviation_of(pentagon);
      if (deviation >= least || !centre_of(pentagon)) continue;
      least = deviation;
      best = {g, pentagon};
    }
    if (!best) return;
    taken_[f] = taken_[best->first] = 1;
    pentagons_.push_back({f, best->second});
  }

  Cell joined(const Cell& triangle, int i, Index face) const {
    const Cell quad = cell_of(face);
    const auto common = std::find(quad.edges.begin(), quad.edges.end(), triangle.edges[i]);
    return join(triangle, i, quad, static_cast<int>(common - quad.edges.begin()));
  }

  /// Infinite with a flat corner.
  double deviation_of(const Cell& pentagon) const {
    std::array<WorkVertex, 5> vertices;
    std::transform(pentagon.vertices.begin(), pentagon.vertices.end(), vertices.begin(),
                   [this](Index v) { return old_vertex(v); });
    return has_flat_corner(vertices) ? std::numeric_limits<double>::infinity()
                                     : angle_deviation(vertices);
  }

  /// Pentagons stand at the places of their triangles.
  void collect_cells() {
    cells_.reserve(mesh_.faces.size());
    auto pentagon = pentagons_.begin();
    for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f) {
      if (pentagon != pentagons_.end() && pentagon->first == f)
        cells_.push_back((pentagon++)->second);
      else if (!taken_[f])
        cells_.push_back(cell_of(f));
    }
  }

  struct Outline {
    std::array<Point, 5> corners, midpoints;
  };
  Outline outline_of(const Cell& cell) const {
    Outline outline;
    for (int k = 0; k < cell.size; ++k) {
      outline.corners[k] = old_vertex(cell.vertices[k]).p;
      outline.midpoints[k] = midpoints_[cell.edges[k]].p;
    }
    return outline;
  }
  std::optional<Point> centre_of(const Cell& cell) const {
    const Outline outline = outline_of(cell);
    const auto n = static_cast<std::size_t>(cell.size);
    return centre_of_division({outline.corners.data(), n}, {outline.midpoints.data(), n});
  }

  /// Where there is no centre the mean of the midpoints stands in.
  void find_centres() {
    centres_.clear();
    centres_.reserve(cells_.size());
    bad_cells_.clear();
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const std::optional<Point> centre = centre_of(cells_[c]);
      const auto n = static_cast<std::size_t>(cells_[c].size);
      if (!centre) bad_cells_.push_back(c);
      centres_.push_back(centre ? *centre : mean_of({outline_of(cells_[c]).midpoints.data(), n}));
    }
  }

  /// Arithmetic midpoints for the inner edges of cells without a centre. Returns whether there are
  /// any such cells.
  bool straighten_edges_of_bad_cells() {
    for (const std::size_t c : bad_cells_)
      for (int k = 0; k < cells_[c].size; ++k) {
        const MixedEdge& edge = topology_.edges[cells_[c].edges[k]];
        WorkVertex& midpoint = midpoints_[cells_[c].edges[k]];
        if (edge.segment != kNoIndex) continue;
        midpoint.p = 0.5 * (old_vertex(edge.a).p + old_vertex(edge.b).p);
        midpoint.r = background_.factor_at(midpoint.p, midpoint.hint);
      }
    return !bad_cells_.empty();
  }

  /// Edges inside pentagons have none.
  void number_midpoints() {
    std::vector<char> used(midpoints_.size(), 0);
    for (const Cell& cell : cells_)
      for (int k = 0; k < cell.size; ++k) used[cell.edges[k]] = 1;
    number_.assign(midpoints_.size(), kNoIndex);
    for (std::size_t e = 0; e < midpoints_.size(); ++e) {
      if (!used[e]) continue;
      number_[e] = add_vertex(midpoints_[e]);
      const Index s = topology_.edges[e].segment;
      if (s != kNoIndex) result_.segments[2 * s].b = result_.segments[2 * s + 1].a = number_[e];
    }
  }

  Index add_vertex(const WorkVertex& v) {
    result_.vertices.push_back(v);
    return static_cast<Index>(result_.vertices.size()) - 1;
  }

  /// Fig. 11.
  void divide(const Cell& cell, Point centre) {
    WorkVertex vertex{centre, {}, old_vertex(cell.vertices[0]).hint};
    vertex.r = background_.factor_at(centre, vertex.hint);
    const Index d = add_vertex(vertex);
    for (int k = 0, before = cell.size - 1; k < cell.size; before = k++)
      result_.faces.push_back(
          {{cell.vertices[k], number_[cell.edges[k]], d, number_[cell.edges[before]]}});
  }

  const Domain& domain_;
  const BackgroundMesh& background_;
  const MixedMesh& mesh_;
  MixedEdges topology_;
  MidpointFinder finder_;
  std::vector<WorkVertex> midpoints_;              ///< per edge
  std::vector<Index> number_;                      ///< of the midpoint of each edge in the result
  std::vector<char> taken_;                        ///< per face: part of a pentagon
  std::vector<std::pair<Index, Cell>> pentagons_;  ///< with their triangles, ascending
  std::vector<Cell> cells_;
  std::vector<Point> centres_;          ///< per cell
  std::vector<std::size_t> bad_cells_;  ///< without a centre
  MixedMesh result_;
};

}  // namespace

MixedMesh divide_mixed(const Domain& domain, const BackgroundMesh& background,
                       const MixedMesh& mesh, bool with_pentagons) {
  Divider divider(domain, background, mesh, with_pentagons ? kAppendixB : kCoarse);
  return divider.run(with_pentagons);
}

}  // namespace anisofront
