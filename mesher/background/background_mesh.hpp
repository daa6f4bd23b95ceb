#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "mesher/background/alternating_digital_tree.hpp"
#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// The mesh that carries the metric while the next mesh is made.
///
/// Quadrilaterals are walked through as two triangles and interpolated as quadrilaterals. Look-ups
/// take a hint, the triangle of a near point, and walk from it (1-3 steps in the mesher); where no
/// walk can lead, the alternating digital tree answers; it is built when first needed.
/// All const functions may be called from several threads.
class BackgroundMesh {
 public:
  /// Preconditions: one metric per vertex; `mesh` is valid (see check_mesh).
  /// Throws InputError naming vertex and place of metrics that are not finite or not positive
  /// definite.
  BackgroundMesh(const Mesh& mesh, const MetricField& field,
                 Interpolation interpolation = Interpolation::linear_size);

  /// Walking triangle that contains p (closed, exact predicate), or kNoIndex when p is outside.
  /// Points shared by several triangles may get any of them.
  Index locate(Point p, Index hint = 0) const;

  /// Element of the mesh (triangles first, then quads) of a walking triangle.
  Index element_of(Index triangle) const;

  /// The walking triangle nearest to p and the nearest point of it; p itself when it is inside.
  struct Nearest {
    Index triangle = kNoIndex;
    Point point;
  };
  Nearest nearest(Point p, Index hint = 0) const;

  /// Metric at p for the hot paths, as a Cholesky factor; `hint` is read and updated. A point
  /// outside by less than about one element takes the metric of the edge it left through.
  MetricFactor factor_at(Point p, Index& hint) const;

  /// Metric at p; outside: at the nearest point of the mesh.
  Metric metric_at(Point p, Index& hint) const;

  /// From now on all sizes returned are `factor` times those of the field: metrics (and complexity)
  /// are divided by factor^2. Relative to the field, not to earlier calls; 1 gives the field back
  /// bit for bit, and powers of two are exact. Must not be called while other threads read.
  /// Throws InputError unless factor is finite and greater than zero.
  void set_size_factor(double factor);
  double size_factor() const { return size_factor_; }

  Index triangle_count() const { return static_cast<Index>(triangles_.size()); }
  const Box& bounds() const { return bounds_; }

  /// Integral of sqrt(det M) (metric area of the domain).
  double complexity() const { return complexity_ / (size_factor_ * size_factor_); }

 private:
  /// Position and the tensor that is interpolated: M^(-1/2), log M or M itself.
  struct Vertex {
    Point p;
    double t11, t12, t22;
  };
  /// neighbours[k] lies across the edge opposite vertices[k].
  struct Walker {
    std::array<Index, 3> vertices;
    std::array<Index, 3> neighbours;
  };
  /// An edge without neighbour, of the triangle on its left.
  struct BoundaryEdge {
    Index triangle;
    Point a, b;
  };
  /// Result of a walk: where it ended and the (unnormalised, possibly negative) barycentrics there.
  struct Stop {
    Index triangle;
    std::array<double, 3> areas;
    bool inside;
  };

  void add_walkers(const Mesh& mesh);
  void renumber_if_scattered();
  void build_tree() const;
  Stop walk(Point p, Index hint) const;
  Stop stop_at(Index triangle, Point p) const;
  /// Where the metric of p is taken, areas >= 0. A point that lies further outside than `slack`
  /// heights of the last triangle is moved to the nearest point of the mesh.
  Stop stop_near(Point& p, Index hint, double slack) const;
  bool contains(Index triangle, Point p) const;
  Index locate_by_tree(Point p) const;
  void build_boundary_tree() const;
  Nearest nearest_on_boundary(Point p) const;
  Box box_of(Index triangle) const;
  Metric interpolate_at(const Stop& stop, Point p) const;
  /// The same without the size factor.
  Metric field_at(const Stop& stop, Point p) const;
  Metric interpolate_in_quad(Index quad, Point p) const;

  Interpolation interpolation_;
  std::vector<Vertex> vertices_;
  std::vector<Walker> triangles_;
  Index plain_triangles_ = 0;      ///< walkers that are triangles of the mesh
  std::vector<Index> element_of_;  ///< empty: walker i is element i
  std::vector<std::array<Index, 4>> quads_;
  Box bounds_;
  double complexity_ = 0;  ///< of the field itself
  double size_factor_ = 1;
  mutable std::once_flag tree_once_;
  mutable std::unique_ptr<AlternatingDigitalTree> tree_;  ///< of the triangles
  mutable std::once_flag boundary_once_;
  mutable std::vector<BoundaryEdge> boundary_edges_;
  mutable std::unique_ptr<AlternatingDigitalTree> boundary_tree_;
};

/// The interpolated metric as a function of the point (copies nothing of the mesh but the
/// background structure; holds a hint, so one copy per thread).
MetricFunction background_metric(const Mesh& mesh, const MetricField& field,
                                 Interpolation interpolation = Interpolation::linear_size);

}  // namespace anisofront
