#include "mesher/quads/triangle_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesher/quads/mixed_quality.hpp"
#include "mesher/quads/mixed_topology.hpp"

namespace anisofront {
namespace {

/// Merging stops at this quality too: what is worse stays in triangles.
constexpr double kLeastQuality = 0.1;

/// Two vertices become one, and some faces go.
struct Collapse {
  Index kept = kNoIndex, removed = kNoIndex;  ///< P1 and P2
  WorkVertex target;                          ///< Q
  std::vector<Index> faces;                   ///< that go: the two triangles first
  std::optional<MixedFace> quad;              ///< that takes their place
  std::vector<Index> around;                  ///< other faces at P1 and P2
  double gain = 0;                            ///< of the logarithm of the mean quality
};

class Eliminator {
 public:
  Eliminator(const BackgroundMesh& background, MixedMesh& mesh)
      : background_(background),
        mesh_(mesh),
        topology_(mixed_edges(mesh)),
        stars_(face_stars(mesh)),
        fixed_(fixed_vertices(mesh)),
        touched_(mesh.faces.size(), 0) {}

  /// Collapses places that have nothing in common, best first. Returns their number.
  Index run() {
    std::vector<Collapse> found = find_all();
    std::stable_sort(found.begin(), found.end(),
                     [](const Collapse& a, const Collapse& b) { return a.gain > b.gain; });
    Index done = 0;
    for (const Collapse& c : found) {
      if (is_touched(c)) continue;
      apply(c);
      ++done;
    }
    std::erase_if(mesh_.faces, [](const MixedFace& f) { return f.vertices[0] == kNoIndex; });
    return done;
  }

 private:
  const WorkVertex& vertex(Index v) const { return mesh_.vertices[v]; }
  const MixedFace& face(Index f) const { return mesh_.faces[f]; }

  std::vector<Collapse> find_all() {
    std::vector<Collapse> found;
    const auto add = [&](std::optional<Collapse> c) {
      if (c && evaluate(*c)) found.push_back(std::move(*c));
    };
    for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f)
      for (int k = 0; k < face(f).size(); ++k)
        add(face(f).is_quad() ? of_quad(f, k) : of_edge(f, k));
    return found;
  }

  /// Triangle f and, across its edge k, another one of larger number.
  std::optional<Collapse> of_edge(Index f, int k) const {
    const Index g = triangle_across(f, k);
    if (g <= f) return {};
    return merging(face(f).vertices[k], vertex_at(face(f), k + 1), {f, g});
  }

  /// Two triangles at the edges of quadrilateral f that meet in its vertex k.
  std::optional<Collapse> of_quad(Index f, int k) const {
    const int before = (k + 3) % 4;
    const Index g = triangle_across(f, k), h = triangle_across(f, before);
    if (g == kNoIndex || h == kNoIndex || g == h) return {};
    const Index corner = face(f).vertices[k], p = vertex_at(face(f), k + 1);
    std::optional<Collapse> c = merging(p, face(f).vertices[before], {g, h, f});
    if (c)
      c->quad = MixedFace{{corner, apex(g, topology_.of_face[f][k]), c->kept,
                           apex(h, topology_.of_face[f][before])}};
    return c;
  }

  /// The triangle across edge k of face f, kNoIndex when there is none or a segment between.
  Index triangle_across(Index f, int k) const {
    const MixedEdge& edge = topology_.edges[topology_.of_face[f][k]];
    const Index g = edge.left == f ? edge.right : edge.left;
    return edge.segment == kNoIndex && g != kNoIndex && !face(g).is_quad() ? g : kNoIndex;
  }
  Index apex(Index triangle, Index edge) const {
    const auto& edges = topology_.of_face[triangle];
    const auto k = std::find(edges.begin(), edges.end(), edge) - edges.begin();
    return face(triangle).vertices[kPrevious[k]];
  }

  std::optional<Collapse> merging(Index a, Index b, std::vector<Index> faces) const {
    if (fixed_[a] && fixed_[b]) return {};
    if (fixed_[b] || (!fixed_[a] && b < a)) std::swap(a, b);
    Collapse c{a, b, vertex(a), std::move(faces), {}, {}, 0};
    if (fixed_[a]) return c;
    c.target.p = 0.5 * (vertex(a).p + vertex(b).p);
    c.target.r = background_.factor_at(c.target.p, c.target.hint);
    return c;
  }

  /// Fills `around` and `gain`. Returns whether all faces are strictly convex and of some quality
  /// then.
  bool evaluate(Collapse& c) {
    collect_surroundings(c);
    Shape before, after;
    for (const Index f : c.faces) before.add(mesh_, face(f));
    for (const Index f : c.around) before.add(mesh_, face(f));
    const WorkVertex old = std::exchange(mesh_.vertices[c.kept], c.target);
    for (const Index f : c.around) after.add(mesh_, merged(c, face(f)));
    if (c.quad) after.add(mesh_, *c.quad);
    mesh_.vertices[c.kept] = old;
    const std::size_t faces = c.around.size() + (c.quad ? 1 : 0);
    c.gain = std::log(after.product) / static_cast<double>(faces) -
             std::log(before.product) / static_cast<double>(c.around.size() + c.faces.size());
    return after.broken == 0 && after.worst >= std::min(kLeastQuality, before.worst);
  }

  void collect_surroundings(Collapse& c) const {
    for (const Index v : {c.kept, c.removed})
      for (const Corner& corner : stars_[v])
        if (std::find(c.faces.begin(), c.faces.end(), corner.face) == c.faces.end())
          c.around.push_back(corner.face);
    std::sort(c.around.begin(), c.around.end());
    c.around.erase(std::unique(c.around.begin(), c.around.end()), c.around.end());
  }

  static MixedFace merged(const Collapse& c, MixedFace face) {
    std::replace(face.vertices.begin(), face.vertices.end(), c.removed, c.kept);
    return face;
  }

  bool is_touched(const Collapse& c) const {
    const auto touched = [this](Index f) { return touched_[f] != 0; };
    return std::any_of(c.faces.begin(), c.faces.end(), touched) ||
           std::any_of(c.around.begin(), c.around.end(), touched);
  }

  void apply(const Collapse& c) {
    mesh_.vertices[c.kept] = c.target;
    for (const Index f : c.around) {
      mesh_.faces[f] = merged(c, mesh_.faces[f]);
      touched_[f] = 1;
    }
    for (const Index f : c.faces) {
      mesh_.faces[f].vertices[0] = kNoIndex;
      touched_[f] = 1;
    }
    if (c.quad) mesh_.faces[c.faces[0]] = *c.quad;
  }

  const BackgroundMesh& background_;
  MixedMesh& mesh_;
  MixedEdges topology_;
  FaceStars stars_;
  std::vector<char> fixed_;
  std::vector<char> touched_;  ///< per face: changed in this round
};

}  // namespace

Index eliminate_triangles(const BackgroundMesh& background, MixedMesh& mesh) {
  Index removed = 0;
  while (triangle_count(mesh) > 1) {
    const Index done = Eliminator(background, mesh).run();
    if (done == 0) break;
    removed += 2 * done;
  }
  return removed;
}

}  // namespace anisofront
