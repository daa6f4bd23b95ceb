#include "mesher/quads/quad_work.hpp"

#include <cmath>
#include <utility>

#include "mesher/quads/convexity.hpp"

namespace anisofront {
namespace {

/// Angle at vertex h leaves, between its edge and the one before it, in the metric there.
double corner_angle(const QuadMesh& mesh, Index h) {
  const WorkVertex& v = mesh.vertex_at(h);
  return angle(metric_of(v.r), mesh.vertex_at(next_in_quad(h)).p - v.p,
               mesh.vertex_at(previous_in_quad(h)).p - v.p);
}

int square(int x) { return x * x; }

}  // namespace

QuadWork::QuadWork(const BackgroundMesh& background_mesh, QuadMesh quad_mesh,
                   const QuadWeights& quad_weights)
    : background(background_mesh),
      mesh(std::move(quad_mesh)),
      weights(quad_weights),
      changed_at(mesh.vertices.size(), 1),
      quad_stamp_(mesh.quad_count(), 0),
      vertex_stamp_(mesh.vertices.size(), 0) {
  update_all_energies();
  set_ideal_valences();
}

/// Inside 4, on the boundary the number of right angles (in the metric) that fit.
void QuadWork::set_ideal_valences() {
  constexpr double kRightAngle = 1.5707963267948966;
  ideal.assign(mesh.vertices.size(), 4);
  for (Index v = 0; v < static_cast<Index>(ideal.size()); ++v) {
    if (!mesh.on_boundary(v) || mesh.leaving[v] == kNoIndex) continue;
    double sum = 0;
    for_each_leaving(mesh, v, [&](Index h) { sum += corner_angle(mesh, h); });
    ideal[v] = static_cast<std::uint8_t>(std::clamp(std::lround(sum / kRightAngle), 1L, 8L));
  }
}

void QuadWork::allow_sliding(const Domain& with_curves, std::vector<Segment> on_curves,
                             const std::vector<Index>& pinned) {
  domain = &with_curves;
  segments = std::move(on_curves);
  tracks.assign(mesh.vertices.size(), {});
  std::vector<char> many(tracks.size(), 0);
  for (std::size_t v = 0; v < many.size(); ++v)
    many[v] = mesh.next_copy[v] != static_cast<Index>(v);
  const auto enter = [&](Index& place, Index v, std::size_t segment) {
    if (place != kNoIndex) many[v] = 1;
    place = static_cast<Index>(segment);
  };
  for (std::size_t s = 0; s < segments.size(); ++s) {
    enter(tracks[segments[s].b].before, segments[s].b, s);
    enter(tracks[segments[s].a].after, segments[s].a, s);
  }
  for (const Index v : pinned)
    if (v != kNoIndex) many[v] = 1;
  for (std::size_t v = 0; v < tracks.size(); ++v) {
    SlideTrack& track = tracks[v];
    const bool between = !many[v] && track.before != kNoIndex && track.after != kNoIndex &&
                         segments[track.before].curve == segments[track.after].curve &&
                         segments[track.before].parameter_b == segments[track.after].parameter_a;
    if (!between) track = {};
  }
}

QuadShape QuadWork::shape_of(Index quad) const {
  const Index h = 4 * quad;
  const WorkVertex& p = mesh.vertex_at(h);
  return quad_shape(quad_view(mesh.vertex_at(h + 1), mesh.vertex_at(h + 2), mesh.vertex_at(h + 3)),
                    p.p, p.r, inverse_of(p.r));
}

double QuadWork::beta_of(Index quad) const {
  const QuadShape shape = shape_of(quad);
  return shape.least > 0 ? shape.beta() : std::min(shape.least, 0.);
}

QuadWork::Energy QuadWork::energy_of(Index quad) const {
  constexpr double kNotConvex = 40;
  QuadShape shape = shape_of(quad);
  double lengths = 0;
  bool flat = false;
  for (Index h = 4 * quad; h < 4 * quad + 4; ++h) {
    const Index a = mesh.corner[h], b = mesh.corner[next_in_quad(h)];
    lengths += (mesh.twin[h] < 0 ? 2 : 1) * edge_defect(mesh.vertices[a], mesh.vertices[b]);
    flat = flat || !is_convex_corner(mesh.vertices[a].p, mesh.vertices[b].p,
                                     mesh.vertex_at(opposite_in_quad(h)).p);
  }
  if (flat) shape.least = std::min(shape.least, 0.);
  return {shape_energy(shape.low, shape.high, shape.least, weights, kNotConvex) +
              0.25 * weights.length * lengths,
          shape.least > 0};
}

double QuadWork::middle_length_defect(const WorkVertex& a, const WorkVertex& b, double at_a,
                                      double at_b) const {
  Index hint = a.hint;
  const MetricFactor middle = background.factor_at(0.5 * (a.p + b.p), hint);
  const double l = simpson_length(at_a, squared_length(middle, b.p - a.p), at_b);
  return length_defect(l * l, l * l);
}

void QuadWork::update_all_energies() {
  energy.assign(mesh.quad_count(), 0);
  convex.assign(mesh.quad_count(), 1);
  for (Index q = 0; q < mesh.quad_count(); ++q)
    if (!mesh.is_dead(q)) update_energy(q);
}

void QuadWork::begin() {
  ++stamp_;
  saved_quads_.clear();
  saved_vertices_.clear();
  quads_before_ = mesh.quad_count();
  vertices_before_ = static_cast<Index>(mesh.vertices.size());
}

void QuadWork::save_quad(Index quad) {
  quad_stamp_[quad] = stamp_;
  SavedQuad saved{quad, {}, {}, energy[quad], convex[quad] != 0};
  for (int k = 0; k < 4; ++k) {
    saved.corner[k] = mesh.corner[4 * quad + k];
    saved.twin[k] = mesh.twin[4 * quad + k];
  }
  saved_quads_.push_back(saved);
}

void QuadWork::save_vertex(Index v) {
  vertex_stamp_[v] = stamp_;
  saved_vertices_.push_back({v, mesh.leaving[v], mesh.vertices[v], mesh.valence[v]});
}

Index QuadWork::add_quad() {
  const Index quad = mesh.quad_count();
  mesh.corner.insert(mesh.corner.end(), 4, kNoIndex);
  mesh.twin.insert(mesh.twin.end(), 4, kNoIndex);
  energy.push_back(0);
  convex.push_back(1);
  quad_stamp_.push_back(stamp_);
  return quad;
}

Index QuadWork::add_vertex(const WorkVertex& vertex) {
  mesh.vertices.push_back(vertex);
  mesh.leaving.push_back(kNoIndex);
  mesh.valence.push_back(0);
  mesh.kind.push_back(QuadVertexKind::free);
  mesh.original.push_back(kNoIndex);
  mesh.next_copy.push_back(static_cast<Index>(mesh.vertices.size()) - 1);
  ideal.push_back(4);
  changed_at.push_back(commits_);
  vertex_stamp_.push_back(stamp_);
  return static_cast<Index>(mesh.vertices.size()) - 1;
}

void QuadWork::sew(Index h, Index t) {
  touch_quad(quad_of(h));
  mesh.twin[h] = t;
  if (t < 0) return;
  touch_quad(quad_of(t));
  mesh.twin[t] = h;
}

void QuadWork::recount(Index h) {
  const Index v = mesh.corner[h];
  touch_vertex(v);
  const Index start = h;
  while (mesh.twin[h] >= 0) {
    h = next_in_quad(mesh.twin[h]);
    if (h == start) break;
  }
  mesh.leaving[v] = h;
  int count = 0;
  for_each_leaving(mesh, v, [&](Index) { ++count; });
  mesh.valence[v] = static_cast<std::uint8_t>(std::min(count, 255));
}

void QuadWork::remove_quad(Index quad) {
  touch_quad(quad);
  for (int k = 0; k < 4; ++k) mesh.corner[4 * quad + k] = kNoIndex;
}

void QuadWork::remove_vertex(Index v) {
  touch_vertex(v);
  mesh.leaving[v] = kNoIndex;
  mesh.valence[v] = 0;
}

void QuadWork::move(Index v, const WorkVertex& to) {
  touch_vertex(v);
  for_each_leaving(mesh, v, [&](Index h) { touch_quad(quad_of(h)); });
  mesh.vertices[v] = to;
}

int QuadWork::valence_growth() const {
  int growth = 0;
  for (const SavedVertex& saved : saved_vertices_) {
    const Index v = saved.vertex;
    if (mesh.leaving[v] != kNoIndex) growth += square(mesh.valence[v] - ideal[v]);
    growth -= square(saved.valence - ideal[v]);
  }
  for (Index v = vertices_before_; v < static_cast<Index>(mesh.vertices.size()); ++v)
    if (mesh.leaving[v] != kNoIndex) growth += square(mesh.valence[v] - ideal[v]);
  return growth;
}

double QuadWork::energy_change(int& not_convex) {
  double change = 0;
  not_convex = 0;
  const auto add = [&](Index q) {
    update_energy(q);
    change += energy[q] - weights.potential;
    not_convex += !convex[q];
  };
  for (const SavedQuad& saved : saved_quads_) {
    change -= saved.energy - weights.potential;
    not_convex -= !saved.convex;
    if (!mesh.is_dead(saved.quad)) add(saved.quad);
  }
  for (Index q = quads_before_; q < mesh.quad_count(); ++q)
    if (!mesh.is_dead(q)) add(q);
  return change;
}

const std::vector<Index>& QuadWork::free_vertices() {
  free_vertices_.clear();
  const auto add = [&](Index q) {
    if (mesh.is_dead(q)) return;
    for (int k = 0; k < 4; ++k)
      if (mesh.is_free(mesh.corner[4 * q + k])) free_vertices_.push_back(mesh.corner[4 * q + k]);
  };
  for (const SavedQuad& saved : saved_quads_) add(saved.quad);
  for (Index q = quads_before_; q < mesh.quad_count(); ++q) add(q);
  std::sort(free_vertices_.begin(), free_vertices_.end());
  free_vertices_.erase(std::unique(free_vertices_.begin(), free_vertices_.end()),
                       free_vertices_.end());
  return free_vertices_;
}

void QuadWork::commit() {
  ++commits_;
  const auto mark = [&](Index q) {
    if (mesh.is_dead(q)) return;
    for (int k = 0; k < 4; ++k) changed_at[mesh.corner[4 * q + k]] = commits_;
  };
  for (const SavedQuad& saved : saved_quads_) mark(saved.quad);
  for (Index q = quads_before_; q < mesh.quad_count(); ++q) mark(q);
}

void QuadWork::undo() {
  for (const SavedQuad& saved : saved_quads_) {
    energy[saved.quad] = saved.energy;
    convex[saved.quad] = saved.convex;
    for (int k = 0; k < 4; ++k) {
      mesh.corner[4 * saved.quad + k] = saved.corner[k];
      mesh.twin[4 * saved.quad + k] = saved.twin[k];
    }
  }
  for (const SavedVertex& saved : saved_vertices_) {
    mesh.vertices[saved.vertex] = saved.value;
    mesh.leaving[saved.vertex] = saved.leaving;
    mesh.valence[saved.vertex] = saved.valence;
  }
  const auto quads = static_cast<std::size_t>(quads_before_);
  const auto vertices = static_cast<std::size_t>(vertices_before_);
  mesh.corner.resize(4 * quads);
  mesh.twin.resize(4 * quads);
  energy.resize(quads);
  convex.resize(quads);
  quad_stamp_.resize(quads);
  mesh.vertices.resize(vertices);
  mesh.leaving.resize(vertices);
  mesh.valence.resize(vertices);
  mesh.kind.resize(vertices);
  mesh.original.resize(vertices);
  mesh.next_copy.resize(vertices);
  ideal.resize(vertices);
  changed_at.resize(vertices);
  vertex_stamp_.resize(vertices);
}

}  // namespace anisofront
