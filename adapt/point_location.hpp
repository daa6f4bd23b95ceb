#pragma once

#include <optional>

#include "mesher/background/background_mesh.hpp"
#include "mesher/mesh/topology.hpp"
#include "solver/space/element_map.hpp"

namespace anisofront {

/// A point of a mesh by its element.
struct Location {
  Element element;
  ReferencePoint at;
};

/// Finds the elements of points through the background location (walks and the alternating digital
/// tree), on bent elements by their own map. Any solution can be evaluated and carried to another
/// mesh with it. Not for use by several threads at once (it holds a hint).
class PointLocation {
 public:
  /// `mesh` must outlive it. Precondition: the mesh is valid (see check_mesh).
  explicit PointLocation(const FeMesh& mesh);

  /// Empty when p lies outside by more than `tolerance` (a length; 0: 1e-9 of the diagonal, so that
  /// points computed on the boundary count as inside); within it, the nearest point of the mesh.
  /// Throws InputError for coordinates that are not finite.
  std::optional<Location> find(Point p, double tolerance = 0);

  /// The element and point nearest to p, inside or not (values are continued constantly).
  /// Throws InputError for coordinates that are not finite.
  Location nearest(Point p);

  const FeMesh& mesh() const { return mesh_; }

 private:
  struct Found {
    Location location;
    double distance = 0;
  };
  Found search(Point p);
  Found nearest_around(const Element& element, Point p) const;

  const FeMesh& mesh_;
  BackgroundMesh background_;
  VertexStars stars_;  ///< empty when no element is bent
  Index hint_ = 0;
};

}  // namespace anisofront
