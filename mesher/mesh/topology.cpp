// Half-edges are matched by a counting sort on their smaller vertex; inside such a bucket a slot
// per larger vertex finds the twin. No hashing and no comparison sort, so the cost per element does
// not depend on the valences.
#include "mesher/mesh/topology.hpp"

#include <algorithm>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {

namespace {

/// A half-edge in the bucket of its smaller vertex.
struct Sorted {
  Index half_edge = kNoIndex;
  Index larger = kNoIndex;
};

/// Calls visit(h, from, to) for every half-edge, without the divisions of HalfEdges::operator[].
template <class Visit>
void for_each_half_edge(const HalfEdges& edges, Visit visit) {
  Index h = 0;
  for (const Triangle& t : edges.triangles) {
    visit(h, t[1], t[2]);
    visit(h + 1, t[2], t[0]);
    visit(h + 2, t[0], t[1]);
    h += 3;
  }
  for (const Quad& q : edges.quads)
    for (int k = 0; k < 4; ++k) visit(h++, q[k], q[(k + 1) % 4]);
}

/// Sums counts stored one place to the right: afterwards bucket v begins at first[v].
void accumulate(std::vector<Index>& first) {
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
}

/// Writes into a bucket move its begin to its end; this moves all of them back.
void restore_begins(std::vector<Index>& first) {
  std::move_backward(first.begin(), first.end() - 1, first.end());
  first.front() = 0;
}

struct Buckets {
  std::vector<Index> first;
  std::vector<Sorted> half_edges;
};

Buckets sort_by_smaller_vertex(const HalfEdges& edges, Index vertex_count) {
  Buckets buckets;
  buckets.first.assign(static_cast<std::size_t>(vertex_count) + 1, 0);
  buckets.half_edges.resize(static_cast<std::size_t>(edges.count()));
  for_each_half_edge(edges, [&](Index, Index from, Index to) {
    ++buckets.first[static_cast<std::size_t>(std::min(from, to)) + 1];
  });
  accumulate(buckets.first);
  for_each_half_edge(edges, [&](Index h, Index from, Index to) {
    Index& place = buckets.first[std::min(from, to)];
    buckets.half_edges[place++] = {h, std::max(from, to)};
  });
  restore_begins(buckets.first);
  return buckets;
}

/// Pairs `second` with the half-edge `first` between the same vertices, or records why not.
void pair_up(const HalfEdges& edges, Index first, Index second, HalfEdgeTwins& result) {
  if (result.twin[first] != kNoIndex) {
    result.conflicts.push_back({first, second, false});
  } else if (edges[first].from == edges[second].from) {
    result.conflicts.push_back({first, second, true});
  } else {
    result.twin[first] = second;
    result.twin[second] = first;
  }
}

template <std::size_t N>
void require_in_range(std::span<const std::array<Index, N>> elements, Index vertex_count) {
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (const Index v : elements[e])
      if (v < 0 || v >= vertex_count)
        throw InputError("triangle " + std::to_string(e + 1) + " refers to vertex " +
                         std::to_string(v + 1) + ", expected 1 to " + std::to_string(vertex_count));
}

[[noreturn]] void throw_conflict(const HalfEdges& edges, const EdgeConflict& conflict) {
  const HalfEdge e = edges[conflict.second];
  const std::string who = std::to_string(edges.element(conflict.first) + 1) + " and " +
                          std::to_string(edges.element(conflict.second) + 1);
  throw InputError("the edge between vertices " + std::to_string(e.from + 1) + " and " +
                   std::to_string(e.to + 1) +
                   (conflict.same_direction
                        ? " is run through in the same direction by triangles " + who +
                              ": one of them is inverted or they overlap"
                        : " is shared by more than two triangles, among them " + who) +
                   "; expected one triangle on each side");
}

}  // namespace

HalfEdgeTwins half_edge_twins(const HalfEdges& edges, Index vertex_count) {
  const Buckets buckets = sort_by_smaller_vertex(edges, vertex_count);
  HalfEdgeTwins result;
  result.twin.assign(buckets.half_edges.size(), kNoIndex);
  // Place of the first half-edge to a vertex; older than the bucket's begin means: not in it.
  std::vector<Index> slot(static_cast<std::size_t>(vertex_count), kNoIndex);
  for (Index v = 0; v < vertex_count; ++v) {
    const Index begin = buckets.first[v], end = buckets.first[v + 1];
    for (Index place = begin; place < end; ++place) {
      const Sorted& now = buckets.half_edges[place];
      Index& seen = slot[now.larger];
      if (seen < begin)
        seen = place;
      else
        pair_up(edges, buckets.half_edges[seen].half_edge, now.half_edge, result);
    }
  }
  return result;
}

TriangleNeighbours triangle_neighbours(std::span<const Triangle> triangles, Index vertex_count) {
  require_in_range(triangles, vertex_count);
  const HalfEdges edges{triangles, {}};
  const HalfEdgeTwins twins = half_edge_twins(edges, vertex_count);
  if (!twins.conflicts.empty()) throw_conflict(edges, twins.conflicts.front());
  TriangleNeighbours neighbours(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index twin = twins.twin[3 * t + k];
      neighbours[t][k] = twin == kNoIndex ? kNoIndex : twin / 3;
    }
  return neighbours;
}

std::vector<std::array<Index, 2>> mesh_edges(const Mesh& mesh) {
  const HalfEdges edges = half_edges(mesh);
  const std::vector<Index> twin =
      half_edge_twins(edges, static_cast<Index>(mesh.points.size())).twin;
  std::vector<std::array<Index, 2>> result;
  result.reserve(twin.size() / 2 + mesh.edges.size());
  for_each_half_edge(edges, [&](Index h, Index from, Index to) {
    if (twin[h] == kNoIndex || twin[h] > h)
      result.push_back({std::min(from, to), std::max(from, to)});
  });
  return result;
}

std::vector<std::array<Index, 2>> boundary_edges(const Mesh& mesh) {
  const HalfEdges edges = half_edges(mesh);
  const std::vector<Index> twin =
      half_edge_twins(edges, static_cast<Index>(mesh.points.size())).twin;
  std::vector<std::array<Index, 2>> result;
  for_each_half_edge(edges, [&](Index h, Index from, Index to) {
    if (twin[h] == kNoIndex) result.push_back({from, to});
  });
  return result;
}

VertexStars vertex_stars(const Mesh& mesh) {
  VertexStars stars;
  stars.first.assign(mesh.points.size() + 1, 0);
  const auto for_each_corner = [&mesh](auto visit) {
    Index element = 0;
    for (const Triangle& t : mesh.triangles) {
      for (const Index v : t) visit(v, element);
      ++element;
    }
    for (const Quad& q : mesh.quads) {
      for (const Index v : q) visit(v, element);
      ++element;
    }
  };
  for_each_corner([&](Index v, Index) { ++stars.first[static_cast<std::size_t>(v) + 1]; });
  accumulate(stars.first);
  stars.elements.resize(static_cast<std::size_t>(stars.first.back()));
  for_each_corner([&](Index v, Index element) { stars.elements[stars.first[v]++] = element; });
  restore_begins(stars.first);
  return stars;
}

VertexNeighbours vertex_neighbours(const Mesh& mesh) {
  const std::vector<std::array<Index, 2>> edges = mesh_edges(mesh);
  VertexNeighbours neighbours;
  neighbours.first.assign(mesh.points.size() + 1, 0);
  for (const std::array<Index, 2>& e : edges)
    for (const Index v : e) ++neighbours.first[static_cast<std::size_t>(v) + 1];
  accumulate(neighbours.first);
  neighbours.vertices.resize(2 * edges.size());
  for (const auto& [a, b] : edges) {
    neighbours.vertices[neighbours.first[a]++] = b;
    neighbours.vertices[neighbours.first[b]++] = a;
  }
  restore_begins(neighbours.first);
  return neighbours;
}

}  // namespace anisofront
