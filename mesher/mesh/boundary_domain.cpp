#include "mesher/mesh/boundary_domain.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/curve_chains.hpp"

namespace anisofront {
namespace {

using detail::Chain;
using detail::CurveEdges;
using detail::SidedEdge;

/// Gives out names that differ: "wall", "wall-2", "wall-3".
class Names {
 public:
  std::string unique(const std::string& base) {
    int& number = last_number_[base];
    std::string name;
    do {
      ++number;
      name = number == 1 ? base : base + "-" + std::to_string(number);
    } while (!used_.insert(name).second);
    return name;
  }

 private:
  std::map<std::string, int> last_number_;
  std::set<std::string> used_;
};

std::string name_or(std::string name, const std::string& otherwise) {
  return name.empty() ? otherwise : name;
}

Index vertex_tag(const Mesh& mesh, std::size_t v) {
  return v < mesh.vertex_tags.size() ? mesh.vertex_tags[v] : 0;
}

/// Flag per vertex: Mesh::required_vertices and the vertices of named point groups.
std::vector<char> required_flags(const Mesh& mesh) {
  std::vector<char> required(mesh.points.size(), 0);
  const auto count = static_cast<Index>(mesh.points.size());
  for (const std::vector<Index>* list : {&mesh.required_vertices, &mesh.corners})
    for (const Index v : *list)
      if (v < 0 || v >= count)
        throw InputError("corners and required vertices: found vertex " + std::to_string(v + 1) +
                         "; expected a number from 1 to " + std::to_string(count));
  for (const Index v : mesh.required_vertices) required[static_cast<std::size_t>(v)] = 1;
  std::set<Index> named;
  for (const PhysicalGroup& group : mesh.groups)
    if (group.dimension == 0) named.insert(group.tag);
  for (std::size_t v = 0; !named.empty() && v < mesh.vertex_tags.size(); ++v)
    if (named.count(mesh.vertex_tags[v]) > 0) required[v] = 1;
  return required;
}

bool on_boundary(const SidedEdge& edge) { return edge.right == kNoIndex; }

/// The tags and names of curves without a physical tag.
struct DefaultTags {
  Index boundary = 1;
  Index interface = 2;
};

/// Gives the edges without a tag the smallest ones that nothing else uses.
DefaultTags tag_untagged(const Mesh& mesh, std::vector<SidedEdge>& edges) {
  std::set<Index> used;
  for (const PhysicalGroup& group : mesh.groups)
    if (group.dimension == 1) used.insert(group.tag);
  for (const SidedEdge& edge : edges) used.insert(edge.tag);
  DefaultTags tags;
  while (used.count(tags.boundary) > 0) ++tags.boundary;
  tags.interface = tags.boundary + 1;
  while (used.count(tags.interface) > 0) ++tags.interface;
  for (SidedEdge& edge : edges)
    if (edge.tag == 0) edge.tag = on_boundary(edge) ? tags.boundary : tags.interface;
  return tags;
}

std::string curve_name(const Mesh& mesh, const DefaultTags& defaults, Index tag) {
  if (tag == defaults.boundary) return "boundary";
  if (tag == defaults.interface) return "interface";
  return name_or(group_name(mesh, 1, tag), "curve-" + std::to_string(tag));
}

NurbsCurve shape_of(const Mesh& mesh, const Chain& chain, BoundaryShape shape) {
  std::vector<Point> points;
  points.reserve(chain.vertices.size());
  for (const Index v : chain.vertices) points.push_back(mesh.points[static_cast<std::size_t>(v)]);
  if (shape == BoundaryShape::linear) return make_polyline(points);
  return make_spline(points, chain.smooth_seam ? SplineSeam::smooth : SplineSeam::corner);
}

void add_curves(const Mesh& mesh, const std::vector<Chain>& chains, const DefaultTags& defaults,
                BoundaryShape shape, Domain& domain) {
  Names names;
  for (const Chain& chain : chains)
    domain.curves.push_back({names.unique(curve_name(mesh, defaults, chain.tag)), chain.tag,
                             shape_of(mesh, chain, shape)});
}

/// A chain that bounds a part, walked with the part on its left.
struct DirectedChain {
  CurveUse use;
  Index start, end;     ///< vertices
  Index after, before;  ///< the vertices next to them
};

DirectedChain directed(const Chain& chain, Index curve, bool reversed) {
  const std::vector<Index>& v = chain.vertices;
  const std::size_t n = v.size();
  if (!reversed) return {{curve, false}, v[0], v[n - 1], v[1], v[n - 2]};
  return {{curve, true}, v[n - 1], v[0], v[n - 2], v[1]};
}

/// Angle from `from` clockwise to `to`, in (0, 2 pi].
double clockwise_angle(Vector from, Vector to) {
  const double angle = std::atan2(cross(to, from), dot(to, from));
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// Links the chains round one part into loops. Where the part touches itself at a vertex the loop
/// goes on along the edge next to the last one inside the part: the first one clockwise.
class LoopLinker {
 public:
  LoopLinker(const Mesh& mesh, std::vector<DirectedChain> chains)
      : mesh_(mesh),
        chains_(std::move(chains)),
        used_(chains_.size(), 0),
        by_start_(chains_.size()) {
    for (std::size_t i = 0; i < by_start_.size(); ++i) by_start_[i] = i;
    std::sort(by_start_.begin(), by_start_.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(chains_[a].start, a) < std::pair(chains_[b].start, b);
    });
  }

  std::vector<Loop> link() {
    std::vector<Loop> loops;
    for (std::size_t first = 0; first < chains_.size(); ++first) {
      if (used_[first]) continue;
      Loop loop;
      for (std::size_t i = first; !used_[i]; i = next(chains_[i])) {
        used_[i] = 1;
        loop.push_back(chains_[i].use);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  Vector direction(Index from, Index to) const {
    return mesh_.points[static_cast<std::size_t>(to)] -
           mesh_.points[static_cast<std::size_t>(from)];
  }

  /// The chain that continues `chain`; every part boundary is closed, so there is one.
  std::size_t next(const DirectedChain& chain) const {
    auto candidate = std::lower_bound(by_start_.begin(), by_start_.end(), chain.end,
                                      [&](std::size_t i, Index v) { return chains_[i].start < v; });
    const Vector back = direction(chain.end, chain.before);
    std::size_t best = *candidate;
    double least = 7;  // more than a full turn
    for (; candidate != by_start_.end() && chains_[*candidate].start == chain.end; ++candidate) {
      const double angle = clockwise_angle(back, direction(chain.end, chains_[*candidate].after));
      if (angle < least) {
        least = angle;
        best = *candidate;
      }
    }
    return best;
  }

  const Mesh& mesh_;
  std::vector<DirectedChain> chains_;
  std::vector<char> used_;
  std::vector<std::size_t> by_start_;
};

void put_outer_loop_first(const Domain& domain, std::vector<Loop>& loops) {
  std::vector<double> areas;
  for (const Loop& loop : loops) areas.push_back(signed_area(domain, loop));
  const auto outer = std::max_element(areas.begin(), areas.end()) - areas.begin();
  std::rotate(loops.begin(), loops.begin() + outer, loops.begin() + outer + 1);
}

void add_regions(const Mesh& mesh, const std::vector<Chain>& chains,
                 const std::vector<Index>& part_tags, Domain& domain) {
  std::vector<std::vector<DirectedChain>> around(part_tags.size());
  std::vector<std::vector<Index>> embedded(part_tags.size());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const Chain& chain = chains[c];
    const auto curve = static_cast<Index>(c);
    if (chain.left == chain.right) {
      embedded[static_cast<std::size_t>(chain.left)].push_back(curve);
      continue;
    }
    for (const bool reversed : {false, true}) {
      const Index part = reversed ? chain.right : chain.left;
      if (part != kNoIndex)
        around[static_cast<std::size_t>(part)].push_back(directed(chain, curve, reversed));
    }
  }
  Names names;
  for (std::size_t part = 0; part < part_tags.size(); ++part) {
    const Index tag = part_tags[part];
    const std::string otherwise = tag == 0 ? "region" : "region-" + std::to_string(tag);
    DomainRegion region{names.unique(name_or(group_name(mesh, 2, tag), otherwise)), tag,
                        LoopLinker(mesh, std::move(around[part])).link(), embedded[part]};
    put_outer_loop_first(domain, region.loops);
    domain.regions.push_back(std::move(region));
  }
}

/// Required vertices: inside the parts and, as ends of chains, on curves.
void add_points(const Mesh& mesh, const std::vector<char>& required, Domain& domain) {
  Names names;
  for (std::size_t v = 0; v < required.size(); ++v) {
    if (!required[v]) continue;
    const Index tag = vertex_tag(mesh, v);
    domain.points.push_back(
        {names.unique(name_or(group_name(mesh, 0, tag), "point")), tag, mesh.points[v]});
  }
}

/// Curve and parameters (k at the k-th vertex of the chain) of every edge, missing ones added.
void attach_edges(Mesh& mesh, const CurveEdges& found, const std::vector<Chain>& chains) {
  std::vector<CurveEdge> placed(found.edges.size());
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t k = 0; k < chains[c].edges.size(); ++k) {
      const auto e = static_cast<std::size_t>(chains[c].edges[k]);
      CurveEdge& edge = placed[e];
      edge = {found.edges[e].vertices,
              found.edges[e].tag,
              static_cast<Index>(c),
              {static_cast<double>(k), static_cast<double>(k + 1)}};
      if (edge.vertices[0] != chains[c].vertices[k])
        std::swap(edge.parameters[0], edge.parameters[1]);
    }
  std::vector<char> present(placed.size(), 0);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto place = static_cast<std::size_t>(found.of_mesh_edge[e]);
    mesh.edges[e] = placed[place];
    present[place] = 1;
  }
  for (std::size_t e = 0; e < placed.size(); ++e)
    if (!present[e]) mesh.edges.push_back(placed[e]);
}

}  // namespace

Domain domain_from_mesh(Mesh& mesh, const BoundaryDomainOptions& options) {
  CurveEdges found = detail::find_curve_edges(mesh);
  const DefaultTags defaults = tag_untagged(mesh, found.edges);
  const std::vector<char> required = required_flags(mesh);
  const std::vector<Chain> chains =
      detail::chain_edges(mesh, found.edges, required, options.corner_angle);
  Domain domain;
  add_curves(mesh, chains, defaults, options.shape, domain);
  add_regions(mesh, chains, found.part_tags, domain);
  add_points(mesh, required, domain);
  attach_edges(mesh, found, chains);
  return domain;
}

}  // namespace anisofront
