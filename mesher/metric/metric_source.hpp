#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/metric_field.hpp"
#include "mesher/metric/metric_length.hpp"

namespace anisofront {

// Where the statistics of a mesh take the metric from: both sources know the metrics at the
// vertices, the density of length along an edge and sqrt(det M) inside an element.

/// Throws InputError when the field does not hold one metric per vertex.
inline void require_one_per_vertex(const Mesh& mesh, const MetricField& field) {
  if (field.size() != mesh.points.size())
    throw InputError("the metric field has " + std::to_string(field.size()) +
                     " entries, expected one per vertex: " + std::to_string(mesh.points.size()));
}

/// A metric given by a function: vertices are looked up once, the rest where it is asked for.
class FunctionSource {
 public:
  FunctionSource(const Mesh& mesh, const MetricFunction& metric) : mesh_(mesh), metric_(metric) {
    vertex_metrics_.reserve(mesh.points.size());
    for (const Point p : mesh.points) vertex_metrics_.push_back(metric(p));
  }
  const MetricField& vertex_metrics() const { return vertex_metrics_; }

  /// Density of length along the edge, as a function of t in [0,1].
  auto density(HalfEdge edge) const {
    const Point a = mesh_.points[edge.from], b = mesh_.points[edge.to];
    return [this, a, b](double t) { return length(metric_(lerp(a, b, t)), b - a); };
  }
  /// sqrt(det M) where the vertices have the given weights.
  template <std::size_t N>
  double element_density(const std::array<Index, N>& vertices,
                         const std::array<double, N>& weights) const {
    Point p;
    for (std::size_t i = 0; i < N; ++i) p = p + weights[i] * mesh_.points[vertices[i]];
    return std::sqrt(determinant(metric_(p)));
  }

 private:
  const Mesh& mesh_;
  const MetricFunction& metric_;
  MetricField vertex_metrics_;
};

/// A metric given at the vertices, H = M^(-1/2) linear between them.
class FieldSource {
 public:
  FieldSource(const Mesh& mesh, const MetricField& field) : mesh_(mesh), field_(field) {
    require_one_per_vertex(mesh, field);
    sizes_.reserve(field.size());
    for (const Metric& m : field) sizes_.push_back(size_of(m));
  }
  const MetricField& vertex_metrics() const { return field_; }

  /// |H^-1 v| = |adj(H) v| / det H, with adj(H) v linear and det H from the linear H.
  auto density(HalfEdge edge) const {
    const SizeTensor h0 = sizes_[edge.from], h1 = sizes_[edge.to];
    const Vector v = mesh_.points[edge.to] - mesh_.points[edge.from];
    return [h0, h1, v](double t) {
      const SizeTensor h{h0.h11 + t * (h1.h11 - h0.h11), h0.h12 + t * (h1.h12 - h0.h12),
                         h0.h22 + t * (h1.h22 - h0.h22)};
      const Vector u{h.h22 * v.x - h.h12 * v.y, h.h11 * v.y - h.h12 * v.x};
      return norm(u) / (h.h11 * h.h22 - h.h12 * h.h12);
    };
  }
  template <std::size_t N>
  double element_density(const std::array<Index, N>& vertices,
                         const std::array<double, N>& weights) const {
    SizeTensor h{0, 0, 0};
    for (std::size_t i = 0; i < N; ++i) {
      const SizeTensor& of_vertex = sizes_[vertices[i]];
      h.h11 += weights[i] * of_vertex.h11;
      h.h12 += weights[i] * of_vertex.h12;
      h.h22 += weights[i] * of_vertex.h22;
    }
    return 1 / (h.h11 * h.h22 - h.h12 * h.h12);
  }

 private:
  const Mesh& mesh_;
  const MetricField& field_;
  std::vector<SizeTensor> sizes_;
};

}  // namespace anisofront
