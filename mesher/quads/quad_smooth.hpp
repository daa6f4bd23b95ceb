#pragma once

#include <array>
#include <vector>

#include "mesher/quads/quad_work.hpp"

namespace anisofront {

/// Search for a better place of one vertex: parabolas along the two axes of the metric there, with
/// steps in metric length.
struct SearchOptions {
  double first_step = 0.2;
  double last_step = 0.02;
  bool repeat = true;       ///< as long as a step gains
  bool ideal_point = true;  ///< the mean of the ideal points of Eqn 27 is tried first
};

/// Finds better places for vertices: where the energy of the quadrilaterals around is least. The
/// mesh is not changed.
class QuadSmoother {
 public:
  explicit QuadSmoother(const QuadWork& work) : work_(work) {}

  /// The better place of a free vertex, or false when none was found (or the ring is too large).
  bool improve(Index v, const SearchOptions& options, WorkVertex& better);

  /// The same for a vertex that may slide, with its parameter on the curve.
  bool slide(Index v, const SearchOptions& options, WorkVertex& better, double& parameter);

 private:
  static constexpr int kMostSpokes = 16;

  bool load(Index v);
  Point ideal_point() const;
  /// Energy of the ring with p at the place; stops early above `limit`.
  double energy(const WorkVertex& p, double limit) const;
  /// Energy at p, which becomes the best place when that is less than before.
  double attempt(Point p, Index hint, double limit);

  const QuadWork& work_;
  int size_ = 0;
  bool fan_ = false;  ///< p on the boundary: the last edge p g is not the first p q
  std::array<QuadView, kMostSpokes> spokes_;  ///< the quadrilaterals p q t g around p
  std::array<MetricFactor, kMostSpokes> at_g_;
  WorkVertex best_;
  double least_ = 0;  ///< energy there
};

/// Sweeps of smoothing over all vertices that may move; after the first only those whose
/// surroundings have moved noticeably. Energies are up to date afterwards.
void smooth_all(QuadWork& work, int sweeps, const SearchOptions& options);

/// The same for some vertices, ascending.
void smooth_some(QuadWork& work, std::vector<Index> vertices, int sweeps,
                 const SearchOptions& options);

}  // namespace anisofront
