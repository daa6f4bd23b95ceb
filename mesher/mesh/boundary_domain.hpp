#pragma once

#include <array>

#include "mesher/geometry/domain.hpp"
#include "mesher/mesh/mesh.hpp"

namespace anisofront {

enum class BoundaryShape { linear, smooth };

struct BoundaryDomainOptions {
  /// Turning angle, in degrees, above which a boundary vertex is a corner.
  double corner_angle = 40;
  /// linear: polylines through the vertices; smooth: G1 cubic splines between corners.
  BoundaryShape shape = BoundaryShape::linear;
};

/// The domain of a mesh: boundary edges and interfaces between regions become curves, chained and
/// split at corners by angle, at changes of tag, at junctions and at Mesh::corners and
/// required_vertices; tagged edges inside a region become embedded curves; required vertices
/// become points. Vertices whose tag is a named group of dimension 0 count as required.
/// Curve names come from the groups (a number is appended where a group holds several chains:
/// "wall", "wall-2"); the physical tag of each chain is kept. Edges without a tag get the smallest
/// unused ones and the names "boundary" and "interface". Regions follow the element tags, one per
/// edge-connected part.
/// Fills tag, curve and parameters (k at vertex k of the chain) of `mesh.edges`, adds the missing
/// ones and turns boundary edges so that the mesh lies to their left: the mesh can be the
/// background of its own domain.
/// O(n) in the number of elements but for sorting the curve edges.
/// Throws InputError naming the vertices of non-manifold edges, of tagged edges that are no side
/// of an element, and of indices out of range.
Domain domain_from_mesh(Mesh& mesh, const BoundaryDomainOptions& options = {});

/// Fills curve and parameters of the edges of a mesh that discretises `domain` coarsely: edges are
/// matched by group name (with the curves that share the tag of the curve of that name), else by
/// tag, else by the nearest curve; parameters by projection, in the order of the edge's vertices
/// (at the seam of a closed curve: begin or end, as the edge leaves or reaches it). Where a closed
/// curve has no mesh vertex at its seam one edge runs over it: crosses_seam(). A mesh without any
/// edges gets its boundary edges; untagged edges get the tag of their curve.
/// Throws InputError naming the edge whose vertices lie further than `tolerance` times the bounding
/// box diagonal from its curve, or that spans more than half of a closed curve.
void attach_to_domain(Mesh& mesh, const Domain& domain, double tolerance = 1e-3);

/// True for an edge of a closed curve that runs over the point where the parameter starts again:
/// its parameters lie near both ends of the range, more than half of it apart.
bool crosses_seam(const NurbsCurve& curve, const std::array<double, 2>& parameters);

}  // namespace anisofront
