#include "mesher/enhance/enhance.hpp"

#include <algorithm>

#include "mesher/enhance/edge_length.hpp"
#include "mesher/enhance/paper_smooth.hpp"
#include "mesher/enhance/repair.hpp"
#include "mesher/enhance/smooth.hpp"
#include "mesher/enhance/swap.hpp"

namespace anisofront {
namespace {

void enhance_like_paper(Patch& patch, const Monitor& monitor) {
  constexpr int kCycles = 3;
  swap_all(patch, SwapCriterion::product, 1);
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    monitor.report("enhance", 0.5 * cycle / kCycles);
    paper_length_smoothing(patch);
  }
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    monitor.report("enhance", 0.5 + 0.5 * cycle / kCycles);
    paper_quality_smoothing(patch);
  }
  swap_all(patch, SwapCriterion::product, 1);
}

constexpr double kGood = 0.9;  ///< pairs of triangles above this are not worth a swap

/// Smoothing between two rounds of swaps.
void smooth_and_swap(Patch& patch, int sweeps, SwapCriterion criterion) {
  smooth_active(patch, {.sweeps = sweeps});
  patch.update_all_alphas();
  swap_all(patch, criterion, kGood);
}

/// Edges out of bounds go, and what that disturbs is repaired. Returns whether any did.
bool adjust_lengths(Patch& patch, const EdgeLengthOptions& options) {
  const EnhanceStatistics before = patch.statistics;
  collapse_and_split(patch, options);
  swap_all(patch, SwapCriterion::minimum, kGood);
  smooth_and_swap(patch, 4, SwapCriterion::minimum);
  return patch.statistics.collapses > before.collapses || patch.statistics.splits > before.splits;
}

void smooth_finely(Patch& patch) {
  std::fill(patch.active.begin(), patch.active.end(), 1);
  smooth_active(patch, {.sweeps = 5, .content = 0.002, .moved = 0.01});
  patch.update_all_alphas();
  swap_all(patch, SwapCriterion::minimum, kGood);
}

/// The order was measured (tests/bench): each stage removes most of what the one before leaves, and
/// all but the first sweeps touch only what has changed.
void enhance_best(Patch& patch, const EnhanceOptions& options, const Monitor& monitor) {
  constexpr int kMostRounds = 5;
  swap_all(patch, SwapCriterion::product, kGood);
  smooth_and_swap(patch, 2, SwapCriterion::product);
  monitor.report("enhance", 0.3);
  adjust_lengths(patch, {});
  monitor.report("enhance", 0.5);
  for (int round = 0; round < kMostRounds; ++round)
    if (!adjust_lengths(patch, {0.73, 1.39, 1.40, 0.55})) break;
  monitor.report("enhance", 0.7);
  smooth_targeted(patch, 0.8, 1.36);
  swap_all(patch, SwapCriterion::minimum, 0.85);
  const bool fine = patch.mesh.triangles.size() <= options.fine_up_to;
  for (int round = 0; round < 2; ++round) repair_worst(patch, fine ? 0.9 : 0.8, 1.4);
  monitor.report("enhance", 0.9);
  if (fine) smooth_finely(patch);
  smooth_targeted(patch, 0.8, 1.38);
  swap_all(patch, SwapCriterion::minimum, 0.85);
}

}  // namespace

void enhance(Patch& patch, const EnhanceOptions& options, const Monitor& monitor) {
  if (options.paper)
    enhance_like_paper(patch, monitor);
  else
    enhance_best(patch, options, monitor);
}

}  // namespace anisofront
