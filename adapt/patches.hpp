#pragma once

#include <span>
#include <vector>

#include "mesher/mesh/topology.hpp"

namespace anisofront {

/// What the collection of patches needs of a mesh; shared by all threads.
class PatchTopology {
 public:
  /// by_region: patches are to end at interfaces. `mesh` must outlive it.
  PatchTopology(const Mesh& mesh, bool by_region);

  Index vertex_count() const { return static_cast<Index>(mesh_.points.size()); }
  /// Elements around a vertex, ascending; triangles first, then quadrilaterals.
  std::span<const Index> elements(Index vertex) const {
    const Index* begin = stars_.elements.data();
    return {begin + stars_.first[vertex], begin + stars_.first[vertex + 1]};
  }
  std::span<const Index> vertices(Index element) const {
    const auto triangles = static_cast<Index>(mesh_.triangles.size());
    if (element < triangles) return mesh_.triangles[element];
    return mesh_.quads[element - triangles];
  }
  /// 0 for all elements when patches ignore the regions.
  Index region(Index element) const { return regions_.empty() ? 0 : regions_[element]; }
  /// Regions around a vertex, ascending.
  std::vector<Index> regions_at(Index vertex) const;
  bool is_on_interface(Index vertex) const {
    return !on_interface_.empty() && on_interface_[vertex];
  }

 private:
  const Mesh& mesh_;
  VertexStars stars_;
  std::vector<Index> regions_;      ///< per element; empty when they do not matter
  std::vector<char> on_interface_;  ///< per vertex; empty when there is no interface
};

/// Collects the vertices around a vertex; one per thread (it holds scratch marks).
class PatchCollector {
 public:
  explicit PatchCollector(const PatchTopology& topology);

  /// The vertex first, then ring by ring through elements of `region` (see hessian.hpp).
  /// Without the vertices of interfaces when `drop_interfaces`. Valid until the next call.
  std::span<const Index> around(Index vertex, Index region, bool drop_interfaces);

 private:
  enum class Ring { edges, elements };
  void add_ring(Ring kind);
  void add_around(Index vertex, Ring kind);
  void add(Index vertex);

  const PatchTopology& topology_;
  std::vector<Index> mark_;  ///< number of the patch that took the vertex last
  Index patch_ = 0;
  Index region_ = 0;
  std::vector<Index> vertices_;
  std::size_t ring_ = 0;  ///< where the last ring begins
  std::vector<Index> kept_;
};

}  // namespace anisofront
