#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

using Triangle = std::array<Index, 3>;  ///< anticlockwise vertices
using Quad = std::array<Index, 4>;      ///< anticlockwise vertices

/// An edge on the boundary, on an interface between regions or on an embedded curve.
/// On an outer boundary the domain lies to the left of vertices[0] -> vertices[1].
struct CurveEdge {
  std::array<Index, 2> vertices{kNoIndex, kNoIndex};
  Index tag = 0;                       ///< physical tag (0: none)
  Index curve = kNoIndex;              ///< index into Domain::curves, or Gmsh elementary tag
  std::array<double, 2> parameters{};  ///< curve parameters of the two vertices
};

/// Name of a physical tag; dimension 0 points, 1 curves, 2 regions.
struct PhysicalGroup {
  int dimension = 2;
  Index tag = 0;
  std::string name;
  friend bool operator==(const PhysicalGroup&, const PhysicalGroup&) = default;
};

/// A mesh: plain arrays. Everything else (neighbours, edges, stars) is derived by the functions
/// of topology.hpp when needed and thrown away.
struct Mesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Quad> quads;
  std::vector<Index> triangle_regions;  ///< physical tag per triangle
  std::vector<Index> quad_regions;      ///< physical tag per quad
  std::vector<CurveEdge> edges;
  std::vector<Index> vertex_tags;        ///< physical tag per vertex (0: none); empty: all 0
  std::vector<Index> corners;            ///< vertices where a boundary curve must not be smoothed
  std::vector<Index> required_vertices;  ///< vertices that remeshing must keep
  std::vector<PhysicalGroup> groups;
};

/// Name of the group, or an empty string.
inline std::string group_name(const Mesh& mesh, int dimension, Index tag) {
  for (const PhysicalGroup& group : mesh.groups)
    if (group.dimension == dimension && group.tag == tag) return group.name;
  return {};
}

}  // namespace anisofront
