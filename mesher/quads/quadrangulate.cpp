#include "mesher/quads/quadrangulate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "mesher/geometry/error.hpp"
#include "mesher/geometry/predicates.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/quads/convexity.hpp"
#include "mesher/quads/pairing.hpp"
#include "mesher/quads/paper_conversion.hpp"
#include "mesher/quads/paper_quads.hpp"
#include "mesher/quads/quad_levels.hpp"

namespace anisofront {
namespace {

bool is_convex(const MixedMesh& mesh, const MixedFace& face) {
  const auto corner = [&](int k) { return mesh.vertices[face.vertices[k]].p; };
  return face.is_quad() ? is_convex_quad({corner(0), corner(1), corner(2), corner(3)})
                        : orientation(corner(0), corner(1), corner(2)) > 0;
}

/// The first face that is not strictly convex.
const MixedFace* first_not_convex(const MixedMesh& mesh) {
  for (const MixedFace& face : mesh.faces)
    if (!is_convex(mesh, face)) return &face;
  return nullptr;
}

/// Regular divisions that leave some hundred coarse quadrilaterals.
int levels_for(double wanted) {
  constexpr double kThriceFrom = 25000, kTwiceFrom = 6000, kOnceFrom = 60;
  return wanted >= kThriceFrom ? 3 : wanted >= kTwiceFrom ? 2 : wanted >= kOnceFrom ? 1 : 0;
}

/// None of the starts is always the best one; more of them are tried where that costs little.
std::vector<QuadStart> starts_for(const QuadrangulateInput& input) {
  const QuadOptions& options = input.options;
  if (options.start != QuadStart::automatic) return {options.start};
  if (options.effort == QuadEffort::fast) return {QuadStart::right_angle};
  if (!is_small(input.background)) return {QuadStart::right_angle, QuadStart::equilateral};
  return {QuadStart::right_angle, QuadStart::equilateral, QuadStart::greedy, QuadStart::systematic};
}

/// Coarse attempts from one start; where the number of quadrilaterals comes out somewhat wrong,
/// once or twice more with the sizes corrected. A number that is far off says that the sizes change
/// too fast to be followed, and correcting them would not help.
void try_start(const QuadrangulateInput& input, Attempt attempt, const Monitor& monitor,
               std::vector<LevelMesh>& made) {
  constexpr double kFollowed = 0.8;
  const int corrections = is_small(input.background) ? 2 : 1;
  const bool fast = input.options.effort == QuadEffort::fast;
  const double fewest = fast ? 0.95 : 0.97, most = fast ? 1.05 : 1.035;
  for (int round = 0; round <= corrections; ++round) {
    LevelMesh level = coarse_quads(input, attempt, monitor);
    if (!level.pure) return;
    const double ratio = level.count_ratio;
    made.push_back(std::move(level));
    if (ratio > fewest && ratio < most) return;
    if (ratio < kFollowed || ratio * kFollowed > 1) return;
    attempt.size_factor *= std::sqrt(ratio);
  }
}

/// Whether the number of quadrilaterals is near enough to the wanted one.
bool is_followed(const LevelMesh& level) {
  constexpr double kLeast = 0.85;
  return level.count_ratio > kLeast && level.count_ratio * kLeast < 1;
}

bool is_tiny(const BackgroundMesh& background) { return wanted_quads(background) < 800; }

/// How much is tried: what comes out varies by some percent for no reason that could be foreseen,
/// and on small meshes it costs little to choose.
struct Comparison {
  std::vector<double> size_factors;
  int divided;  ///< coarse meshes that are divided
};
Comparison comparison_for(const QuadrangulateInput& input) {
  if (input.options.effort == QuadEffort::fast || !is_small(input.background)) return {{1}, 1};
  if (!is_tiny(input.background)) return {{1}, 4};
  return {{1, 0.97, 1.03}, 6};
}

/// The best coarse meshes divided down, and of these the best; should that leave something that is
/// not convex, the next. Nothing where a coarse mesh cannot follow the sizes.
std::optional<LevelMesh> divided_quads(const QuadrangulateInput& input, int levels,
                                       const std::vector<QuadStart>& starts,
                                       const Monitor& monitor) {
  constexpr double kGoodScore = 1;
  const Comparison comparison = comparison_for(input);
  std::vector<LevelMesh> made;
  for (const QuadStart start : starts) {
    for (const double factor : comparison.size_factors)
      try_start(input, {levels, factor, start}, monitor, made);
    if (made.empty()) continue;
    if (levels > 0 && !is_followed(made.back())) return std::nullopt;
    if (comparison.divided == 1 && made.back().score < kGoodScore) break;
  }
  std::stable_sort(made.begin(), made.end(),
                   [](const LevelMesh& x, const LevelMesh& y) { return x.score < y.score; });
  std::optional<LevelMesh> best;
  int divided = 0;
  for (LevelMesh& level : made) {
    if (best && ++divided >= comparison.divided) break;
    refine_levels(input, levels, level, monitor);
    if (first_not_convex(level.mesh)) continue;
    if (!best || level.score < best->score) best = std::move(level);
  }
  return best;
}

/// A mesh that is convex for certain, on resolved boundaries: convex pairs only, every face divided
/// (a triangle into three), then cleaned without ever losing convexity.
LevelMesh safe_quads(const QuadrangulateInput& input, const Attempt& attempt, double chord_height,
                     const Monitor& monitor) {
  QuadrangulateInput finer = input;
  if (chord_height > 0) finer.boundary.chord_height = chord_height;
  LevelMesh level;
  Boundary boundary = coarse_triangulation(finer, attempt, false, level.statistics, monitor);
  level.point_vertices = std::move(boundary.point_vertices);
  const MixedMesh mixed = pair_triangles(boundary.mesh, level.point_vertices, Pairing::beta_order);
  input.background.set_size_factor(1);
  level.mesh = divide_mixed(input.domain, input.background, mixed, false);
  clean_mesh(input, true, level, monitor);
  return level;
}

/// Safe meshes with boundaries ever closer to their curves, finer and finer inside.
LevelMesh safe_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  constexpr int kRounds = 6;
  const Vector diagonal = input.background.bounds().high - input.background.bounds().low;
  Attempt attempt{1, 0.9, QuadStart::equilateral};  // a triangle becomes three quadrilaterals
  double chord_height = 0;
  for (int round = 0;; ++round) {
    LevelMesh level = safe_quads(input, attempt, chord_height, monitor);
    const MixedFace* bad = first_not_convex(level.mesh);
    if (!bad) return level;
    if (round == kRounds) {
      const Point p = level.mesh.vertices[bad->vertices[0]].p;
      throw MeshingError("no convex quadrilateral fits near (" + std::to_string(p.x) + ", " +
                         std::to_string(p.y) + "): the boundary bends too much for the wanted " +
                         "sizes; ask for smaller ones there");
    }
    chord_height = chord_height > 0 ? 0.25 * chord_height : 0.01 * norm(diagonal);
    attempt.size_factor *= 0.8;
    attempt.start =
        attempt.start == QuadStart::equilateral ? QuadStart::right_angle : QuadStart::equilateral;
  }
}

Quadrangulation finished(const QuadrangulateInput& input, LevelMesh level) {
  input.background.set_size_factor(1);
  return {std::move(level.mesh), std::move(level.point_vertices), level.statistics};
}

/// The usual number of divisions; fewer where the coarse mesh cannot follow the sizes. Tiny meshes
/// are also tried without any: a structured one may be better than a divided one.
Quadrangulation best_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  const std::vector<QuadStart> starts = starts_for(input);
  std::optional<LevelMesh> best;
  const auto keep_better = [&](std::optional<LevelMesh> made) {
    if (made && (!best || made->score < best->score)) best = std::move(made);
    input.background.set_size_factor(1);
  };
  int levels = levels_for(wanted_quads(input.background));
  keep_better(divided_quads(input, levels, starts, monitor));
  while (levels > 0 && (!best || !is_followed(*best)))
    keep_better(divided_quads(input, --levels, starts, monitor));
  const bool tiny = is_tiny(input.background) && input.options.effort == QuadEffort::best;
  if (levels > 0 && tiny) keep_better(divided_quads(input, 0, {starts.front()}, monitor));
  if (!best)
    keep_better(divided_quads(input, 0, {QuadStart::equilateral, QuadStart::systematic}, monitor));
  return finished(input, best ? std::move(*best) : safe_quads(input, monitor));
}

Quadrangulation published_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  LevelMesh level = paper_quads(input, monitor);
  if (first_not_convex(level.mesh)) {
    monitor.warning(
        "the paper's conversion leaves quadrilaterals that are not convex; another is used");
    level = safe_quads(input, monitor);
  }
  warn_about_bad_quads(level.mesh, monitor);
  return finished(input, std::move(level));
}

}  // namespace

Quadrangulation quadrangulate(const QuadrangulateInput& input, const Monitor& monitor) {
  return input.options.method == QuadMethod::paper ? published_quads(input, monitor)
                                                   : best_quads(input, monitor);
}

Quadrangulation quad_dominant(const QuadrangulateInput& input, const Monitor& monitor) {
  LevelMesh level;
  const QuadStart start =
      input.options.start == QuadStart::automatic ? QuadStart::greedy : input.options.start;
  Boundary boundary = coarse_triangulation(input, {0, 1, start}, false, level.statistics, monitor);
  Stopwatch watch;
  level.point_vertices = std::move(boundary.point_vertices);
  level.mesh = pair_triangles(boundary.mesh, level.point_vertices, Pairing::beta_order);
  level.statistics.pairing += watch.lap();
  smooth_mixed(input.background, level.mesh);
  level.statistics.cleaning += watch.lap();
  return finished(input, std::move(level));
}

}  // namespace anisofront
