#pragma once

#include <string>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// What check_mesh() found. `defects` holds at most ten sentences per kind, each naming element
/// or vertex numbers (1-based, as in files) and coordinates.
struct MeshReport {
  Index vertices = 0;
  Index triangles = 0;
  Index quads = 0;
  Index edges = 0;
  Index boundary_edges = 0;  ///< edges of one element only
  Index components = 0;      ///< edge-connected parts
  Index holes = 0;           ///< from Euler's formula: components - (V - E + F)
  double area = 0;           ///< sum of the element areas
  double boundary_area = 0;  ///< area enclosed by the boundary edges (shoelace formula)
  std::vector<std::string> defects;
  bool valid() const { return defects.empty(); }
};

/// Complete validity check: vertex numbers in range, finite coordinates, positive orientation of
/// every triangle and of all four corners of every quad (exact predicate), no edge shared by more
/// than two elements or run through twice in one direction, no duplicate or unused vertices,
/// every curve edge is an edge of the mesh, every boundary edge is a curve edge (when the mesh
/// has any), areas agree to 1e-12 relative, array sizes consistent. Never throws on bad meshes.
MeshReport check_mesh(const Mesh& mesh);

/// Throws MeshingError with the defects when the mesh is not valid.
void require_valid(const Mesh& mesh);

/// For meshes that come from outside and are to be remeshed: throws InputError, beginning with the
/// name, for coordinates, vertex numbers, orientations and duplicate vertices that are wrong.
/// Unused vertices and missing curve edges do no harm there; edges of more than two elements are
/// found where neighbours are derived.
void require_usable(const Mesh& mesh, const std::string& name);

}  // namespace anisofront
