#pragma once

#include "mesher/front/boundary.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"

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

}  // namespace anisofront
