#pragma once

#include <array>

#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// How many unknowns sit on each vertex, each edge and inside each element. Those inside are
/// eliminated element by element and never enter the global system.
struct DofLayout {
  int per_vertex = 1;
  int per_edge = 0;
  int in_triangle = 0;
  int in_quad = 0;
};

/// Most unknowns of one element (MITC9: 8 x 3 + 2; the control element with 9 deflections: 27).
inline constexpr int kMaxElementDofs = 27;

/// Numbers the global unknowns: those of vertex 0, of vertex 1, ..., of edge 0, ...
struct DofMap {
  DofLayout layout;
  Index vertices = 0;
  Index edges = 0;

  Index count() const { return vertices * layout.per_vertex + edges * layout.per_edge; }
  Index at_vertex(Index v, int component = 0) const { return v * layout.per_vertex + component; }
  Index at_edge(Index e, int component = 0) const {
    return vertices * layout.per_vertex + e * layout.per_edge + component;
  }
  int inner(Shape shape) const {
    return shape == Shape::triangle ? layout.in_triangle : layout.in_quad;
  }
  /// Global unknowns of an element.
  int outer(Shape shape) const {
    return (shape == Shape::triangle ? 3 : 4) * (layout.per_vertex + layout.per_edge);
  }
};

DofMap make_dof_map(const FeMesh& mesh, DofLayout layout);

/// Local order of an element's unknowns: vertex unknowns corner by corner, edge unknowns edge by
/// edge, then the inner ones. This gives the global numbers of all but the inner.
struct ElementDofs {
  std::array<Index, kMaxElementDofs> numbers{};
  int count = 0;
};
ElementDofs element_dofs(const DofMap& dofs, const Element& element);

}  // namespace anisofront
