#include "mesher/background/background_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "mesher/background/locality.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/predicates.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/interpolation.hpp"

namespace anisofront {
namespace {

constexpr std::array<Index, 3> kNext{1, 2, 0};

/// Walks are a few steps long in the mesher and at most a few diameters of the mesh elsewhere; more
/// means a cycle, which visibility walks can run into on stretched triangles.
constexpr int kMaxWalk = 10000;

void require_metric(const Metric& m, Index vertex, Point p) {
  if (std::isfinite(m.m11) && std::isfinite(m.m12) && std::isfinite(m.m22) && m.m11 > 0 &&
      determinant(m) > 0)
    return;
  throw InputError("metric at vertex " + std::to_string(vertex + 1) + " (" + std::to_string(p.x) +
                   ", " + std::to_string(p.y) +
                   ") is not positive definite: m11 = " + std::to_string(m.m11) +
                   ", m12 = " + std::to_string(m.m12) + ", m22 = " + std::to_string(m.m22) +
                   "; give finite sizes greater than zero there");
}

Point nearest_on_segment(Point a, Point b, Point p) {
  const Vector u = b - a;
  const double t = std::clamp(dot(p - a, u) / squared_norm(u), 0., 1.);
  return lerp(a, b, t);
}

}  // namespace

BackgroundMesh::BackgroundMesh(const Mesh& mesh, const MetricField& field,
                               Interpolation interpolation)
    : interpolation_(interpolation) {
  const std::size_t count = mesh.points.size();
  if (field.size() != count)
    throw InputError("the background mesh has " + std::to_string(count) + " vertices but " +
                     std::to_string(field.size()) + " metrics are given; give one per vertex");
  if (mesh.triangles.empty() && mesh.quads.empty())
    throw InputError("the background mesh has no triangles or quadrilaterals");
  vertices_.resize(count);
  bounds_ = {mesh.points[0], mesh.points[0]};
  for (std::size_t v = 0; v < count; ++v) {
    const Point p = mesh.points[v];
    const Metric& m = field[v];
    require_metric(m, static_cast<Index>(v), p);
    bounds_.low = {std::min(bounds_.low.x, p.x), std::min(bounds_.low.y, p.y)};
    bounds_.high = {std::max(bounds_.high.x, p.x), std::max(bounds_.high.y, p.y)};
    if (interpolation == Interpolation::linear_size) {
      const SizeTensor h = size_of(m);
      vertices_[v] = {p, h.h11, h.h12, h.h22};
    } else {
      const Metric t = interpolation == Interpolation::log_euclidean ? logarithm(m) : m;
      vertices_[v] = {p, t.m11, t.m12, t.m22};
    }
  }
  add_walkers(mesh);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& v = triangles_[t].vertices;
    double density = 0;
    for (const Index i : v) density += std::sqrt(determinant(field[i]));
    complexity_ +=
        twice_area(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]) / 6 * density;
  }
  renumber_if_scattered();
}

void BackgroundMesh::add_walkers(const Mesh& mesh) {
  plain_triangles_ = static_cast<Index>(mesh.triangles.size());
  quads_ = mesh.quads;
  std::vector<Triangle> all;
  std::span<const Triangle> triangles = mesh.triangles;
  if (!quads_.empty()) {
    all = mesh.triangles;
    for (const Quad& q : quads_) {
      all.push_back({q[0], q[1], q[2]});
      all.push_back({q[0], q[2], q[3]});
    }
    triangles = all;
    element_of_.resize(all.size());
    for (std::size_t t = 0; t < all.size(); ++t) {
      const auto i = static_cast<Index>(t);
      element_of_[t] = i < plain_triangles_ ? i : plain_triangles_ + (i - plain_triangles_) / 2;
    }
  }
  const TriangleNeighbours neighbours =
      triangle_neighbours(triangles, static_cast<Index>(vertices_.size()));
  triangles_.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) triangles_[t] = {triangles[t], neighbours[t]};
}

void BackgroundMesh::renumber_if_scattered() {
  const auto vertex_of = [this](std::size_t t, int k) { return triangles_[t].vertices[k]; };
  if (!is_scattered(triangles_.size(), vertices_.size(), vertex_of)) return;
  std::vector<Point> points(vertices_.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = vertices_[v].p;
  const std::vector<Index> vertex_order = spatial_order(points, bounds_.low, bounds_.high);
  const std::vector<Index> new_vertex = inverse_permutation(vertex_order);
  std::vector<Point> centres(triangles_.size());
  for (std::size_t t = 0; t < centres.size(); ++t) {
    const auto& v = triangles_[t].vertices;
    centres[t] = (1. / 3) * (points[v[0]] + points[v[1]] + points[v[2]]);
  }
  const std::vector<Index> triangle_order = spatial_order(centres, bounds_.low, bounds_.high);
  const std::vector<Index> new_triangle = inverse_permutation(triangle_order);

  std::vector<Vertex> vertices(vertices_.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = vertices_[vertex_order[i]];
  vertices_ = std::move(vertices);
  std::vector<Walker> triangles(triangles_.size());
  std::vector<Index> element(triangles_.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Index old = triangle_order[i];
    Walker walker = triangles_[old];
    for (Index& v : walker.vertices) v = new_vertex[v];
    for (Index& n : walker.neighbours)
      if (n != kNoIndex) n = new_triangle[n];
    triangles[i] = walker;
    element[i] = element_of(old);
  }
  triangles_ = std::move(triangles);
  element_of_ = std::move(element);
  for (Quad& q : quads_)
    for (Index& v : q) v = new_vertex[v];
}

void BackgroundMesh::set_size_factor(double factor) {
  if (!(std::isfinite(factor) && factor > 0))
    throw InputError("the size factor of the background mesh is " + std::to_string(factor) +
                     "; give a finite number greater than zero");
  size_factor_ = factor;
}

Index BackgroundMesh::element_of(Index triangle) const {
  return element_of_.empty() ? triangle : element_of_[triangle];
}

BackgroundMesh::Stop BackgroundMesh::walk(Point p, Index hint) const {
  Index current = hint;
  Index previous = kNoIndex;
  for (int step = 0; step < kMaxWalk; ++step) {
    const Walker& walker = triangles_[current];
    const Vector a = vertices_[walker.vertices[0]].p - p;
    const Vector b = vertices_[walker.vertices[1]].p - p;
    const Vector c = vertices_[walker.vertices[2]].p - p;
    const std::array<double, 3> areas{cross(b, c), cross(c, a), cross(a, b)};
    Index next = kNoIndex;
    double worst = 0;
    bool blocked = false;
    for (int k = 0; k < 3; ++k) {
      if (areas[k] >= 0) continue;
      const Index neighbour = walker.neighbours[k];
      if (neighbour == kNoIndex) {
        blocked = true;
      } else if (neighbour != previous && areas[k] < worst) {
        worst = areas[k];
        next = neighbour;
      }
    }
    if (next == kNoIndex) return {current, areas, !blocked};
    previous = current;
    current = next;
  }
  return {current, {-1e300, 0, 0}, false};
}

bool BackgroundMesh::contains(Index triangle, Point p) const {
  const auto& v = triangles_[triangle].vertices;
  for (int k = 0; k < 3; ++k)
    if (orientation(vertices_[v[k]].p, vertices_[v[kNext[k]]].p, p) < 0) return false;
  return true;
}

Index BackgroundMesh::locate(Point p, Index hint) const {
  if (!(p.x >= bounds_.low.x && p.x <= bounds_.high.x && p.y >= bounds_.low.y &&
        p.y <= bounds_.high.y))
    return kNoIndex;
  const Index reached = walk(p, hint).triangle;
  return contains(reached, p) ? reached : locate_by_tree(p);
}

Box BackgroundMesh::box_of(Index triangle) const {
  const auto& v = triangles_[triangle].vertices;
  const Point a = vertices_[v[0]].p, b = vertices_[v[1]].p, c = vertices_[v[2]].p;
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

void BackgroundMesh::build_tree() const {
  std::call_once(tree_once_, [this] {
    auto tree = std::make_unique<AlternatingDigitalTree>(bounds_);
    tree->reserve(triangles_.size());
    for (Index t = 0; t < triangle_count(); ++t) tree->insert(box_of(t));
    tree_ = std::move(tree);
  });
}

Index BackgroundMesh::locate_by_tree(Point p) const {
  build_tree();
  Index found = kNoIndex;
  tree_->query({p, p}, [&](Index t) {
    if ((found == kNoIndex || t < found) && contains(t, p)) found = t;
  });
  return found;
}

BackgroundMesh::Nearest BackgroundMesh::nearest(Point p, Index hint) const {
  const Index inside = locate(p, hint);
  if (inside != kNoIndex) return {inside, p};
  return nearest_on_boundary(p);
}

void BackgroundMesh::build_boundary_tree() const {
  std::call_once(boundary_once_, [this] {
    auto tree = std::make_unique<AlternatingDigitalTree>(bounds_);
    for (Index t = 0; t < triangle_count(); ++t) {
      const Walker& walker = triangles_[t];
      for (int k = 0; k < 3; ++k) {
        if (walker.neighbours[k] != kNoIndex) continue;
        const Point a = vertices_[walker.vertices[kNext[k]]].p;
        const Point b = vertices_[walker.vertices[kNext[kNext[k]]]].p;
        boundary_edges_.push_back({t, a, b});
        tree->insert(enclosing({a, a}, b));
      }
    }
    boundary_tree_ = std::move(tree);
  });
}

BackgroundMesh::Nearest BackgroundMesh::nearest_on_boundary(Point p) const {
  build_boundary_tree();
  Nearest best{kNoIndex, p};
  double best_distance = std::numeric_limits<double>::infinity();
  const auto visit = [&](Index i) {
    const BoundaryEdge& edge = boundary_edges_[i];
    const Point q = nearest_on_segment(edge.a, edge.b, p);
    const double distance = norm(q - p);
    if (distance > best_distance || (distance == best_distance && edge.triangle > best.triangle))
      return;
    best_distance = distance;
    best = {edge.triangle, q};
  };
  const Vector beyond{std::max({bounds_.low.x - p.x, p.x - bounds_.high.x, 0.}),
                      std::max({bounds_.low.y - p.y, p.y - bounds_.high.y, 0.})};
  const auto search = [&](double r) {
    boundary_tree_->query({p - Vector{r, r}, p + Vector{r, r}}, visit);
  };
  double radius = norm(beyond) + 1e-3 * norm(bounds_.high - bounds_.low);
  for (; best.triangle == kNoIndex; radius *= 2) search(radius);
  if (best_distance > 0.5 * radius) search(best_distance);
  return best;
}

BackgroundMesh::Stop BackgroundMesh::stop_at(Index triangle, Point p) const {
  const auto& v = triangles_[triangle].vertices;
  const Vector a = vertices_[v[0]].p - p, b = vertices_[v[1]].p - p, c = vertices_[v[2]].p - p;
  return {triangle, {cross(b, c), cross(c, a), cross(a, b)}, true};
}

BackgroundMesh::Stop BackgroundMesh::stop_near(Point& p, Index hint, double slack) const {
  Stop stop = walk(p, hint);
  if (!stop.inside) {
    const double sum = stop.areas[0] + stop.areas[1] + stop.areas[2];
    const double lowest = std::min({stop.areas[0], stop.areas[1], stop.areas[2]});
    if (lowest < -slack * sum) {
      const Nearest at = nearest(p, stop.triangle);
      p = at.point;
      stop = stop_at(at.triangle, p);
    }
  }
  for (double& area : stop.areas) area = std::max(area, 0.);
  // In a sliver all three can round to zero or below.
  if (!(stop.areas[0] + stop.areas[1] + stop.areas[2] > 0)) stop.areas = {1, 1, 1};
  return stop;
}

MetricFactor BackgroundMesh::factor_at(Point p, Index& hint) const {
  constexpr double kOneHeight = 1;
  const Stop stop = stop_near(p, hint, kOneHeight);
  hint = stop.triangle;
  if (interpolation_ != Interpolation::linear_size || !quads_.empty())
    return factor_of(interpolate_at(stop, p));
  const auto& v = triangles_[hint].vertices;
  // H is linear in the weights, so the size factor costs nothing here.
  const double s = size_factor_ / (stop.areas[0] + stop.areas[1] + stop.areas[2]);
  const double w0 = stop.areas[0] * s, w1 = stop.areas[1] * s, w2 = stop.areas[2] * s;
  const Vertex &a = vertices_[v[0]], &b = vertices_[v[1]], &c = vertices_[v[2]];
  return factor_of(SizeTensor{w0 * a.t11 + w1 * b.t11 + w2 * c.t11,
                              w0 * a.t12 + w1 * b.t12 + w2 * c.t12,
                              w0 * a.t22 + w1 * b.t22 + w2 * c.t22});
}

Metric BackgroundMesh::metric_at(Point p, Index& hint) const {
  const Stop stop = stop_near(p, hint, 0);
  hint = stop.triangle;
  return interpolate_at(stop, p);
}

namespace {

Metric metric_from_tensor(Interpolation interpolation, double t11, double t12, double t22) {
  if (interpolation == Interpolation::linear_size) return metric_of(SizeTensor{t11, t12, t22});
  if (interpolation == Interpolation::log_euclidean) return exponential({t11, t12, t22});
  return {t11, t12, t22};
}

}  // namespace

Metric BackgroundMesh::interpolate_at(const Stop& stop, Point p) const {
  return scaled(field_at(stop, p), 1 / (size_factor_ * size_factor_));
}

Metric BackgroundMesh::field_at(const Stop& stop, Point p) const {
  const Index element = element_of(stop.triangle);
  if (element >= plain_triangles_) return interpolate_in_quad(element - plain_triangles_, p);
  const auto& v = triangles_[stop.triangle].vertices;
  std::array<double, 3> areas = stop.areas;
  const double sum = areas[0] + areas[1] + areas[2];
  for (double& w : areas) w /= sum;
  if (interpolation_ == Interpolation::simultaneous_reduction) {
    std::array<Metric, 3> m;
    for (int k = 0; k < 3; ++k)
      m[k] = {vertices_[v[k]].t11, vertices_[v[k]].t12, vertices_[v[k]].t22};
    return interpolate(interpolation_, m, areas);
  }
  double t11 = 0, t12 = 0, t22 = 0;
  for (int k = 0; k < 3; ++k) {
    t11 += areas[k] * vertices_[v[k]].t11;
    t12 += areas[k] * vertices_[v[k]].t12;
    t22 += areas[k] * vertices_[v[k]].t22;
  }
  return metric_from_tensor(interpolation_, t11, t12, t22);
}

Metric BackgroundMesh::interpolate_in_quad(Index quad, Point p) const {
  std::array<Metric, 4> m;
  std::array<Point, 4> corners;
  for (int k = 0; k < 4; ++k) {
    const Vertex& v = vertices_[quads_[quad][k]];
    corners[k] = v.p;
    m[k] = metric_from_tensor(interpolation_, v.t11, v.t12, v.t22);
  }
  const auto [xi, eta] = bilinear_coordinates(corners, p);
  return interpolate(interpolation_, m, xi, eta);
}

MetricFunction background_metric(const Mesh& mesh, const MetricField& field,
                                 Interpolation interpolation) {
  auto background = std::make_shared<const BackgroundMesh>(mesh, field, interpolation);
  return [background, hint = Index{0}](Point p) mutable { return background->metric_at(p, hint); };
}

}  // namespace anisofront
