#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/curve.hpp"

namespace anisofront {

/// A named curve of the domain. `tag` is the physical tag its edges carry in mesh files (> 0);
/// several curves may share it.
struct DomainCurve {
  std::string name;
  Index tag = 0;
  NurbsCurve curve;
};

/// A point that must be a mesh vertex.
struct DomainPoint {
  std::string name;
  Index tag = 0;
  Point point;
};

/// One curve as a part of a loop; reversed when the loop runs against its parameter.
struct CurveUse {
  Index curve = kNoIndex;
  bool reversed = false;
  friend bool operator==(const CurveUse&, const CurveUse&) = default;
};
using Loop = std::vector<CurveUse>;

/// A connected set to be meshed. The region lies to the left of each of its loops: loops[0] is the
/// outer one (anticlockwise), the others are holes (clockwise). A curve used by two regions is
/// an interface and is meshed once.
struct DomainRegion {
  std::string name;
  Index tag = 0;
  std::vector<Loop> loops;
  std::vector<Index> embedded_curves;
};

/// What is to be meshed: curves, the regions they bound, curves and points inside them.
struct Domain {
  std::vector<DomainCurve> curves;
  std::vector<DomainRegion> regions;
  std::vector<DomainPoint> points;
};

/// Start and end point of a curve use in loop direction.
Point start_point(const Domain& domain, CurveUse use);
Point end_point(const Domain& domain, CurveUse use);

/// Ends of curves count as one point within this share of the diagonal of the domain's control
/// points; the first of the two is the exact one.
inline constexpr double kJoinTolerance = 1e-12;

/// Diagonal of the box round the control points of all curves.
double bounding_diagonal(const Domain& domain);

/// Orders and turns the given curves so that they close into one or more loops; each loop starts
/// with the first of its curves in the list, in that curve's own direction. A closed curve is a
/// loop alone. Ends meet exactly or within kJoinTolerance.
/// Throws InputError naming the curve and the end point that nothing continues, or the curves
/// where more than two ends meet.
std::vector<Loop> chain_loops(const Domain& domain, const std::vector<Index>& curves);

/// Signed area enclosed by a loop (exact on polygons, to about 1e-10 relative on curves).
double signed_area(const Domain& domain, const Loop& loop);

/// Adds a region bounded by `boundary` and `holes` (curve indices in any order and direction):
/// chains, orients, puts the outer loop first. When `boundary` closes into several loops the one
/// of the largest area is the outer one. Throws InputError with the names of the curves.
void add_region(Domain& domain, std::string name, Index tag, const std::vector<Index>& boundary,
                const std::vector<std::vector<Index>>& holes);

/// Throws InputError for: no region, open loops, zero-length curves, loops of zero area or wrong
/// direction, unknown indices, non-finite coordinates, duplicate names (tags may be shared),
/// two points at one place, a hole outside its region. (Curves that cross are found when the
/// boundary is discretised.)
void validate(const Domain& domain);

/// Index of the curve of that name or kNoIndex.
Index find_curve(const Domain& domain, const std::string& name);

}  // namespace anisofront
