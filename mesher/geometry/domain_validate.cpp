// Is the domain one that can be meshed? Every message names the curves and the place.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "mesher/geometry/curve_piece.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

constexpr double kZeroArea = 1e-14;  // of the square of the bounding diagonal

/// Names must differ within curves, within regions and within points.
template <class Entity>
void validate_names(const std::vector<Entity>& entities, const std::string& kind) {
  std::set<std::string> names;
  for (const Entity& entity : entities)
    if (!names.insert(entity.name).second)
      throw InputError("domain: found two " + kind + "s named '" + entity.name +
                       "'; expected different names: rename one of them");
}

void validate_points(const std::vector<DomainPoint>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    order.push_back(i);
    if (!std::isfinite(points[i].point.x) || !std::isfinite(points[i].point.y))
      throw InputError("point '" + points[i].name + "': found " + describe(points[i].point) +
                       "; expected finite coordinates");
  }
  const auto key = [&](std::size_t i) {
    return std::tuple(points[i].point.x, points[i].point.y, i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const DomainPoint &a = points[order[k - 1]], &b = points[order[k]];
    if (a.point == b.point)
      throw InputError("points '" + a.name + "' and '" + b.name + "' both lie at " +
                       describe(a.point) + "; remove one of them");
  }
}

void validate_curve(const DomainCurve& curve, double diagonal) {
  try {
    validate(curve.curve);
  } catch (const InputError& error) {
    throw InputError("curve '" + curve.name + "': " + error.what());
  }
  detail::Box box;
  for (const Point p : curve.curve.points) box.add(p);
  if (box.diagonal() <= kJoinTolerance * diagonal)
    throw InputError("curve '" + curve.name + "' at " + describe(curve.curve.points.front()) +
                     " has zero length; expected two different points: remove the curve");
}

void validate_index(const Domain& domain, const DomainRegion& region, Index curve) {
  if (curve < 0 || static_cast<std::size_t>(curve) >= domain.curves.size())
    throw InputError("region '" + region.name + "': found curve index " + std::to_string(curve) +
                     "; expected a number from 0 to " + std::to_string(domain.curves.size() - 1));
}

const std::string& name_of(const Domain& domain, CurveUse use) {
  return domain.curves[static_cast<std::size_t>(use.curve)].name;
}

void validate_closed(const Domain& domain, const DomainRegion& region, const Loop& loop,
                     double tolerance) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const CurveUse use = loop[i], next = loop[(i + 1) % loop.size()];
    const Point end = end_point(domain, use), start = start_point(domain, next);
    if (norm(end - start) > tolerance)
      throw InputError("region '" + region.name + "': open loop: curve '" + name_of(domain, use) +
                       "' ends at " + describe(end) + " but the next curve '" +
                       name_of(domain, next) + "' starts at " + describe(start) +
                       "; expected the same point");
  }
}

void validate_direction(const Domain& domain, const DomainRegion& region, const Loop& loop,
                        double diagonal) {
  const bool outer = &loop == &region.loops.front();
  const double area = signed_area(domain, loop);
  const std::string where = "region '" + region.name + "': the loop through curve '" +
                            name_of(domain, loop.front()) + "' from " +
                            describe(start_point(domain, loop.front()));
  if (std::fabs(area) <= kZeroArea * diagonal * diagonal)
    throw InputError(where + " encloses no area; expected curves that surround the region");
  if ((area > 0) != outer)
    throw InputError(where + " runs " + (area > 0 ? "anticlockwise" : "clockwise") +
                     "; expected the outer loop anticlockwise and holes clockwise");
}

/// Even-odd rule; points on the polygon may fall on either side.
bool is_inside(const std::vector<Point>& polygon, Point p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a = polygon[i], b = polygon[j];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// Corners of the loop and points in between, enough to decide what lies inside it.
std::vector<Point> flattened(const Domain& domain, const Loop& loop) {
  std::vector<Point> polygon;
  for (const CurveUse use : loop) {
    std::vector<Point> points;
    for (const detail::CurvePiece& piece :
         detail::split_into_pieces(domain.curves[static_cast<std::size_t>(use.curve)].curve))
      points.push_back(use.reversed ? piece.p1 : piece.p0);
    if (use.reversed) std::reverse(points.begin(), points.end());
    polygon.insert(polygon.end(), points.begin(), points.end());
  }
  return polygon;
}

/// A hole may touch the outer loop: the majority of three of its points decides.
void validate_holes(const Domain& domain, const DomainRegion& region) {
  if (region.loops.size() == 1) return;
  const std::vector<Point> outer = flattened(domain, region.loops.front());
  for (std::size_t i = 1; i < region.loops.size(); ++i) {
    const Loop& hole = region.loops[i];
    const std::vector<Point> points = flattened(domain, hole);
    int inside = 0;
    for (std::size_t k = 0; k < 3; ++k)
      inside += is_inside(outer, points[k * points.size() / 3]) ? 1 : 0;
    if (inside < 2)
      throw InputError("region '" + region.name + "': the hole through curve '" +
                       name_of(domain, hole.front()) + "' from " + describe(points.front()) +
                       " lies outside the outer loop; expected it inside");
  }
}

void validate_region(const Domain& domain, const DomainRegion& region, double diagonal) {
  if (region.loops.empty())
    throw InputError("region '" + region.name + "': found no loop; expected an outer boundary");
  for (const Loop& loop : region.loops) {
    if (loop.empty()) throw InputError("region '" + region.name + "': found a loop without curves");
    for (const CurveUse use : loop) validate_index(domain, region, use.curve);
    validate_closed(domain, region, loop, kJoinTolerance * diagonal);
    validate_direction(domain, region, loop, diagonal);
  }
  for (const Index curve : region.embedded_curves) validate_index(domain, region, curve);
  validate_holes(domain, region);
}

}  // namespace

void validate(const Domain& domain) {
  if (domain.regions.empty())
    throw InputError("domain: found no region; expected at least one closed loop of curves");
  validate_names(domain.curves, "curve");
  validate_names(domain.regions, "region");
  validate_names(domain.points, "point");
  const double diagonal = bounding_diagonal(domain);
  for (const DomainCurve& curve : domain.curves) validate_curve(curve, diagonal);
  validate_points(domain.points);
  for (const DomainRegion& region : domain.regions) validate_region(domain, region, diagonal);
}

}  // namespace anisofront
