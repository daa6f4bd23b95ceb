#include "mesher/metric/intersection.hpp"

#include <algorithm>

#include "mesher/metric/interpolation.hpp"

namespace anisofront {

Metric intersect(const Metric& m1, const Metric& m2) {
  const SimultaneousReduction r = simultaneous_reduction(m1, m2);
  if (r.lambda1 <= r.mu1 && r.lambda2 <= r.mu2) return m2;
  if (r.lambda1 >= r.mu1 && r.lambda2 >= r.mu2) return m1;
  return metric_from_reduction(r.s1, r.s2, std::max(r.lambda1, r.mu1),
                               std::max(r.lambda2, r.mu2));  // Eqn 8
}

Metric intersect(std::span<const Metric> metrics) {
  Metric result = metrics.front();
  for (const Metric& m : metrics.subspan(1)) result = intersect(result, m);
  return result;
}

}  // namespace anisofront
