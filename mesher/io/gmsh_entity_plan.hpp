#pragma once

#include <array>
#include <compare>
#include <string>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Model entities for a .msh file: in format 4.1 physical tags sit on entities, so each tagged
/// vertex, each pair (curve, tag) and each region becomes one.
struct GmshEntityPlan {
  struct Entity {
    Index tag = 0;  ///< elementary tag, > 0
    Index physical = 0;
    Point low{}, high{};  ///< bounding box
  };
  std::array<std::vector<Entity>, 3> entities;  ///< points, curves, surfaces
  std::vector<Index> point_vertices;            ///< vertex of each point entity
  std::vector<std::size_t> edge_curves;         ///< entity of each curve edge
  std::vector<std::size_t> triangle_surfaces;
  std::vector<std::size_t> quad_surfaces;

  /// The entity of lowest dimension that holds a vertex.
  struct Place {
    std::size_t dimension = 2;
    std::size_t entity = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  std::vector<Place> places;  ///< one per vertex
};

/// Elementary tags are CurveEdge::curve and the regions where these are positive and no other
/// entity has them. Throws InputError "cannot write NAME: ..." for negative tags.
GmshEntityPlan plan_gmsh_entities(const Mesh& mesh, const std::string& name);

}  // namespace anisofront
