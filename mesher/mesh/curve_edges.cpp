// Boundary, interface and embedded edges of a mesh.
#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/curve_chains.hpp"

namespace anisofront::detail {
namespace {

std::string describe_vertex(const Mesh& mesh, Index v) {
  return "vertex " + std::to_string(v + 1) + " " +
         describe(mesh.points[static_cast<std::size_t>(v)]);
}

[[noreturn]] void reject_edge(const Mesh& mesh, Index a, Index b, const std::string& found,
                              const std::string& expected) {
  throw InputError("the edge from " + describe_vertex(mesh, a) + " to " + describe_vertex(mesh, b) +
                   " " + found + "; expected " + expected);
}

/// One side of an element, or a mesh edge, filed under its smaller vertex.
struct Side {
  Index other;     ///< the larger vertex
  bool is_edge;    ///< owner is an index into Mesh::edges, else an element
  bool ascending;  ///< runs from the smaller vertex to the larger
  Index owner;
};

bool before(const Side& a, const Side& b) {
  return std::tuple(a.other, a.is_edge, a.owner) < std::tuple(b.other, b.is_edge, b.owner);
}

/// Calls visit(from, to, is_edge, owner) for all sides of triangles, then quads, then mesh edges.
template <class Visit>
void for_each_side(const Mesh& mesh, const Visit& visit) {
  Index element = 0;
  const auto visit_all = [&](const auto& elements) {
    for (const auto& vertices : elements) {
      for (std::size_t k = 0; k < vertices.size(); ++k)
        visit(vertices[k], vertices[k + 1 == vertices.size() ? 0 : k + 1], false, element);
      ++element;
    }
  };
  visit_all(mesh.triangles);
  visit_all(mesh.quads);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    visit(mesh.edges[e].vertices[0], mesh.edges[e].vertices[1], true, static_cast<Index>(e));
}

struct SidesByVertex {
  std::vector<Index> first;  ///< sides of smaller vertex v: first[v] .. first[v + 1] - 1
  std::vector<Side> sides;
};

void validate_side(const Mesh& mesh, Index a, Index b, bool is_edge, Index owner) {
  const auto count = static_cast<Index>(mesh.points.size());
  if (a >= 0 && b >= 0 && a < count && b < count && a != b) return;
  throw InputError(std::string(is_edge ? "edge " : "element ") + std::to_string(owner + 1) +
                   ": found a side between the vertices " + std::to_string(a + 1) + " and " +
                   std::to_string(b + 1) + "; expected two different numbers from 1 to " +
                   std::to_string(count));
}

SidesByVertex file_sides(const Mesh& mesh) {
  SidesByVertex result;
  result.first.assign(mesh.points.size() + 2, 0);
  for_each_side(mesh, [&](Index a, Index b, bool is_edge, Index owner) {
    validate_side(mesh, a, b, is_edge, owner);
    ++result.first[static_cast<std::size_t>(std::min(a, b)) + 2];
  });
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.sides.resize(static_cast<std::size_t>(result.first.back()));
  for_each_side(mesh, [&](Index a, Index b, bool is_edge, Index owner) {
    Index& next = result.first[static_cast<std::size_t>(std::min(a, b)) + 1];
    result.sides[static_cast<std::size_t>(next++)] = {std::max(a, b), is_edge, a < b, owner};
  });
  result.first.pop_back();
  return result;
}

/// Disjoint sets of elements; the root is the smallest element of the set.
class ElementSets {
 public:
  explicit ElementSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }
  Index root(Index e) {
    while (parent(e) != e) e = parent(e) = parent(parent(e));
    return e;
  }
  void unite(Index a, Index b) {
    const Index root_a = root(a), root_b = root(b);
    parent(std::max(root_a, root_b)) = std::min(root_a, root_b);
  }

 private:
  Index& parent(Index e) { return parents_[static_cast<std::size_t>(e)]; }
  std::vector<Index> parents_;
};

Index region_tag(const Mesh& mesh, Index element) {
  const auto e = static_cast<std::size_t>(element), triangles = mesh.triangles.size();
  const std::vector<Index>& tags = e < triangles ? mesh.triangle_regions : mesh.quad_regions;
  const std::size_t local = e < triangles ? e : e - triangles;
  return local < tags.size() ? tags[local] : 0;
}

/// A found edge: its sides still name elements. `mesh_edge` is the first one here, or kNoIndex.
struct FoundEdge {
  SidedEdge edge;
  Index mesh_edge;
};

/// All sides that lie on one edge: elements first, then mesh edges.
struct EdgeSides {
  Index vertex;
  const Side* begin;
  const Side* edges;  ///< first mesh edge
  const Side* end;
};

void validate_edge(const Mesh& mesh, const EdgeSides& s) {
  const auto elements = s.edges - s.begin;
  if (elements == 0)
    reject_edge(mesh, s.vertex, s.begin->other, "is no side of any element",
                "tagged edges to be sides of elements");
  if (elements > 2)
    reject_edge(mesh, s.vertex, s.begin->other,
                "belongs to " + std::to_string(elements) + " elements", "at most two");
  if (elements == 2 && s.begin[0].ascending == s.begin[1].ascending)
    reject_edge(mesh, s.vertex, s.begin->other,
                "is run through in the same direction by elements " +
                    std::to_string(s.begin[0].owner + 1) + " and " +
                    std::to_string(s.begin[1].owner + 1),
                "elements that do not overlap, all anticlockwise");
}

/// Boundary edges run with their element on the left, tagged inner edges as in Mesh::edges.
FoundEdge make_edge(const Mesh& mesh, const EdgeSides& s) {
  const bool on_boundary = s.edges - s.begin == 1, tagged = s.edges != s.end;
  const bool ascending = !on_boundary && tagged ? s.edges->ascending : s.begin->ascending;
  const Side& left = s.begin->ascending == ascending ? s.begin[0] : s.begin[1];
  FoundEdge found{{}, tagged ? s.edges->owner : kNoIndex};
  found.edge.vertices = {s.vertex, s.begin->other};
  if (!ascending) std::swap(found.edge.vertices[0], found.edge.vertices[1]);
  found.edge.left = left.owner;
  if (!on_boundary) found.edge.right = s.begin[&left == s.begin ? 1 : 0].owner;
  if (tagged) found.edge.tag = mesh.edges[static_cast<std::size_t>(found.mesh_edge)].tag;
  return found;
}

/// Parts from the sets, in the order of their first elements; renames the sides of the edges.
void number_parts(const Mesh& mesh, ElementSets& sets, CurveEdges& result) {
  const std::size_t count = mesh.triangles.size() + mesh.quads.size();
  std::vector<Index> part(count, kNoIndex);
  for (std::size_t e = 0; e < count; ++e) {
    const auto element = static_cast<Index>(e);
    if (sets.root(element) != element) continue;
    part[e] = static_cast<Index>(result.part_tags.size());
    result.part_tags.push_back(region_tag(mesh, element));
  }
  for (SidedEdge& edge : result.edges)
    for (Index* side : {&edge.left, &edge.right})
      if (*side != kNoIndex) *side = part[static_cast<std::size_t>(sets.root(*side))];
}

/// Edges of the mesh first and in their order, the others by element.
void sort_found(std::vector<FoundEdge>& found) {
  const auto key = [](const FoundEdge& f) {
    return std::tuple(f.mesh_edge == kNoIndex, f.mesh_edge, f.edge.left, f.edge.vertices);
  };
  std::sort(found.begin(), found.end(),
            [&](const FoundEdge& a, const FoundEdge& b) { return key(a) < key(b); });
}

}  // namespace

CurveEdges find_curve_edges(const Mesh& mesh) {
  SidesByVertex filed = file_sides(mesh);
  ElementSets sets(mesh.triangles.size() + mesh.quads.size());
  std::vector<FoundEdge> found;
  std::vector<Index> first_of(mesh.edges.size());  // mesh edge -> first mesh edge at its place
  for (std::size_t v = 0; v + 1 < filed.first.size(); ++v) {
    Side* const end = filed.sides.data() + filed.first[v + 1];
    Side* side = filed.sides.data() + filed.first[v];
    std::sort(side, end, before);
    while (side != end) {
      EdgeSides s{static_cast<Index>(v), side, side, side};
      while (s.end != end && s.end->other == side->other)
        if (!(s.end++)->is_edge) s.edges = s.end;
      side += s.end - s.begin;
      validate_edge(mesh, s);
      const bool inner = s.edges - s.begin == 2;
      const bool interface =
          inner && region_tag(mesh, s.begin[0].owner) != region_tag(mesh, s.begin[1].owner);
      if (inner && !interface) sets.unite(s.begin[0].owner, s.begin[1].owner);
      if (!inner || interface || s.edges != s.end) found.push_back(make_edge(mesh, s));
      for (const Side* e = s.edges; e != s.end; ++e)
        first_of[static_cast<std::size_t>(e->owner)] = s.edges->owner;
    }
  }
  sort_found(found);
  CurveEdges result{{}, std::vector<Index>(mesh.edges.size()), {}};
  for (const FoundEdge& f : found) {
    if (f.mesh_edge != kNoIndex)
      result.of_mesh_edge[static_cast<std::size_t>(f.mesh_edge)] =
          static_cast<Index>(result.edges.size());
    result.edges.push_back(f.edge);
  }
  for (std::size_t e = 0; e < first_of.size(); ++e)
    result.of_mesh_edge[e] = result.of_mesh_edge[static_cast<std::size_t>(first_of[e])];
  number_parts(mesh, sets, result);
  return result;
}

}  // namespace anisofront::detail
