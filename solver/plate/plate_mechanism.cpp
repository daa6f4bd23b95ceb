#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <Eigen/Dense>

#include "mesher/geometry/curve_piece.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/plate/plate_supports.hpp"
#include "solver/plate/plate_text.hpp"

namespace anisofront {
namespace {

/// Rigid motions count as held above this share of the largest singular value.
constexpr double kRankTolerance = 1e-6;

/// Element -> representative of its part. Elements belong together where they share w: at vertices
/// or, for Crouzeix-Raviart elements, along edges.
class Parts {
 public:
  Parts(const FeMesh& mesh, PlateElement element) {
    parent_.resize(mesh.element_count());
    std::iota(parent_.begin(), parent_.end(), Index{0});
    const bool by_vertex = vertex_components(element).w >= 0;
    std::vector<Index> first(by_vertex ? mesh.mesh.points.size() : mesh.edge_points.size(),
                             kNoIndex);
    for (Index e = 0; e < mesh.element_count(); ++e) {
      const Element at = element_at(mesh, e);
      for (int k = 0; k < at.corners; ++k) {
        Index& owner = first[by_vertex ? at.vertices[k] : at.edges[k]];
        if (owner == kNoIndex) owner = e;
        join(owner, e);
      }
    }
  }

  /// The element of smallest number in the part of e.
  Index of(Index e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }

 private:
  void join(Index a, Index b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<Index> parent_;
};

/// Rigid motions in coordinates relative to a part, with rotations times its size: w = c0 + c1 X +
/// c2 Y with X = (x - centre) / size. A row is what they do to one held unknown.
using Motion = Eigen::Vector3d;

struct Part {
  Index first_element = kNoIndex;
  detail::Box box;
  bool holds_w = false;
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();

  Point centre() const { return lerp(box.low, box.high, 0.5); }
  double size() const { return 0.5 * box.diagonal(); }
  Motion deflection_at(Point p) const {
    const Vector r = (1 / size()) * (p - centre());
    return {1, r.x, r.y};
  }
  void add(const Motion& row) { gram += row * row.transpose(); }
};

/// The vector whose component along it a constrained rotation is; zero for free unknowns. Filled
/// per unknown.
std::vector<Vector> held_directions(const DofMap& dofs, const PlateConditions& conditions,
                                    const std::vector<char>& is_second) {
  std::vector<Vector> axis(dofs.count());
  for (Index i = 0; i < dofs.count(); ++i) axis[i] = is_second[i] ? Vector{0, 1} : Vector{1, 0};
  for (const Frame& frame : conditions.frames) {
    axis[frame.first] = frame.axis;
    axis[frame.first + 1] = {-frame.axis.y, frame.axis.x};
  }
  std::vector<Vector> held(dofs.count());
  for (const Constraint& c : conditions.constraints) held[c.unknown] = axis[c.unknown];
  return held;
}

/// Marks theta_y.
std::vector<char> second_rotations(const FeMesh& mesh, const DofMap& dofs, PlateElement element) {
  std::vector<char> is_second(dofs.count(), 0);
  if (const int r = vertex_components(element).rotation; r >= 0)
    for (Index v = 0; v < dofs.vertices; ++v) is_second[dofs.at_vertex(v, r + 1)] = 1;
  if (const int r = edge_components(element).rotation; r >= 0)
    for (Index e = 0; e < static_cast<Index>(mesh.edge_points.size()); ++e)
      is_second[dofs.at_edge(e, r + 1)] = 1;
  return is_second;
}

/// Adds what is held at one node.
void add_node(const std::vector<Vector>& held, Index first, PlateComponents components, Point at,
              Part& part) {
  const auto is_held = [&](Index unknown) { return !(held[unknown] == Vector{}); };
  if (components.w >= 0 && is_held(first + components.w)) {
    part.holds_w = true;
    part.add(part.deflection_at(at));
  }
  if (components.rotation < 0) return;
  for (const Index k : {0, 1}) {
    const Index unknown = first + components.rotation + k;
    if (is_held(unknown)) part.add({0, held[unknown].x, held[unknown].y});
  }
}

std::vector<Part> parts_of(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                           const std::vector<Vector>& held) {
  Parts parts(mesh, element);
  std::vector<Part> result;
  std::vector<std::size_t> number(mesh.element_count());
  for (Index e = 0; e < mesh.element_count(); ++e) {
    if (parts.of(e) == e) {
      number[e] = result.size();
      result.push_back({e, {}, false, Eigen::Matrix3d::Zero()});
    }
    number[e] = number[parts.of(e)];
    const Element at = element_at(mesh, e);
    for (int k = 0; k < at.corners; ++k) result[number[e]].box.add(at.nodes[k]);
  }
  const PlateComponents vertex = vertex_components(element), edge = edge_components(element);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element at = element_at(mesh, e);
    Part& part = result[number[e]];
    for (int k = 0; k < at.corners; ++k) {
      add_node(held, dofs.at_vertex(at.vertices[k]), vertex, at.nodes[k], part);
      add_node(held, dofs.at_edge(at.edges[k]), edge, at.nodes[at.corners + k], part);
    }
  }
  return result;
}

/// To about six digits of numbers of this size, so that round-off does not show.
Vector rounded(Vector v, double size) {
  const double unit = std::pow(10, std::floor(std::log10(size)) - 6);
  // "+ 0." makes -0 into 0.
  const auto round = [unit](double x) { return std::round(x / unit) * unit + 0.; };
  return {round(v.x), round(v.y)};
}

/// Where w = 0.
std::string turn(const Part& part, const Motion& motion) {
  const Vector gradient{motion[1], motion[2]};
  const Point foot =
      part.centre() - (motion[0] / squared_norm(gradient)) * (part.size() * gradient);
  Vector along = rounded((1 / norm(gradient)) * Vector{-gradient.y, gradient.x}, 1);
  if (along.x < 0 || (along.x == 0 && along.y < 0)) along = {0. - along.x, 0. - along.y};
  return "can turn about the line through " + describe(rounded(foot, part.size())) +
         " in direction " + describe(along);
}

/// The motion that is free in words, or nothing.
std::string free_motion(const Part& part) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(part.gram);
  const Eigen::Vector3d squares = eigen.eigenvalues();
  const double least = kRankTolerance * kRankTolerance * squares[2];
  if (squares[0] > least) return {};
  if (!part.holds_w) return "can move as a rigid body: no curve supports w";
  if (squares[1] > least) return turn(part, eigen.eigenvectors().col(0));
  // One row is left: w at one point.
  const Motion row = eigen.eigenvectors().col(2) / eigen.eigenvectors()(0, 2);
  return "can turn about the point " +
         describe(rounded(part.centre() + part.size() * Vector{row[1], row[2]}, part.size())) +
         " in every direction: w is supported nowhere else";
}

}  // namespace

void require_supported(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                       const PlateConditions& conditions) {
  const std::vector<Vector> held =
      held_directions(dofs, conditions, second_rotations(mesh, dofs, element));
  for (const Part& part : parts_of(mesh, dofs, element, held)) {
    const std::string motion = free_motion(part);
    if (motion.empty()) continue;
    const Index region = element_at(mesh, part.first_element).region;
    throw InputError("the plate in region " + describe_tag(mesh.mesh, 2, region) + " round " +
                     describe(part.centre()) + " " + motion +
                     "; expected supports that hold all rigid motions: add one (three pins hold a "
                     "plate whose loads balance)");
  }
}

}  // namespace anisofront
