#pragma once

#include "mesher/quads/quad_levels.hpp"

namespace anisofront {

/// The paper's conversion in its five steps (section 3, "Quadrilateral mesh conversion"): the
/// triangles of the metric M/4 are merged (i), smoothed and partly eliminated (ii), joined to
/// pentagons (iii), divided (iv) and smoothed (v). QuadStart::systematic merges layer by layer, as
/// section 5 proposes; with all other starts it is the best beta~ first. Front and enhancement are
/// those of the input.
///
/// Departures, without which the published Examples 1, 2 isotropic and 2 anisotropic (beta~ .714,
/// .720 and .673; 1582, 2584 and 422 quadrilaterals) are not reached: .64, .60 and .63; 2412, 5010
/// and 754. With them .72, .72 and .72; 1680, 2400 and 420, over ten cycles each.
/// - New vertices keep 0.6 from the front instead of 0.1: the number of quadrilaterals.
/// - search_mixed() after the elimination of triangles and after the last smoothing: beta~ grows by
///   0.06 to 0.11; 2 to 4 % of the edges leave [0.5, 1.5], which holds 95 to 97 % of them then.
/// - No pentagon has a nearly flat corner at its triangle: the least beta~ and the worst angle.
/// All quadrilaterals are convex unless curves bulge too far into the elements at them.
LevelMesh paper_quads(const QuadrangulateInput& input, const Monitor& monitor);

/// A warning that counts the quadrilaterals with beta~ below 0.05 and names the place of the worst;
/// nothing where there are none. The vertices carry the wanted metric.
void warn_about_bad_quads(const MixedMesh& mesh, const Monitor& monitor);

}  // namespace anisofront
