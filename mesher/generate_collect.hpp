#pragma once

#include "mesher/front/boundary.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// The finished mesh and the background metric at its vertices.
struct Collected {
  Mesh mesh;
  MetricField metric;
};

/// Turns the work mesh into a Mesh: live triangles with their regions, vertices in order of
/// creation, curve edges with parameters and tags, corners, required points, group names of the
/// domain. The work mesh is gone when this returns, before checks need memory.
Collected collect(const Domain& domain, Boundary boundary);

/// The same for triangles and quadrilaterals, each kind in the order of the faces.
/// `point_vertices`: the vertex of each domain point. O(n).
/// Throws MeshingError for a face that no segment gives a region and for a domain point without
/// vertex; other defects are left to require_valid().
Collected collect(const Domain& domain, MixedMesh work, const std::vector<Index>& point_vertices);

/// Throws MeshingError with the number of triangles and the place of the first one, if there are
/// any.
void require_quadrilaterals(const MixedMesh& mesh);

}  // namespace anisofront
