#pragma once

#include <array>
#include <vector>

#include "mesher/quads/quad_work.hpp"

namespace anisofront {

/// Pattern search for one vertex, in lengths of the metric there.
struct SearchOptions {
  double first_step = 0.2;
  double last_step = 0.02;
  bool diagonals = true;    ///< eight directions instead of four
  bool ideal_point = true;  ///< the mean of the ideal points of Eqn 27 is tried first
};

/// Finds better places for free vertices: where the energy of the quadrilaterals around is least.
class QuadSmoother {
 public:
  explicit QuadSmoother(const QuadWork& work) : work_(work) {}

  /// The better place, or false when none was found (or the ring is too large). The mesh is not
  /// changed.
  bool improve(Index v, const SearchOptions& options, WorkVertex& better);

 private:
  static constexpr int kMostSpokes = 16;

  bool load(Index v);
  Point ideal_point() const;
  /// Energy of the ring with p at the place; stops early above `limit`.
  double energy(const WorkVertex& p, double limit) const;
  WorkVertex placed(Point p, Index hint) const;

  const QuadWork& work_;
  int size_ = 0;
  std::array<QuadView, kMostSpokes> spokes_;  ///< the quadrilaterals p q t g around p
  std::array<MetricFactor, kMostSpokes> at_g_;
};

/// Sweeps of smoothing over all free vertices; after the first only those whose surroundings have
/// moved noticeably. Energies are up to date afterwards.
void smooth_all(QuadWork& work, int sweeps, const SearchOptions& options);

/// The same for some vertices, ascending.
void smooth_some(QuadWork& work, std::vector<Index> vertices, int sweeps,
                 const SearchOptions& options);

}  // namespace anisofront
