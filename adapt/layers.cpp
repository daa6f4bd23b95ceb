#include "adapt/layers.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "adapt/curve_distance.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void require_settings(const Mesh& mesh, const LayerSettings& layers) {
  if (!(layers.width > 0 && layers.first_size > 0 && layers.reach > 0 && layers.growth >= 0))
    throw InputError(
        "layers: width = " + describe(layers.width) +
        ", first_size = " + describe(layers.first_size) + ", reach = " + describe(layers.reach) +
        ", growth = " + describe(layers.growth) + "; expected positive numbers (growth may be 0)");
  for (const Index tag : layers.tags)
    if (std::none_of(mesh.edges.begin(), mesh.edges.end(),
                     [tag](const CurveEdge& edge) { return edge.tag == tag; }))
      throw InputError("layers: no edge of the mesh has the tag " + std::to_string(tag) +
                       "; name curves of the domain");
}

/// The Hessian without its mixed term in the frame of the unit vector s and its normal.
Hessian without_mixed_term(const Hessian& h, Vector s) {
  const Vector n{s.y, -s.x};
  const Vector hn{h.xx * n.x + h.xy * n.y, h.xy * n.x + h.yy * n.y};
  const Vector hs{h.xx * s.x + h.xy * s.y, h.xy * s.x + h.yy * s.y};
  const double nn = dot(n, hn), ss = dot(s, hs);
  return {nn * n.x * n.x + ss * s.x * s.x, nn * n.x * n.y + ss * s.x * s.y,
          nn * n.y * n.y + ss * s.y * s.y};
}

}  // namespace

LayerFrame layer_frame(const FeMesh& mesh, const LayerSettings& layers) {
  const auto& points = mesh.mesh.points;
  LayerFrame frame{std::vector<double>(points.size(), kInfinity),
                   std::vector<Vector>(points.size(), {1, 0})};
  if (layers.tags.empty()) return frame;
  require_settings(mesh.mesh, layers);
  const CurveDistance distance(mesh, layers.tags, layers.reach * layers.width);
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::size_t v = 0; v < points.size(); ++v)
    if (const auto nearest = distance.nearest(points[v])) {
      frame.distance[v] = nearest->distance;
      frame.tangent[v] = nearest->tangent;
    }
  return frame;
}

void align_with_layers(const LayerFrame& frame, double reach, FieldHessians& fields) {
  for (std::vector<Hessian>& field : fields) {
    if (field.size() != frame.distance.size())
      throw InputError(
          "alignment with layers: " + std::to_string(field.size()) +
          " Hessians, expected one per vertex: " + std::to_string(frame.distance.size()));
    for (std::size_t v = 0; v < field.size(); ++v)
      if (frame.distance[v] <= reach) field[v] = without_mixed_term(field[v], frame.tangent[v]);
  }
}

MetricField layer_metric(const Mesh& mesh, const LayerFrame& frame, const LayerSettings& layers,
                         double along) {
  MetricField field(mesh.points.size(), metric_from_size(along));
  for (std::size_t v = 0; v < field.size(); ++v) {
    const double d = frame.distance[v];
    if (d > layers.reach * layers.width) continue;
    const double across = layers.width * layers.first_size + layers.growth * d;
    const Vector s = frame.tangent[v];
    field[v] = metric_from_sizes(std::min(across, along), along, {s.y, -s.x});
  }
  return field;
}

}  // namespace anisofront
