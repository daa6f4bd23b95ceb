#include "mesher/front/paper_formation.hpp"

#include <cmath>

#include "mesher/metric/metric_length.hpp"

namespace anisofront {
namespace {

MetricFunction metric_near(const BackgroundMesh& background, Index hint) {
  return [&background, hint](Point p) mutable { return metric_of(background.factor_at(p, hint)); };
}

}  // namespace

double paper_length(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b) {
  return segment_length(metric_near(background, a.hint), a.p, b.p);
}

double paper_mu(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b,
                const TrialPoint& c) {
  const WorkVertex apex{c.p, c.r, c.hint};
  const double alpha = least_alpha(a, b, apex);
  if (alpha <= 0) return -1;
  const double delta = (std::fabs(paper_length(background, a, b) - 1) +
                        std::fabs(paper_length(background, b, apex) - 1) +
                        std::fabs(paper_length(background, apex, a) - 1)) /
                       3;
  return alpha * std::exp(-delta);
}

PaperOffset paper_offset(const BackgroundMesh& background, const WorkVertex& a,
                         const WorkVertex& b) {
  const double t = metric_midpoint(metric_near(background, a.hint), a.p, b.p);
  const Point d = lerp(a.p, b.p, t);
  Index hint = a.hint;
  const MetricFactor at_d = background.factor_at(d, hint);
  PaperOffset result{d, {}};
  double best = -2;
  for (const Point c :
       {offset_from_a(metric_of(a.r), a.p, b.p), offset_from_b(metric_of(b.r), a.p, b.p),
        offset_from_midpoint(metric_of(at_d), d, b.p)}) {
    TrialPoint trial{c, {}, hint};
    trial.r = background.factor_at(c, trial.hint);
    const double quality = paper_mu(background, a, b, trial);
    if (quality > best) {
      best = quality;
      result.best = trial;
    }
  }
  return result;
}

}  // namespace anisofront
