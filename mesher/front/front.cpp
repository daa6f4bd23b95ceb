#include "mesher/front/front.hpp"

namespace anisofront {

Front::Front(WorkMesh& mesh, const Box& bounds, double typical_size, BaseOrder order)
    : mesh_(mesh), index_(bounds, typical_size), queue_(order) {
  leaving_.reserve(mesh.vertices.capacity());
  leaving_.assign(mesh.vertices.size(), kNoIndex);
  for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
    const Segment& s = mesh.segments[i];
    const Index behind = ~static_cast<Index>(i);
    if (s.left_region != kNoIndex) add(s.a, s.b, behind);
    if (s.right_region != kNoIndex) add(s.b, s.a, behind);
  }
}

void Front::add(Index va, Index vb, Index behind) {
  Index id;
  if (free_.empty()) {
    id = static_cast<Index>(edges_.size());
    edges_.emplace_back();
  } else {
    id = free_.back();
    free_.pop_back();
  }
  FrontEdge& edge = edges_[id];
  const WorkVertex& a = mesh_.vertices[va];
  const WorkVertex& b = mesh_.vertices[vb];
  edge.a = a.p;
  edge.b = b.p;
  edge.va = va;
  edge.vb = vb;
  edge.next_out = leaving_[va];
  edge.behind = behind;
  leaving_[va] = id;
  const Vector u = b.p - a.p;
  queue_.push(id, edge.version, 0.5 * (squared_length(a.r, u) + squared_length(b.r, u)),
              squared_norm(u));
  index_.insert(edges_, id);
  ++live_;
}

void Front::remove(Index id) {
  FrontEdge& edge = edges_[id];
  Index* link = &leaving_[edge.va];
  while (*link != id) link = &edges_[*link].next_out;
  *link = edge.next_out;
  ++edge.version;
  index_.remove(edges_, id);
  free_.push_back(id);
  --live_;
}

Index Front::find(Index va, Index vb) const {
  for (Index id = leaving_[va]; id != kNoIndex; id = edges_[id].next_out)
    if (edges_[id].vb == vb) return id;
  return kNoIndex;
}

/// Makes what lies behind a front edge the neighbour of the triangle, and returns it.
Index Front::link(Index behind, Index triangle) {
  if (behind < 0) return behind;
  mesh_.triangles[behind / 3].neighbours[behind % 3] = triangle;
  return behind / 3;
}

/// Side va -> vb of the new triangle: closes the front edge that already runs there, or becomes a
/// front edge for the far side. Returns the neighbour across it.
Index Front::close_or_add(Index va, Index vb, Index triangle, int k) {
  const Index id = find(va, vb);
  if (id == kNoIndex) {
    add(vb, va, 3 * triangle + k);
    return kNoIndex;
  }
  const Index behind = edges_[id].behind;
  remove(id);
  return link(behind, triangle);
}

void Front::form_element(Index base, Index vertex) {
  const FrontEdge edge = edges_[base];
  const auto t = static_cast<Index>(mesh_.triangles.size());
  mesh_.triangles.push_back({{edge.va, edge.vb, vertex}, {kNoIndex, kNoIndex, kNoIndex}});
  mesh_.triangles[t].neighbours[2] = link(edge.behind, t);
  remove(base);
  mesh_.triangles[t].neighbours[0] = close_or_add(edge.vb, vertex, t, 0);
  mesh_.triangles[t].neighbours[1] = close_or_add(vertex, edge.va, t, 1);
}

}  // namespace anisofront
