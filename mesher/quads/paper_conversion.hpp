#pragma once

// Steps (ii) to (v) of the paper's conversion of triangles to quadrilaterals (section 3,
// "Quadrilateral mesh conversion"); step (i) is pair_triangles(). In the order of paper_quads():
//   smooth_mixed()         (ii)        Eqns 25 to 27, metric of the front (M/4)
//   eliminate_triangles()  (ii)        Fig. 9; then search_mixed()
//   divide_mixed()         (iii), (iv) Eqns 28 and 29, Fig. 11, from here on with the metric M
//   smooth_mixed()         (v)         then search_mixed()
#include "mesher/quads/division.hpp"
#include "mesher/quads/mixed_smooth.hpp"
#include "mesher/quads/triangle_elimination.hpp"
