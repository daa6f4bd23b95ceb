#pragma once

#include <vector>

#include "adapt/density.hpp"
#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// Layers of width delta along curves (decay exp(-d / delta)).
struct LayerSettings {
  std::vector<Index> tags;  ///< curves that carry layers; empty: none
  double width = 0;         ///< delta, length
  double first_size = 0.5;  ///< size across at the curve, in widths
  double reach = 20;        ///< alignment holds up to this distance, in widths
  double growth = 0.3;      ///< growth of the size across per length of distance
};

/// Distance from each vertex to the nearest curve edge with one of the tags (bent edges as FeMesh
/// maps them; straight through walls and holes), and the unit tangent there (of the curve where
/// FeMesh knows it). Up to `reach` widths only; beyond, the distance is infinite and the tangent
/// (1, 0). Of edges at equal distance the first one counts.
struct LayerFrame {
  std::vector<double> distance;
  std::vector<Vector> tangent;
};
/// Without tags all distances are infinite. Throws InputError when width, first_size or reach are
/// not positive or growth is negative, and for a tag that no edge of the mesh has.
LayerFrame layer_frame(const FeMesh& mesh, const LayerSettings& layers);

/// Drops the mixed term of the Hessians in the (n, s) frame of the nearest edge for vertices within
/// `reach` (a length): an angle error d of the recovered direction would leak d^2 H_nn into H_ss.
/// Throws InputError when a field does not hold one Hessian per vertex.
void align_with_layers(const LayerFrame& frame, double reach, FieldHessians& fields);

/// A-priori metric of a layer: across h(d) = width * first_size + growth * d, along `along` (a
/// length; no size exceeds it), beyond reach none (size `along` both ways). To be intersected in
/// cycle 0.
MetricField layer_metric(const Mesh& mesh, const LayerFrame& frame, const LayerSettings& layers,
                         double along);

}  // namespace anisofront
