#pragma once

#include <span>

#include "mesher/metric/metric.hpp"

namespace anisofront {

/// The metric that asks for the sizes of both (Eqn 8 with ERRATA: componentwise maximum in the
/// common basis S): among the ellipses with the common axes the largest one inside both.
/// Laws: v'Mv >= max(v'M1 v, v'M2 v) for all v, up to 1e-12 and the 1e-16 (h2/h1)^2 that the three
/// entries of the result hold; commutative up to rounding; intersect(m, m) == m; when one metric
/// dominates the other it is returned bit for bit.
/// Precondition: both are positive definite.
Metric intersect(const Metric& m1, const Metric& m2);

/// The metrics intersected one after the other in the given order; not associative, so another
/// order may differ by some percent (ERRATA, Eqn 8). Precondition: at least one metric.
Metric intersect(std::span<const Metric> metrics);

}  // namespace anisofront
