#pragma once

#include <span>

#include "adapt/error_metric.hpp"

namespace anisofront {

/// Sets the density of a field (shape stays) so that every element of the next mesh would
/// contribute equally to the error: what element K of size |K| contributes falls like
/// |K|^(order + 1), so that sqrt(det M) ~ contribution^(1 / (order + 1)) / |K|; geometric mean over
/// the elements around a vertex. Hessians know directions well, but the size of the error only up
/// to a factor that differs between layers and smooth regions; the estimate measures it.
/// `contributions`: per element, adding up to the error's measure: squares of energy indicators,
/// amounts of goal indicators. Those below 1e-6 of their mean count as that; when all vanish the
/// field stays as it is. `stretch`: the largest that later limits will leave; shapes are limited to
/// it first, for else the limit would add elements where it acts.
/// Throws InputError unless there is one finite contribution per element that is not negative.
/// Precondition: one metric per vertex; order 1 or 2 (energy error ~ vertices^(-order / 2)).
void equidistribute(const Mesh& mesh, std::span<const double> contributions, int order,
                    double stretch, PrincipalField& field);

}  // namespace anisofront
