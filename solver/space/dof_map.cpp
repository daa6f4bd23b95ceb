#include "solver/space/dof_map.hpp"

#include <limits>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {

DofMap make_dof_map(const FeMesh& mesh, DofLayout layout) {
  const auto vertices = static_cast<Index>(mesh.mesh.points.size());
  const double count = static_cast<double>(vertices) * layout.per_vertex +
                       static_cast<double>(mesh.edges.count()) * layout.per_edge;
  if (count > std::numeric_limits<Index>::max())
    throw BudgetError(std::to_string(count) +
                      " unknowns are more than 32 bits can number; use a "
                      "coarser mesh or elements of lower order");
  return {layout, vertices, mesh.edges.count()};
}

ElementDofs element_dofs(const DofMap& dofs, const Element& element) {
  ElementDofs result;
  for (int k = 0; k < element.corners; ++k)
    for (int c = 0; c < dofs.layout.per_vertex; ++c)
      result.numbers[result.count++] = dofs.at_vertex(element.vertices[k], c);
  for (int k = 0; k < element.corners; ++k)
    for (int c = 0; c < dofs.layout.per_edge; ++c)
      result.numbers[result.count++] = dofs.at_edge(element.edges[k], c);
  return result;
}

}  // namespace anisofront
