#pragma once

#include <vector>

#include "mesher/front/edge_index.hpp"
#include "mesher/front/front_queue.hpp"
#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// The front: the directed edges between what is meshed and what is not, with their order, their
/// search structure and the edges that leave each vertex.
class Front {
 public:
  /// Starts from both sides (where they have a region) of all segments of the mesh.
  Front(WorkMesh& mesh, const Box& bounds, double typical_size, BaseOrder order);

  bool empty() const { return live_ == 0; }
  Index size() const { return live_; }
  const std::vector<FrontEdge>& edges() const { return edges_; }
  /// The next base segment; the edge stays in the front.
  Index next_base() { return queue_.pop(edges_); }

  /// Edges whose boxes overlap the box, except the base.
  void query(const Box& box, Index base, std::vector<Index>& found) const {
    index_.query(edges_, box, base, found);
  }

  /// Step (vii): forms the triangle of the base segment and the vertex and updates the front.
  void form_element(Index base, Index vertex);

  /// To be called after a vertex was appended to the mesh.
  void add_vertex() { leaving_.push_back(kNoIndex); }

 private:
  void add(Index va, Index vb, Index behind);
  void remove(Index id);
  Index find(Index va, Index vb) const;
  Index link(Index behind, Index triangle);
  Index close_or_add(Index va, Index vb, Index triangle, int k);

  WorkMesh& mesh_;
  std::vector<FrontEdge> edges_;
  std::vector<Index> free_;
  std::vector<Index> leaving_;  ///< first front edge that leaves each vertex
  EdgeIndex index_;
  FrontQueue queue_;
  Index live_ = 0;
};

}  // namespace anisofront
