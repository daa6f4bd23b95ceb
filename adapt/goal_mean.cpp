#include "adapt/goal_mean.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Dense>

#include "mesher/background/alternating_digital_tree.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/plate/plate_text.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// Parts are divided until their longest side is at most this share of the radius.
constexpr double kFineness = 0.125;
/// The weight (degree 4) times functions of second order, exactly within the disc.
constexpr int kPartDegree = 6;
/// Ends the halving where a disc is too small for the digits of the coordinates.
constexpr int kMaxHalvings = 80;
/// Rules of the solvers for sources that are functions: with them the moments are kept exactly.
constexpr int kTriangleDegree = 6;
constexpr int kQuadDegree = 7;
/// Bent elements may leave the box of their nodes by about this share of its size.
constexpr double kBulge = 0.25;

struct Disc {
  Point centre;
  double radius = 0;

  double weight(Point p) const {
    const double s = 1 - squared_norm(p - centre) / (radius * radius);
    return s > 0 ? s * s : 0;
  }
  bool holds(Point p) const { return norm(p - centre) <= radius; }
};

/// A triangle of the reference element.
using Part = std::array<ReferencePoint, 3>;

ReferencePoint middle(ReferencePoint a, ReferencePoint b) {
  return {0.5 * (a.xi + b.xi), 0.5 * (a.eta + b.eta)};
}

/// Moments of the weight of a disc over one element, by parts.
class PatchMoments {
 public:
  PatchMoments(const Disc& disc, const Element& element) : disc_(disc), element_(element) {
    if (element.shape == Shape::triangle) {
      add({{{0, 0}, {1, 0}, {0, 1}}}, 0);
    } else {
      add({{{-1, -1}, {1, -1}, {1, 1}}}, 0);
      add({{{-1, -1}, {1, 1}, {-1, 1}}}, 0);
    }
  }

  const std::array<double, 9>& moments() const { return moments_; }
  bool is_divided() const { return is_divided_; }

 private:
  void add(const Part& part, int halvings) {
    std::array<Point, 3> x;
    for (int k = 0; k < 3; ++k) x[k] = map_at(element_, part[k]).x;
    int longest = 0;
    const auto length = [&](int k) { return norm(x[(k + 1) % 3] - x[k]); };
    for (const int k : {1, 2})
      if (length(k) > length(longest)) longest = k;
    // Twice the side, for bent parts.
    if (norm(x[0] - disc_.centre) > disc_.radius + 2 * length(longest)) return;
    if (length(longest) <= kFineness * disc_.radius || halvings == kMaxHalvings)
      return integrate(part);
    is_divided_ = true;
    const ReferencePoint a = part[longest], b = part[(longest + 1) % 3],
                         c = part[(longest + 2) % 3], m = middle(a, b);
    add({a, m, c}, halvings + 1);
    add({m, b, c}, halvings + 1);
  }

  void integrate(const Part& part) {
    const auto& [a, b, c] = part;
    const double determinant = (b.xi - a.xi) * (c.eta - a.eta) - (b.eta - a.eta) * (c.xi - a.xi);
    for (const auto& [at, weight] : reference_quadrature(Shape::triangle, kPartDegree)) {
      const ReferencePoint p{a.xi + at.xi * (b.xi - a.xi) + at.eta * (c.xi - a.xi),
                             a.eta + at.xi * (b.eta - a.eta) + at.eta * (c.eta - a.eta)};
      const MapPoint map = map_at(element_, p);
      const double f = weight * determinant * map.determinant() * disc_.weight(map.x);
      if (f == 0) continue;
      const ScalarBasis basis = scalar_basis(element_.shape, 2, p);
      for (int j = 0; j < basis.count; ++j) moments_[j] += f * basis.value[j];
    }
  }

  const Disc& disc_;
  const Element& element_;
  std::array<double, 9> moments_{};
  bool is_divided_ = false;
};

std::span<const ScalarBasisPoint> source_rule(Shape shape) {
  return scalar_rule(shape, 2, shape == Shape::triangle ? kTriangleDegree : kQuadDegree);
}

Disc disc_of(const Goal& goal) {
  if (!(goal.radius > 0) || !std::isfinite(goal.radius))
    throw InputError("the radius of the goal's patch round " + describe(goal.at) + " is " +
                     describe(goal.radius) + ", expected a positive length");
  return {goal.at, goal.radius};
}

/// Adds the moments of an element, if there are any.
void add_moments(Index element, const std::array<double, 9>& moments, GoalMean& mean) {
  double whole = 0;
  for (const double m : moments) whole += m;
  if (whole == 0) return;
  mean.elements.push_back({element, moments});
  mean.whole += whole;
}

GoalMean patch_mean(const FeMesh& mesh, const Goal& goal) {
  const Disc disc = disc_of(goal);
  GoalMean mean;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    add_moments(e, PatchMoments(disc, element).moments(), mean);
  }
  if (!(mean.whole > 0))
    throw InputError("the goal's patch of radius " + describe(goal.radius) + " round " +
                     describe(goal.at) +
                     " meets no element of the mesh, expected a place in the domain");
  return mean;
}

GoalMean region_mean(const FeMesh& mesh, const Goal& goal) {
  GoalMean mean;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    if (element.region != goal.tag) continue;
    std::array<double, 9> moments{};
    for (const auto& [at, weight, basis] : source_rule(element.shape)) {
      const double measure = weight * map_at(element, at).determinant();
      for (int j = 0; j < basis.count; ++j) moments[j] += measure * basis.value[j];
    }
    add_moments(e, moments, mean);
  }
  if (!(mean.whole > 0))
    throw InputError("goal: no element of the mesh carries " +
                     describe_tag(mesh.mesh, 2, goal.tag) +
                     ", expected a region to take the mean over; check its name");
  return mean;
}

Box box_of(const Element& element) {
  Box box{element.nodes[0], element.nodes[0]};
  for (std::size_t j = 1; j < second_order_nodes(element.shape).size(); ++j)
    box = enclosing(box, element.nodes[j]);
  const double bulge = element.bent ? kBulge * norm(box.high - box.low) : 0;
  return {box.low - Vector{bulge, bulge}, box.high + Vector{bulge, bulge}};
}

/// A polynomial of second order on one element.
struct Piece {
  Element element;
  Box box;
  std::array<double, 9> values{};

  std::optional<double> at(Point p) const {
    if (!overlap(box, {p, p})) return {};
    const auto reference = inverse_map(element, p);
    if (!reference) return {};
    // Points of rules lie well inside their element.
    const ReferencePoint inside = clamped(element.shape, *reference);
    if (inside.xi != reference->xi || inside.eta != reference->eta) return {};
    const ScalarBasis basis = scalar_basis(element.shape, 2, inside);
    double value = 0;
    for (int j = 0; j < basis.count; ++j) value += values[j] * basis.value[j];
    return value;
  }
};

/// The polynomial whose moments by the rule of the solvers are those of the weight.
Piece piece_of(const Element& element, const std::array<double, 9>& moments) {
  const auto count = static_cast<Eigen::Index>(second_order_nodes(element.shape).size());
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(count, count);
  for (const auto& [at, weight, basis] : source_rule(element.shape)) {
    const Eigen::Map<const Eigen::VectorXd> n(basis.value.data(), count);
    mass += weight * map_at(element, at).determinant() * n * n.transpose();
  }
  Piece piece{element, box_of(element), {}};
  Eigen::Map<Eigen::VectorXd>(piece.values.data(), count) =
      mass.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(moments.data(), count));
  return piece;
}

bool is_inside(const Disc& disc, const Element& element) {
  const auto end = element.nodes.begin() + second_order_nodes(element.shape).size();
  return std::all_of(element.nodes.begin(), end, [&](Point p) { return disc.holds(p); });
}

/// What mean_source() is for a patch.
struct PatchSource {
  Disc disc;
  double whole = 1;
  std::vector<Piece> pieces;
  Box reach;  ///< of the disc and all pieces: most points of a mesh lie outside

  double operator()(Point p) const {
    if (!overlap(reach, {p, p})) return 0;
    for (const Piece& piece : pieces)
      if (const auto value = piece.at(p)) return *value / whole;
    return disc.weight(p) / whole;
  }
};

PatchSource patch_source(const FeMesh& mesh, const Goal& goal) {
  const GoalMean mean = patch_mean(mesh, goal);
  const Disc disc = disc_of(goal);
  const Vector corner{disc.radius, disc.radius};
  PatchSource source{disc, mean.whole, {}, {disc.centre - corner, disc.centre + corner}};
  for (const WeightMoments& own : mean.elements) {
    const Element element = element_at(mesh, own.element);
    if (is_inside(disc, element) || !PatchMoments(disc, element).is_divided()) continue;
    source.pieces.push_back(piece_of(element, own.moments));
    const Box& box = source.pieces.back().box;
    source.reach = enclosing(enclosing(source.reach, box.low), box.high);
  }
  return source;
}

}  // namespace

GoalMean goal_mean(const FeMesh& mesh, const Goal& goal) {
  return goal.kind == Goal::Kind::region_mean ? region_mean(mesh, goal) : patch_mean(mesh, goal);
}

RegionCoefficient mean_source(const FeMesh& mesh, const Goal& goal) {
  if (goal.kind == Goal::Kind::patch_mean) return patch_source(mesh, goal);
  RegionCoefficient source = 0.;
  source.set(goal.tag, 1 / region_mean(mesh, goal).whole);
  return source;
}

std::span<const ReferencePoint> second_order_nodes(Shape shape) {
  static constexpr std::array<ReferencePoint, 6> kTriangle{
      {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
  static constexpr std::array<ReferencePoint, 9> kSquare{
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};
  if (shape == Shape::triangle) return kTriangle;
  return kSquare;
}

}  // namespace anisofront
