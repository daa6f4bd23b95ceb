#include "mesher/geometry/curve_locator.hpp"

#include <limits>
#include <utility>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Children of a node over leaves [begin, end): the left one follows it, the right one comes after
/// the 2 m - 1 nodes of the left one's m leaves.
struct Children {
  std::size_t middle, left, right;
};

Children children_of(std::size_t node, std::size_t begin, std::size_t end) {
  const std::size_t middle = begin + (end - begin) / 2;
  return {middle, node + 1, node + 2 * (middle - begin)};
}

}  // namespace

CurveLocator::CurveLocator(std::vector<NurbsCurve> curves) : curves_(std::move(curves)) {
  if (curves_.empty())
    throw InputError("distance to curves: found no curve; expected at least one");
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    validate(curves_[c]);
    for (const detail::CurvePiece& piece : detail::split_into_pieces(curves_[c]))
      leaves_.push_back({static_cast<Index>(c), piece});
  }
  boxes_.resize(2 * leaves_.size() - 1);
  build(0, 0, leaves_.size());
}

void CurveLocator::build(std::size_t node, std::size_t begin, std::size_t end) {
  if (end - begin == 1) {
    boxes_[node] = leaves_[begin].piece.box;
    return;
  }
  const Children children = children_of(node, begin, end);
  build(children.left, begin, children.middle);
  build(children.right, children.middle, end);
  boxes_[node].add(boxes_[children.left]);
  boxes_[node].add(boxes_[children.right]);
}

void CurveLocator::visit_leaf(std::size_t leaf, Point p, Best& best) const {
  const Leaf& candidate = leaves_[leaf];
  if (detail::distance_bound(candidate.piece, p) > best.nearest.distance) return;
  const NurbsCurve& curve = curves_[static_cast<std::size_t>(candidate.curve)];
  const NearestPoint nearest = detail::nearest_on_piece(curve, candidate.piece, p);
  if (nearest.distance < best.nearest.distance ||
      (nearest.distance == best.nearest.distance && leaf < best.leaf))
    best = {nearest, leaf};
}

void CurveLocator::visit(std::size_t node, std::size_t begin, std::size_t end, Point p,
                         Best& best) const {
  if (end - begin == 1) return visit_leaf(begin, p, best);
  const Children children = children_of(node, begin, end);
  const double left = boxes_[children.left].distance(p);
  const double right = boxes_[children.right].distance(p);
  const bool left_first = left <= right;
  if (left_first && left <= best.nearest.distance)
    visit(children.left, begin, children.middle, p, best);
  if (right <= best.nearest.distance) visit(children.right, children.middle, end, p, best);
  if (!left_first && left <= best.nearest.distance)
    visit(children.left, begin, children.middle, p, best);
}

CurveProjection CurveLocator::nearest(Point p) const {
  Best best{{0, {}, std::numeric_limits<double>::infinity()}, 0};
  visit(0, 0, leaves_.size(), p, best);
  const Leaf& leaf = leaves_[best.leaf];
  const NurbsCurve& curve = curves_[static_cast<std::size_t>(leaf.curve)];
  const double t = best.nearest.parameter;
  const CurveDerivatives d = detail::span_derivatives(curve, leaf.piece.span, t);
  const double speed = norm(d.first);
  CurveProjection result{leaf.curve, t, best.nearest.point, best.nearest.distance, {}, 0};
  result.tangent = speed > 0 ? (1 / speed) * d.first : unit_tangent(curve, t);
  if (speed > 0) result.curvature = cross(d.first, d.second) / (speed * speed * speed);
  return result;
}

}  // namespace anisofront
