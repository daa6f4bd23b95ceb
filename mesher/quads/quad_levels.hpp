#pragma once

#include <vector>

#include "mesher/quads/quad_clean.hpp"
#include "mesher/quads/quad_options.hpp"

namespace anisofront {

/// How the first quadrilaterals of one attempt are made.
struct Attempt {
  int levels = 1;          ///< regular divisions afterwards: sizes are 2^levels times larger
  double size_factor = 1;  ///< and this much more
  QuadStart start = QuadStart::right_angle;
};

/// A pure quadrilateral mesh at some level, with what belongs to it.
struct LevelMesh {
  MixedMesh mesh;
  std::vector<Index> point_vertices;
  QuadStatistics statistics;
  bool pure = true;        ///< no triangle is left
  double score = 0;        ///< least is best: see quad_levels.cpp
  double count_ratio = 1;  ///< number of quadrilaterals against the wanted one
};

/// Number of quadrilaterals that the metric asks for, whatever the present size factor.
double wanted_quads(const BackgroundMesh& background);

/// Whether so few are wanted that time per quadrilateral matters little: more is tried then.
inline bool is_small(const BackgroundMesh& background) { return wanted_quads(background) < 5000; }

/// The coarse triangulation of an attempt: boundary, front, for equilateral starts enhancement,
/// required points.
Boundary coarse_triangulation(const QuadrangulateInput& input, const Attempt& attempt, bool even,
                              QuadStatistics& statistics, const Monitor& monitor);

/// Coarse quadrilaterals of an attempt: triangulated, paired, leftovers merged, cleaned.
LevelMesh coarse_quads(const QuadrangulateInput& input, const Attempt& attempt,
                       const Monitor& monitor);

/// Divides regularly down to the wanted sizes, cleaning at every level.
void refine_levels(const QuadrangulateInput& input, int levels, LevelMesh& coarse,
                   const Monitor& monitor);

/// Cleans a pure mesh at the present size factor of the background, and judges it.
void clean_mesh(const QuadrangulateInput& input, bool finest, LevelMesh& level,
                const Monitor& monitor);

}  // namespace anisofront
