#include "drivers/problem/prescribed_metric.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "mesher/geometry/curve_locator.hpp"
#include "mesher/metric/intersection.hpp"

namespace anisofront {
namespace {

/// Names the expressions may use; the last four need distance_to.
const std::vector<std::string> kPlaceNames{"x", "y"};
const std::vector<std::string> kCurveNames{"x", "y", "d", "tx", "ty", "c"};
const char* const kCurveHint =
    " (d, tx, ty and c are known in entries with distance_to = [\"curve\", ...])";

CurveLocator locator_of(const DirectionalSizes& sizes, const Domain& domain) {
  std::vector<std::string> known;
  for (const DomainCurve& curve : domain.curves) known.push_back(curve.name);
  std::vector<NurbsCurve> curves;
  for (const std::string& name : sizes.distance_to) {
    const Index found = find_curve(domain, name);
    if (found == kNoIndex)
      throw UsageError(fmt::format("{}.distance_to: no curve is called \"{}\"{}", sizes.place, name,
                                   name_proposal(name, known)));
    curves.push_back(domain.curves[static_cast<std::size_t>(found)].curve);
  }
  return CurveLocator(std::move(curves));
}

/// The expressions of one entry: h1, h2, the two parts of e1, then those of `where`.
ExpressionProgram program_of(const DirectionalSizes& sizes, const Constants& constants) {
  std::vector<NamedExpression> all{{"h1", sizes.h1}, {"h2", sizes.h2}};
  if (sizes.e1) {
    all.push_back({{}, (*sizes.e1)[0]});
    all.push_back({{}, (*sizes.e1)[1]});
  }
  all.insert(all.end(), sizes.where.begin(), sizes.where.end());
  const bool has_curves = !sizes.distance_to.empty();
  return ExpressionProgram(has_curves ? kCurveNames : kPlaceNames, constants, std::move(all),
                           has_curves ? "" : kCurveHint);
}

/// One entry of the list, ready to be evaluated.
class SizesAtPoint {
 public:
  SizesAtPoint(const DirectionalSizes& sizes, const Constants& constants, const Domain& domain)
      : has_direction_(sizes.e1.has_value()), program_(program_of(sizes, constants)) {
    if (!sizes.distance_to.empty()) locator_.emplace(locator_of(sizes, domain));
  }

  Metric operator()(Point p) {
    const std::vector<double>& values = evaluate(p);
    const double h1 = checked_size(0, values[0], p);
    const double h2 = checked_size(1, values[1], p);
    if (!has_direction_) return metric_from_sizes(h1, h2, {1, 0});
    const Vector e1{checked(2, values[2], p), checked(3, values[3], p)};
    return metric_from_sizes(h1, h2, norm(e1) > 0 ? e1 : Vector{1, 0});
  }

 private:
  const std::vector<double>& evaluate(Point p) {
    if (!locator_) return program_.evaluate({p.x, p.y});
    const CurveProjection near = locator_->nearest(p);
    return program_.evaluate(
        {p.x, p.y, near.distance, near.tangent.x, near.tangent.y, std::abs(near.curvature)});
  }

  [[noreturn]] void fail(std::size_t i, double value, Point p, const char* expected) const {
    const ExpressionText& at = program_.expression(i).expression;
    throw InputError(fmt::format("{} = \"{}\" is {} at {}; it must be {} everywhere in the domain",
                                 at.place, at.text, value, coordinates(p), expected));
  }
  double checked(std::size_t i, double value, Point p) const {
    if (!std::isfinite(value)) fail(i, value, p, "finite");
    return value;
  }
  double checked_size(std::size_t i, double value, Point p) const {
    if (!(value > 0) || !std::isfinite(value)) fail(i, value, p, "positive and finite");
    return value;
  }

  bool has_direction_;
  ExpressionProgram program_;
  std::optional<CurveLocator> locator_;
};

bool limits_something(const MetricLimits& limits) {
  return limits.hmin > 0 || std::isfinite(limits.hmax) || std::isfinite(limits.stretch);
}

Metric limited(const Metric& m, bool isotropic, const MetricLimits& limits) {
  const PrincipalAxes axes = principal_axes(m);
  const double h2 = isotropic ? axes.h1 : axes.h2;
  return metric_of(
      limited(PrincipalMetric{1 / (axes.h1 * axes.h1), 1 / (h2 * h2), axes.e1}, limits));
}

}  // namespace

MetricFunction prescribed_metric(const PrescribedMetric& metric, const Domain& domain,
                                 const MetricLimits& limits) {
  auto entries = std::make_shared<std::vector<SizesAtPoint>>();
  for (const DirectionalSizes& sizes : metric.list)
    entries->emplace_back(sizes, metric.constants, domain);
  const auto intersected = [entries](Point p) {
    Metric m = entries->front()(p);
    for (std::size_t i = 1; i < entries->size(); ++i) m = intersect(m, (*entries)[i](p));
    return m;
  };
  if (!metric.isotropic && !limits_something(limits)) return intersected;
  return [intersected, isotropic = metric.isotropic, limits](Point p) {
    return limited(intersected(p), isotropic, limits);
  };
}

}  // namespace anisofront
