#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// Upper bounds of the edge-length histogram bins: 0.1, 0.2, ... 3.0, then infinity. A length on a
/// bound counts in the bin above it.
inline constexpr int kLengthBins = 31;

/// Upper bounds of the quality histogram bins: 0.05, 0.1, ... 1. A quality on a bound counts in the
/// bin above it, 1 in the last one, negative ones in the first.
inline constexpr int kQualityBins = 20;

/// Shape and size of a mesh against a metric: the columns of the paper's Tables 1-4.
struct MeshStatistics {
  Index vertices = 0, elements = 0, edges = 0, boundary_edges = 0, triangles = 0, quads = 0;
  double quality_mean = 0;  ///< geometric mean of alpha~ (triangles) and beta~ (quads); 0 when one
                            ///< of them is not positive
  double quality_min = 0;
  double length_min = 0, length_max = 0;
  double percent_half = 0;              ///< edges with length in [0.5, 1.5], percent
  double percent_unit = 0;              ///< edges with length in [1/sqrt2, sqrt2], percent
  double complexity = 0;                ///< integral of sqrt(det M) over the mesh
  double angle_min = 0, angle_max = 0;  ///< corner angles in the metric, degrees
  double scaled_jacobian_min = 0;       ///< physical, quads only (1 for triangles)
  double stretch_max = 1;               ///< largest h2/h1 over the vertices
  std::array<std::int64_t, kLengthBins> histogram{};           ///< of the edge lengths
  std::array<std::int64_t, kQualityBins> quality_histogram{};  ///< of alpha~ and beta~
};

/// Lengths by Appendix B with sub-segments shorter than 0.1, alpha~ and beta~ with the metric at
/// the vertices (Eqns 15, 16). `metric` is called once at every vertex, inside every edge (about 15
/// times where edges are near unit length; edges in the order of the elements, each edge from one
/// end to the other) and at the quadrature points of every element.
/// Preconditions: vertex numbers in range, metric positive definite. All zero without elements.
MeshStatistics mesh_statistics(const Mesh& mesh, const MetricFunction& metric);

/// The same with one metric per vertex only: along an edge the size is interpolated linearly in
/// M^(-1/2) between its ends. What `check --metric` uses when the field sits on the mesh itself.
/// Throws InputError when the field does not hold one metric per vertex.
MeshStatistics mesh_statistics(const Mesh& mesh, const MetricField& field);

/// The length of every edge in the order of mesh_edges(): the numbers that mesh_statistics()
/// counts. `metric` is called as it does for edges. Same preconditions; empty without elements.
std::vector<double> edge_lengths(const Mesh& mesh, const MetricFunction& metric);

/// alpha~ of every triangle, then beta~ of every quad, in the metrics at the vertices (Eqns 15,
/// 16). Throws InputError when the field does not hold one metric per vertex.
std::vector<double> element_qualities(const Mesh& mesh, const MetricField& field);

/// The least sine of the corner angles of every element, in the plane: 1 for rectangles, negative
/// where a corner is concave. 1 for triangles, which come first.
std::vector<double> scaled_jacobians(const Mesh& mesh);

/// Ideal number of triangles, (4 / sqrt 3) * integral of sqrt(det M), of a field on a mesh
/// (degree-2 quadrature per element); the integral itself is the ideal number of quads.
/// Throws InputError when the field does not hold one metric per vertex.
double metric_complexity(const Mesh& mesh, const MetricField& field);

}  // namespace anisofront
