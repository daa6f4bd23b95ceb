#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

struct SmoothOptions {
  int sweeps = 4;
  /// Energy per neighbour below which a vertex is left alone.
  double content = 0.02;
  /// Metric distance; a vertex that moves further activates its neighbours.
  double moved = 0.05;
};

/// Sweeps over the active interior vertices, moving each by the mean of its length and quality
/// proposals (Eqns 25a, 26) when its energy falls.
void smooth_active(Patch& patch, const SmoothOptions& options);

/// A few sweeps over the given vertices, whatever their energy; fixed ones stay.
void smooth_vertices(Patch& patch, const std::vector<Index>& vertices, int sweeps);

/// Pattern search for the interior vertices of bad triangles (alpha below `bad_alpha`) and bad
/// edges (length outside [1/bad_length, bad_length]). Returns how many vertices moved.
int smooth_targeted(Patch& patch, double bad_alpha, double bad_length);

/// Whether an edge of the triangle is longer than `bad_length` or shorter than its inverse;
/// interior edges are looked at from the triangle of larger number only.
bool has_bad_edge(const Patch& patch, Index triangle, double bad_length);

}  // namespace anisofront
