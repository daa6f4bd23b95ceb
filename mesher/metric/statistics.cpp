#include "mesher/metric/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/metric_length.hpp"
#include "mesher/metric/quality.hpp"

namespace anisofront {

namespace {

constexpr double kSubSegment = 0.1;

void require_one_per_vertex(const Mesh& mesh, const MetricField& field) {
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

/// Integral over one triangle: the three edge midpoints, exact for degree 2.
template <class Source>
double element_complexity(const Source& source, const Mesh& mesh, const Triangle& t) {
  const double sum = source.template element_density<3>(t, {0.5, 0.5, 0}) +
                     source.template element_density<3>(t, {0, 0.5, 0.5}) +
                     source.template element_density<3>(t, {0.5, 0, 0.5});
  return sum / 6 * twice_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

/// Integral over one quadrilateral: 2 x 2 Gauss points on the bilinear map, degree 3.
template <class Source>
double element_complexity(const Source& source, const Mesh& mesh, const Quad& q) {
  constexpr double kNear = 0.21132486540518713;  // (1 - 1/sqrt 3) / 2
  const std::vector<Point>& p = mesh.points;
  double sum = 0;
  for (const double xi : {kNear, 1 - kNear})
    for (const double eta : {kNear, 1 - kNear}) {
      const Vector along_xi = lerp(p[q[1]] - p[q[0]], p[q[2]] - p[q[3]], eta);
      const Vector along_eta = lerp(p[q[3]] - p[q[0]], p[q[2]] - p[q[1]], xi);
      sum += 0.25 * cross(along_xi, along_eta) *
             source.template element_density<4>(
                 q, {(1 - xi) * (1 - eta), xi * (1 - eta), xi * eta, (1 - xi) * eta});
    }
  return sum;
}

template <class Source>
double complexity(const Source& source, const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += element_complexity(source, mesh, t);
  for (const Quad& q : mesh.quads) sum += element_complexity(source, mesh, q);
  return sum;
}

/// Least and largest of a set of values, and the count of them.
struct Range {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  void add(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
};

void count_length(double length, MeshStatistics& statistics, Range& range) {
  constexpr double kSlack = 1e-12;  // rounding of lengths that sit on a bound
  const auto within = [length](double low, double high) {
    return length >= low * (1 - kSlack) && length <= high * (1 + kSlack);
  };
  constexpr double kSqrt2 = 1.4142135623730951;
  range.add(length);
  statistics.percent_half += within(0.5, 1.5);
  statistics.percent_unit += within(1 / kSqrt2, kSqrt2);
  const double bin = std::floor(10 * length * (1 + kSlack));
  ++statistics.histogram[static_cast<std::size_t>(std::clamp(bin, 0., kLengthBins - 1.))];
}

template <class Source>
void measure_edges(const Source& source, const Mesh& mesh, MeshStatistics& statistics) {
  const HalfEdges edges = half_edges(mesh);
  const std::vector<Index> twin =
      half_edge_twins(edges, static_cast<Index>(mesh.points.size())).twin;
  Range range;
  for (Index h = 0; h < edges.count(); ++h) {
    if (twin[h] != kNoIndex && twin[h] < h) continue;
    const HalfEdge e = edges[h];
    const Vector v = mesh.points[e.to] - mesh.points[e.from];
    const MetricField& m = source.vertex_metrics();
    double length_of_edge = 0;
    for_each_sub_segment(source.density(e), length(m[e.from], v), length(m[e.to], v), kSubSegment,
                         [&](double, double piece) { length_of_edge += piece; });
    count_length(length_of_edge, statistics, range);
    ++statistics.edges;
    statistics.boundary_edges += twin[h] == kNoIndex;
  }
  statistics.length_min = range.min;
  statistics.length_max = range.max;
  statistics.percent_half = 100. * statistics.percent_half / statistics.edges;
  statistics.percent_unit = 100. * statistics.percent_unit / statistics.edges;
}

template <std::size_t N>
void add_angles(const Mesh& mesh, const MetricField& metrics, const std::array<Index, N>& element,
                Range& angles) {
  constexpr double kDegrees = 57.29577951308232;
  for (std::size_t i = 0; i < N; ++i) {
    const Point p = mesh.points[element[i]];
    const Vector next = mesh.points[element[(i + 1) % N]] - p;
    const Vector previous = mesh.points[element[(i + N - 1) % N]] - p;
    angles.add(kDegrees * angle(metrics[element[i]], next, previous));
  }
}

double scaled_jacobian(const Mesh& mesh, const Quad& q) {
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector next = mesh.points[q[(i + 1) % 4]] - mesh.points[q[i]];
    const Vector previous = mesh.points[q[(i + 3) % 4]] - mesh.points[q[i]];
    const double lengths = norm(next) * norm(previous);
    least = std::min(least, lengths > 0 ? cross(next, previous) / lengths : 0);
  }
  return least;
}

template <std::size_t N, class T>
std::array<T, N> gather(const std::vector<T>& values, const std::array<Index, N>& vertices) {
  std::array<T, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = values[vertices[i]];
  return result;
}

std::vector<double> qualities(const Mesh& mesh, const MetricField& metrics) {
  std::vector<MetricFactor> factors(metrics.size());
  std::transform(metrics.begin(), metrics.end(), factors.begin(),
                 [](const Metric& m) { return factor_of(m); });
  std::vector<double> result;
  result.reserve(mesh.triangles.size() + mesh.quads.size());
  for (const Triangle& t : mesh.triangles)
    result.push_back(alpha(gather(factors, t), gather(mesh.points, t)));
  for (const Quad& q : mesh.quads)
    result.push_back(beta(gather(factors, q), gather(mesh.points, q)));
  return result;
}

void measure_elements(const Mesh& mesh, const MetricField& metrics, MeshStatistics& statistics) {
  Range quality, angles;
  double log_sum = 0;
  for (const double q : qualities(mesh, metrics)) {
    quality.add(q);
    log_sum += std::log(std::max(q, 0.));
  }
  for (const Triangle& t : mesh.triangles) add_angles(mesh, metrics, t, angles);
  statistics.scaled_jacobian_min = 1;
  for (const Quad& q : mesh.quads) {
    add_angles(mesh, metrics, q, angles);
    statistics.scaled_jacobian_min =
        std::min(statistics.scaled_jacobian_min, scaled_jacobian(mesh, q));
  }
  statistics.quality_min = quality.min;
  statistics.quality_mean = std::exp(log_sum / statistics.elements);
  statistics.angle_min = angles.min;
  statistics.angle_max = angles.max;
}

template <class Source>
MeshStatistics statistics_of(const Source& source, const Mesh& mesh) {
  MeshStatistics statistics;
  statistics.vertices = static_cast<Index>(mesh.points.size());
  statistics.triangles = static_cast<Index>(mesh.triangles.size());
  statistics.quads = static_cast<Index>(mesh.quads.size());
  statistics.elements = statistics.triangles + statistics.quads;
  if (statistics.elements == 0) return statistics;
  measure_edges(source, mesh, statistics);
  measure_elements(mesh, source.vertex_metrics(), statistics);
  for (const Metric& m : source.vertex_metrics())
    statistics.stretch_max = std::max(statistics.stretch_max, stretch_of(m));
  statistics.complexity = complexity(source, mesh);
  return statistics;
}

}  // namespace

MeshStatistics mesh_statistics(const Mesh& mesh, const MetricFunction& metric) {
  return statistics_of(FunctionSource(mesh, metric), mesh);
}

MeshStatistics mesh_statistics(const Mesh& mesh, const MetricField& field) {
  return statistics_of(FieldSource(mesh, field), mesh);
}

std::vector<double> element_qualities(const Mesh& mesh, const MetricField& field) {
  require_one_per_vertex(mesh, field);
  return qualities(mesh, field);
}

std::vector<double> scaled_jacobians(const Mesh& mesh) {
  std::vector<double> result(mesh.triangles.size(), 1);
  result.reserve(mesh.triangles.size() + mesh.quads.size());
  for (const Quad& q : mesh.quads) result.push_back(scaled_jacobian(mesh, q));
  return result;
}

double metric_complexity(const Mesh& mesh, const MetricField& field) {
  constexpr double kTrianglesPerUnitArea = 2.3094010767585034;  // 4 / sqrt 3
  return kTrianglesPerUnitArea * complexity(FieldSource(mesh, field), mesh);
}

}  // namespace anisofront
