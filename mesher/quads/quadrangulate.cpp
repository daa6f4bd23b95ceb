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
#include "mesher/quads/pairing.hpp"
#include "mesher/quads/paper_conversion.hpp"
#include "mesher/quads/quad_levels.hpp"

namespace anisofront {
namespace {

bool is_convex(const MixedMesh& mesh, const MixedFace& face) {
  const int n = face.size();
  for (int k = 0; k < n; ++k) {
    const auto corner = [&](int i) { return mesh.vertices[face.vertices[(k + i) % n]].p; };
    if (orientation(corner(0), corner(1), corner(2)) <= 0) return false;
  }
  return true;
}

/// The first face that is not strictly convex.
const MixedFace* first_not_convex(const MixedMesh& mesh) {
  for (const MixedFace& face : mesh.faces)
    if (!is_convex(mesh, face)) return &face;
  return nullptr;
}

/// Regular divisions that leave some hundred coarse quadrilaterals.
int levels_for(double wanted) {
  constexpr double kThriceFrom = 40000, kTwiceFrom = 6000, kOnceFrom = 60;
  return wanted >= kThriceFrom ? 3 : wanted >= kTwiceFrom ? 2 : wanted >= kOnceFrom ? 1 : 0;
}

std::vector<QuadStart> starts_for(const QuadOptions& options) {
  if (options.start != QuadStart::automatic) return {options.start};
  if (options.effort == QuadEffort::fast) return {QuadStart::right_angle};
  return {QuadStart::right_angle, QuadStart::equilateral, QuadStart::greedy, QuadStart::systematic};
}

/// Coarse attempts from one start; where the number of quadrilaterals comes out somewhat wrong,
/// once or twice more with the sizes corrected. A number that is far off says that the sizes change
/// too fast to be followed, and correcting them would not help.
void try_start(const QuadrangulateInput& input, Attempt attempt, const Monitor& monitor,
               std::vector<LevelMesh>& made) {
  constexpr int kCorrections = 2;
  constexpr double kFewest = 0.97, kMost = 1.035, kFollowed = 0.8;
  for (int round = 0; round <= kCorrections; ++round) {
    LevelMesh level = coarse_quads(input, attempt, monitor);
    if (!level.pure) return;
    const double ratio = level.count_ratio;
    made.push_back(std::move(level));
    if (input.options.effort == QuadEffort::fast || (ratio > kFewest && ratio < kMost)) return;
    if (ratio < kFollowed || ratio * kFollowed > 1) return;
    attempt.size_factor *= std::sqrt(ratio);
  }
}

/// The best coarse mesh divided down, or, should that leave something that is not convex, the next.
std::optional<LevelMesh> divided_quads(const QuadrangulateInput& input, int levels,
                                       const std::vector<QuadStart>& starts,
                                       const Monitor& monitor) {
  std::vector<LevelMesh> made;
  for (const QuadStart start : starts) try_start(input, {levels, 1, start}, monitor, made);
  std::stable_sort(made.begin(), made.end(),
                   [](const LevelMesh& x, const LevelMesh& y) { return x.score < y.score; });
  for (LevelMesh& level : made) {
    refine_levels(input, levels, level, monitor);
    if (!first_not_convex(level.mesh)) return std::move(level);
  }
  return std::nullopt;
}

/// A mesh that is convex for certain: convex pairs only, every face divided (a triangle into
/// three), then cleaned without ever losing convexity.
LevelMesh safe_quads(const QuadrangulateInput& input, double chord_height, const Monitor& monitor) {
  QuadrangulateInput finer = input;
  if (chord_height > 0) finer.boundary.chord_height = chord_height;
  LevelMesh level;
  // A triangle becomes three quadrilaterals: sizes between 1 and 2.
  const Attempt attempt{0, 1.8, QuadStart::equilateral};
  Boundary boundary = coarse_triangulation(finer, attempt, false, level.statistics, monitor);
  level.point_vertices = std::move(boundary.point_vertices);
  const MixedMesh mixed = pair_triangles(boundary.mesh, level.point_vertices, Pairing::beta_order);
  input.background.set_size_factor(1);
  level.mesh = divide_mixed(input.domain, input.background, mixed, false);
  clean_mesh(input, true, level, monitor);
  return level;
}

/// Safe meshes on boundaries ever closer to their curves.
LevelMesh safe_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  constexpr int kRounds = 6;
  const Vector diagonal = input.background.bounds().high - input.background.bounds().low;
  double chord_height = 0;
  for (int round = 0;; ++round) {
    LevelMesh level = safe_quads(input, chord_height, monitor);
    const MixedFace* bad = first_not_convex(level.mesh);
    if (!bad) return level;
    if (round == kRounds) {
      const Point p = level.mesh.vertices[bad->vertices[0]].p;
      throw MeshingError(
          "no convex quadrilateral fits near (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
          "): the boundary bends too much for the wanted sizes; ask for smaller ones there");
    }
    chord_height = chord_height > 0 ? 0.25 * chord_height : 0.01 * norm(diagonal);
  }
}

Quadrangulation finished(const QuadrangulateInput& input, LevelMesh level) {
  input.background.set_size_factor(1);
  return {std::move(level.mesh), std::move(level.point_vertices), level.statistics};
}

/// With as few coarse quadrilaterals as here, a structured mesh may be better than a divided one.
std::optional<LevelMesh> undivided_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  const std::vector<QuadStart> starts = starts_for(input.options);
  return divided_quads(input, 0, {starts.front()}, monitor);
}

Quadrangulation best_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  constexpr double kSmall = 800;
  const double wanted = input.background.complexity();
  const int levels = levels_for(wanted);
  std::optional<LevelMesh> best = divided_quads(input, levels, starts_for(input.options), monitor);
  const bool small = wanted < kSmall && input.options.effort == QuadEffort::best;
  if (levels > 0 && (small || !best)) {
    std::optional<LevelMesh> undivided = undivided_quads(input, monitor);
    if (undivided && (!best || undivided->score < best->score)) best = std::move(undivided);
  }
  return finished(input, best ? std::move(*best) : safe_quads(input, monitor));
}

Quadrangulation paper_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  LevelMesh level;
  const Attempt attempt{1, 1, QuadStart::equilateral};
  Boundary boundary = coarse_triangulation(input, attempt, false, level.statistics, monitor);
  Stopwatch watch;
  level.point_vertices = std::move(boundary.point_vertices);
  MixedMesh mixed = pair_triangles(boundary.mesh, level.point_vertices, Pairing::beta_order);
  level.statistics.pairing += watch.lap();
  smooth_mixed(input.background, mixed);
  eliminate_triangles(input.background, mixed);
  input.background.set_size_factor(1);
  level.mesh = divide_mixed(input.domain, input.background, mixed, true);
  smooth_mixed(input.background, level.mesh);
  level.statistics.levels = 1;
  level.statistics.cleaning += watch.lap();
  if (first_not_convex(level.mesh)) {
    monitor.warning(
        "the paper's conversion leaves quadrilaterals that are not convex; another is used");
    return finished(input, safe_quads(input, monitor));
  }
  return finished(input, std::move(level));
}

}  // namespace

Quadrangulation quadrangulate(const QuadrangulateInput& input, const Monitor& monitor) {
  return input.options.method == QuadMethod::paper ? paper_quads(input, monitor)
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
