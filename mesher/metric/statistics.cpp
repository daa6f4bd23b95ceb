#include "mesher/metric/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/metric/metric_source.hpp"
#include "mesher/metric/quality.hpp"

namespace anisofront {

namespace {

constexpr double kSubSegment = 0.1;

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

/// Calls visit(length, is_boundary) for every edge in the order of mesh_edges().
template <class Source, class Visit>
void for_each_edge_length(const Source& source, const Mesh& mesh, Visit visit) {
  const HalfEdges edges = half_edges(mesh);
  const std::vector<Index> twin =
      half_edge_twins(edges, static_cast<Index>(mesh.points.size())).twin;
  const MetricField& metrics = source.vertex_metrics();
  for (Index h = 0; h < edges.count(); ++h) {
    if (twin[h] != kNoIndex && twin[h] < h) continue;
    const HalfEdge e = edges[h];
    const Vector v = mesh.points[e.to] - mesh.points[e.from];
    double sum = 0;
    for_each_sub_segment(source.density(e), length(metrics[e.from], v), length(metrics[e.to], v),
                         kSubSegment, [&](double, double piece) { sum += piece; });
    visit(sum, twin[h] == kNoIndex);
  }
}

template <class Source>
void measure_edges(const Source& source, const Mesh& mesh, MeshStatistics& statistics) {
  Range range;
  for_each_edge_length(source, mesh, [&](double length_of_edge, bool is_boundary) {
    count_length(length_of_edge, statistics, range);
    ++statistics.edges;
    statistics.boundary_edges += is_boundary;
  });
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

/// Not a number, as an element without an area gives, counts in the first bin.
std::size_t quality_bin(double quality) {
  constexpr double kSlack = 1e-12;  // rounding of qualities that sit on a bound
  const double bin = std::floor(kQualityBins * quality * (1 + kSlack));
  return bin > 0 ? static_cast<std::size_t>(std::min(bin, kQualityBins - 1.)) : 0;
}

void measure_elements(const Mesh& mesh, const MetricField& metrics, MeshStatistics& statistics) {
  Range quality, angles;
  double log_sum = 0;
  for (const double q : qualities(mesh, metrics)) {
    quality.add(q);
    log_sum += std::log(std::max(q, 0.));
    ++statistics.quality_histogram[quality_bin(q)];
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

std::vector<double> edge_lengths(const Mesh& mesh, const MetricFunction& metric) {
  std::vector<double> lengths;
  lengths.reserve(2 * mesh.points.size() + mesh.triangles.size());
  for_each_edge_length(FunctionSource(mesh, metric), mesh,
                       [&](double length_of_edge, bool) { lengths.push_back(length_of_edge); });
  return lengths;
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
