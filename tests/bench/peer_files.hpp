#pragma once

#include <string>

#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

// Input files of other meshers. All throw InputError when a file cannot be written.

/// bamg's metric: the number of vertices and of components, then m11 m12 m22 line by line.
void write_bamg_metric(const std::string& path, const MetricField& field);

/// A Gmsh view on the triangles of a mesh, for -bgm: the size at every corner when the metric is
/// isotropic, or else the metric as a tensor in three dimensions (1 across the plane, so that it
/// has an inverse).
void write_gmsh_view(const std::string& path, const Mesh& mesh, const MetricField& field,
                     bool isotropic);

/// Gmsh geometry of the square [0, side]^2.
void write_gmsh_square(const std::string& path, double side);

}  // namespace anisofront
