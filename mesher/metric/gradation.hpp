#pragma once

#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// Limits how fast sizes grow: over a unit of metric length by the factor `ratio` (> 1) at most.
/// Across every edge pq the metric of p, grown in metric space to
///   M_p(q) = M_p / (1 + l_p(pq) ln ratio)^2,   l_p the length of pq in M_p,
/// is intersected into M_q, and the other way round, until no vertex asks for anything new.
/// ratio <= 1 (or not a number): the field stays as it is.
/// Afterwards M_q dominates M_p(q) on every edge up to 0.1 percent of the squared lengths, and no
/// metric is coarser than before; a second call changes nothing. Ends always: a vertex hands its
/// metric on at most 100 times (smooth fields need one or two).
/// Throws InputError when the field does not hold one metric per vertex.
/// Reference: F. Alauzet, Size gradation control of anisotropic meshes, Finite Elem. Anal. Des. 46
/// (2010), doi:10.1016/j.finel.2009.06.028 (metric-space gradation).
void limit_gradation(const Mesh& mesh, MetricField& field, double ratio);

}  // namespace anisofront
