#include "drivers/problem/line_points.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/study/domain_names.hpp"
#include "mesher/geometry/curve.hpp"

namespace anisofront {
namespace {

/// Share of the length up to the share t of the points.
double graded(double t, double grading, LineEnd towards) {
  const auto from_start = [grading](double x) { return grading == 1 ? x : std::pow(x, grading); };
  if (towards == LineEnd::start) return from_start(t);
  if (towards == LineEnd::end) return 1 - from_start(1 - t);
  return t <= 0.5 ? from_start(2 * t) / 2 : 1 - from_start(2 - 2 * t) / 2;
}

LinePoints straight_line(const LineRequest& request) {
  LinePoints line;
  const double length = norm(request.to - request.from);
  for (const double t : point_shares(request)) {
    // The end as it stands in the study.
    line.points.push_back(t == 1 ? request.to : lerp(request.from, request.to, t));
    line.lengths.push_back(t * length);
    line.tangents.push_back((1 / length) * (request.to - request.from));
  }
  return line;
}

/// A curve with its arc length up to some of its parameters.
class MeasuredCurve {
 public:
  explicit MeasuredCurve(const NurbsCurve& curve) : curve_(curve) {
    constexpr int kPiecesPerSpan = 16;
    const std::vector<double> knots = distinct_knots(curve);
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
      for (int i = 0; i < kPiecesPerSpan; ++i)
        breaks_.push_back(std::lerp(knots[k], knots[k + 1], i / double{kPiecesPerSpan}));
    breaks_.push_back(knots.back());
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k)
      lengths_.push_back(lengths_.back() + arc_length(curve, breaks_[k], breaks_[k + 1]));
  }

  double length() const { return lengths_.back(); }

  double parameter_at(double s) const {
    constexpr int kNewtonSteps = 3;
    if (s <= 0) return breaks_.front();
    if (s >= length()) return breaks_.back();
    const auto k = static_cast<std::size_t>(
        std::upper_bound(lengths_.begin(), lengths_.end() - 1, s) - lengths_.begin() - 1);
    double t =
        std::lerp(breaks_[k], breaks_[k + 1], (s - lengths_[k]) / (lengths_[k + 1] - lengths_[k]));
    for (int step = 0; step < kNewtonSteps; ++step) {
      const double excess = lengths_[k] + arc_length(curve_, breaks_[k], t) - s;
      t = std::clamp(t - excess / norm(derivatives(curve_, t).first), breaks_[k], breaks_[k + 1]);
    }
    return t;
  }

 private:
  const NurbsCurve& curve_;
  std::vector<double> breaks_, lengths_{0};
};

LinePoints curve_line(const LineRequest& request, const Domain& domain) {
  curve_tag(domain, request.curve, request.place + ".curve");  // refuses unknown names
  const NurbsCurve& curve =
      domain.curves[static_cast<std::size_t>(find_curve(domain, request.curve))].curve;
  const MeasuredCurve measured(curve);
  LinePoints line;
  for (const double share : point_shares(request)) {
    const double s = share * measured.length(), t = measured.parameter_at(s);
    line.points.push_back(evaluate(curve, t));
    line.lengths.push_back(s);
    line.tangents.push_back(unit_tangent(curve, t));
  }
  return line;
}

}  // namespace

std::vector<double> point_shares(const LineRequest& request) {
  std::vector<double> shares;
  for (Index i = 0; i < request.points; ++i)
    shares.push_back(
        graded(static_cast<double>(i) / (request.points - 1), request.grading, request.towards));
  return shares;
}

LinePoints line_points(const LineRequest& request, const Domain& domain) {
  return request.curve.empty() ? straight_line(request) : curve_line(request, domain);
}

}  // namespace anisofront
