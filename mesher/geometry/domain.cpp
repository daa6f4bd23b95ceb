#include "mesher/geometry/domain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/geometry/curve_piece.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/quadrature.hpp"

namespace anisofront {
namespace {

const DomainCurve& curve_at(const Domain& domain, Index index) {
  if (index < 0 || static_cast<std::size_t>(index) >= domain.curves.size())
    throw InputError("domain: found curve index " + std::to_string(index) + "; expected 0.." +
                     std::to_string(domain.curves.size()) + " (exclusive)");
  return domain.curves[static_cast<std::size_t>(index)];
}

std::string quoted_names(const Domain& domain, const std::vector<Index>& curves) {
  std::string text;
  for (const Index c : curves)
    text += (text.empty() ? "'" : ", '") + curve_at(domain, c).name + "'";
  return text;
}

/// The ends of the listed curves merged into joints: ends 2k and 2k + 1 are those of curves[k].
struct Joints {
  std::vector<Index> joint;              ///< per end
  std::vector<std::vector<Index>> ends;  ///< per joint, ascending
};

/// Sorts the ends by x: those that meet stand within the tolerance of the sweep.
Joints find_joints(const std::vector<Point>& points, double tolerance) {
  std::vector<Index> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  const auto at = [&](Index i) { return points[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(at(a).x, a) < std::pair(at(b).x, b); });
  Joints joints{std::vector<Index>(points.size(), kNoIndex), {}};
  for (std::size_t i = 0; i < order.size(); ++i) {
    Index& first = joints.joint[static_cast<std::size_t>(order[i])];
    if (first != kNoIndex) continue;
    first = static_cast<Index>(joints.ends.size());
    std::vector<Index> ends;
    for (std::size_t j = i; j < order.size() && at(order[j]).x - at(order[i]).x <= tolerance; ++j)
      if (norm(at(order[j]) - at(order[i])) <= tolerance) {
        joints.joint[static_cast<std::size_t>(order[j])] = first;
        ends.push_back(order[j]);
      }
    std::sort(ends.begin(), ends.end());
    joints.ends.push_back(std::move(ends));
  }
  return joints;
}

[[noreturn]] void reject_joint(const Domain& domain, const std::vector<Index>& curves,
                               const std::vector<Index>& ends, Point place) {
  std::vector<Index> meeting;
  for (const Index end : ends) meeting.push_back(curves[static_cast<std::size_t>(end / 2)]);
  if (ends.size() == 1)
    throw InputError("open loop: curve " + quoted_names(domain, meeting) + " ends at " +
                     describe(place) + " and no other curve of the loop starts or ends there;" +
                     " expected a closed loop: add the missing curve or move the end point");
  throw InputError("loop: " + std::to_string(ends.size()) + " curve ends (" +
                   quoted_names(domain, meeting) + ") meet at " + describe(place) +
                   "; expected two: give holes and neighbouring regions separately");
}

/// 1/2 integral of (C - origin) x dC over one curve (Green's theorem).
double swept_area(const NurbsCurve& curve, Point origin) {
  double sum = 0;
  if (curve.degree == 1) {  // straight segments whatever the weights
    for (std::size_t i = 1; i < curve.points.size(); ++i)
      sum += cross(curve.points[i - 1] - origin, curve.points[i] - origin);
    return 0.5 * sum;
  }
  const auto degree = static_cast<std::size_t>(curve.degree);
  NurbsCurve moved = curve;  // far from the origin of coordinates rounding would hide the area
  double scale = 0;
  for (Point& p : moved.points) {
    p = p - origin;
    scale = std::max(scale, squared_norm(p));
  }
  for (std::size_t span = degree; span + degree + 1 < curve.knots.size(); ++span) {
    const double t0 = curve.knots[span], t1 = curve.knots[span + 1];
    if (t0 == t1) continue;
    const auto rate = [&](double t) {
      const CurveDerivatives d = detail::span_derivatives(moved, span, t);
      return cross(d.point, d.first);
    };
    sum += detail::integrate(rate, t0, t1, 1e-13 * scale, detail::gauss_8(rate, t0, t1));
  }
  return 0.5 * sum;
}

void reverse_loop(Loop& loop) {
  std::reverse(loop.begin(), loop.end());
  for (CurveUse& use : loop) use.reversed = !use.reversed;
}

/// Turns the loop so that the sign of its area is that of `sign`.
void orient(const Domain& domain, Loop& loop, double sign) {
  if (signed_area(domain, loop) * sign < 0) reverse_loop(loop);
}

}  // namespace

Point start_point(const Domain& domain, CurveUse use) {
  const NurbsCurve& curve = curve_at(domain, use.curve).curve;
  return use.reversed ? curve.points.back() : curve.points.front();
}

Point end_point(const Domain& domain, CurveUse use) {
  return start_point(domain, {use.curve, !use.reversed});
}

double bounding_diagonal(const Domain& domain) {
  detail::Box box;
  for (const DomainCurve& curve : domain.curves)
    for (const Point p : curve.curve.points) box.add(p);
  return domain.curves.empty() ? 0 : box.diagonal();
}

std::vector<Loop> chain_loops(const Domain& domain, const std::vector<Index>& curves) {
  std::vector<Point> points;
  for (const Index c : curves) {
    points.push_back(start_point(domain, {c, false}));
    points.push_back(end_point(domain, {c, false}));
  }
  const Joints joints = find_joints(points, kJoinTolerance * bounding_diagonal(domain));
  for (const std::vector<Index>& ends : joints.ends)
    if (ends.size() != 2)
      reject_joint(domain, curves, ends, points[static_cast<std::size_t>(ends.front())]);

  std::vector<Loop> loops;
  std::vector<char> used(curves.size(), 0);
  for (std::size_t first = 0; first < curves.size(); ++first) {
    if (used[first]) continue;
    Loop loop;
    for (std::size_t end = 2 * first; !used[end / 2];) {  // the end at which a curve is entered
      used[end / 2] = 1;
      loop.push_back({curves[end / 2], end % 2 == 1});
      const auto left = static_cast<Index>(end ^ 1);
      const auto joint = static_cast<std::size_t>(joints.joint[static_cast<std::size_t>(left)]);
      const std::vector<Index>& meeting = joints.ends[joint];
      end = static_cast<std::size_t>(meeting[meeting[0] == left ? 1 : 0]);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

double signed_area(const Domain& domain, const Loop& loop) {
  double area = 0;
  for (const CurveUse use : loop) {
    const double swept =
        swept_area(curve_at(domain, use.curve).curve, start_point(domain, loop.front()));
    area += use.reversed ? -swept : swept;
  }
  return area;
}

void add_region(Domain& domain, std::string name, Index tag, const std::vector<Index>& boundary,
                const std::vector<std::vector<Index>>& holes) {
  if (boundary.empty())
    throw InputError("region '" + name + "': found no boundary curve; expected a closed loop");
  DomainRegion region{std::move(name), tag, chain_loops(domain, boundary), {}};
  const auto area = [&](const Loop& loop) { return std::fabs(signed_area(domain, loop)); };
  std::iter_swap(region.loops.begin(),
                 std::max_element(region.loops.begin(), region.loops.end(),
                                  [&](const Loop& a, const Loop& b) { return area(a) < area(b); }));
  for (const std::vector<Index>& hole : holes)
    for (Loop& loop : chain_loops(domain, hole)) region.loops.push_back(std::move(loop));
  for (std::size_t i = 0; i < region.loops.size(); ++i)
    orient(domain, region.loops[i], i == 0 ? 1 : -1);
  domain.regions.push_back(std::move(region));
}

Index find_curve(const Domain& domain, const std::string& name) {
  for (std::size_t i = 0; i < domain.curves.size(); ++i)
    if (domain.curves[i].name == name) return static_cast<Index>(i);
  return kNoIndex;
}

}  // namespace anisofront
