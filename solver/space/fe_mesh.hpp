#pragma once

#include <array>
#include <vector>

#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/monitor.hpp"
#include "solver/space/edge_numbering.hpp"

namespace anisofront {

/// A mesh as finite elements see it: its edges numbered, and bent where they lie on a known curve.
/// A view: the mesh must outlive it. Elements are numbered triangles first, then quadrilaterals.
struct FeMesh {
  const Mesh& mesh;
  EdgeNumbering edges;
  /// Per edge the point half way: the midpoint of the chord, or a point of the curve.
  std::vector<Point> edge_points;
  /// Per edge; elements with a bent edge are mapped by polynomials of second degree.
  std::vector<char> edge_is_bent;
  /// Per entry of Mesh::edges the unit tangents of the curve at its two vertices, from
  /// vertices[0] to vertices[1]; those of the chord where the curve is not known.
  std::vector<std::array<Vector, 2>> curve_tangents;

  Index element_count() const {
    return static_cast<Index>(mesh.triangles.size() + mesh.quads.size());
  }
};

/// All edges straight. Throws InputError for meshes without elements and see number_edges().
FeMesh straight_fe_mesh(const Mesh& mesh);
FeMesh straight_fe_mesh(const Mesh&&) = delete;  ///< would dangle

/// Edges on curves of the domain (CurveEdge::curve and parameters) bent by a second-order map:
/// edge_points are where the normal of the chord through its midpoint meets the curve. An edge
/// whose bend would turn an element inside out stays straight; one warning counts them.
FeMesh curved_fe_mesh(const Mesh& mesh, const Domain& domain, const Monitor& monitor = {});
FeMesh curved_fe_mesh(const Mesh&&, const Domain&, const Monitor& = {}) = delete;

enum class Shape : unsigned char { triangle, quadrilateral };

/// One element with all that element matrices need. Local order everywhere: corners anticlockwise,
/// then edges (edge k joins corners k and k + 1), then the centre.
struct Element {
  Index number = kNoIndex;
  Shape shape = Shape::triangle;
  int corners = 3;
  bool bent = false;
  Index region = 0;  ///< physical tag
  std::array<Index, 4> vertices{};
  std::array<Index, 4> edges{};
  /// Corners, edge points, centre: 3 + 3 of a triangle, 4 + 4 + 1 of a quadrilateral (there the
  /// centre is half the sum of the edge points less a quarter of that of the corners).
  std::array<Point, 9> nodes{};
};

Element element_at(const FeMesh& mesh, Index element);

}  // namespace anisofront
