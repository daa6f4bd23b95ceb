#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/curve.hpp"
#include "mesher/geometry/curve_piece.hpp"

namespace anisofront {

/// The place nearest to a point on one of several curves.
struct CurveProjection {
  Index curve = kNoIndex;  ///< index into the curves of the locator
  double parameter = 0;
  Point point;
  double distance = 0;
  Vector tangent;        ///< unit tangent towards larger parameters
  double curvature = 0;  ///< signed as in curvature(): positive when the curve turns left
};

/// Finds the nearest of several curves in O(log n) of their pieces. Keeps copies of the curves.
/// Where the nearest point joins two pieces (a corner, or an arc and its tangent), tangent and
/// curvature are those of either side; equal distances go to the first curve and parameter.
class CurveLocator {
 public:
  /// Throws InputError when there is no curve or one is not valid.
  explicit CurveLocator(std::vector<NurbsCurve> curves);

  /// Safe to call from several threads at once.
  CurveProjection nearest(Point p) const;

  std::span<const NurbsCurve> curves() const { return curves_; }

 private:
  struct Leaf {
    Index curve;
    detail::CurvePiece piece;
  };
  struct Best {
    NearestPoint nearest;
    std::size_t leaf;
  };

  void build(std::size_t node, std::size_t begin, std::size_t end);
  void visit(std::size_t node, std::size_t begin, std::size_t end, Point p, Best& best) const;
  void visit_leaf(std::size_t leaf, Point p, Best& best) const;

  std::vector<NurbsCurve> curves_;
  std::vector<Leaf> leaves_;        ///< pieces in curve order, hence neighbours in the plane too
  std::vector<detail::Box> boxes_;  ///< binary tree over the leaves in preorder
};

}  // namespace anisofront
