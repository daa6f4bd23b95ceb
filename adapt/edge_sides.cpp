#include "adapt/edge_sides.hpp"

namespace anisofront {
namespace {

template <std::size_t N>
void add_sides(const std::vector<std::array<Index, N>>& edges, Index first, EdgeSides& sides) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = 0; k < N; ++k) {
      auto& [a, b] = sides[edges[i][k]];
      (a.element == kNoIndex ? a : b) = {first + static_cast<Index>(i), static_cast<int>(k)};
    }
}

}  // namespace

EdgeSides edge_sides(const FeMesh& mesh) {
  EdgeSides sides(mesh.edges.count());
  add_sides(mesh.edges.triangle_edges, 0, sides);
  add_sides(mesh.edges.quad_edges, static_cast<Index>(mesh.mesh.triangles.size()), sides);
  return sides;
}

}  // namespace anisofront
