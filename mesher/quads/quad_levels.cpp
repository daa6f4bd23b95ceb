#include "mesher/quads/quad_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/enhance/required_points.hpp"
#include "mesher/front/right_angle.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/quads/leftover_triangles.hpp"
#include "mesher/quads/pairing.hpp"
#include "mesher/quads/paper_conversion.hpp"
#include "mesher/quads/quad_operations.hpp"

namespace anisofront {
namespace {

bool is_right_angled(QuadStart start) {
  return start == QuadStart::right_angle || start == QuadStart::greedy;
}

Pairing pairing_of(QuadStart start) {
  if (start == QuadStart::greedy) return Pairing::beta_order;
  return start == QuadStart::systematic ? Pairing::systematic : Pairing::matching;
}

/// Small meshes get more time per quadrilateral; coarse ones in any case cost little.
CleanOptions clean_options(const QuadrangulateInput& input, bool coarse) {
  if (input.options.effort == QuadEffort::fast)
    return coarse ? CleanOptions{.threshold = 0.8, .most_passes = 6, .last_sweeps = 2}
                  : CleanOptions{
                        .threshold = 1, .most_passes = 2, .first_sweeps = 2, .last_sweeps = 2};
  if (is_small(input.background)) return {.threshold = 0.3};
  return {.threshold = coarse ? 0.6 : 0.8, .last_sweeps = 4};
}

/// Mean energy and a share of the worst; a number of quadrilaterals off by more than some percent
/// counts against it.
void judge(QuadWork& work, double wanted, LevelMesh& level) {
  constexpr double kTolerance = 0.03, kPenalty = 5, kMostPenalty = 0.4, kShareOfWorst = 0.1;
  work.weights = {.length = 0.6};
  double energy = 0, worst = 0;
  Index count = 0;
  for (Index q = 0; q < work.mesh.quad_count(); ++q) {
    if (work.mesh.is_dead(q)) continue;
    const double e = work.energy_of(q).value;
    energy += e;
    worst = std::max(worst, e);
    ++count;
  }
  level.count_ratio = count / wanted;
  const double off = std::max(0., std::fabs(std::log(level.count_ratio)) - kTolerance);
  level.score = energy / count + kShareOfWorst * worst + std::min(kPenalty * off, kMostPenalty);
}

void add(QuadStatistics& total, const CleanStatistics& part) {
  total.trials += part.trials;
  total.operations += part.operations;
}

/// Metrics of all vertices at the present size factor of the background.
void look_up_metrics(const BackgroundMesh& background, QuadMesh& mesh) {
  for (WorkVertex& v : mesh.vertices) v.r = background.factor_at(v.p, v.hint);
}

}  // namespace

double wanted_quads(const BackgroundMesh& background) {
  return background.complexity() * background.size_factor() * background.size_factor();
}

Boundary coarse_triangulation(const QuadrangulateInput& input, const Attempt& attempt, bool even,
                              QuadStatistics& statistics, const Monitor& monitor) {
  input.background.set_size_factor(std::ldexp(1., attempt.levels));
  const double expected = 4 / std::sqrt(3.) * input.background.complexity();
  Stopwatch watch;
  BoundaryOptions boundary_options = input.boundary;
  boundary_options.even = even;
  Boundary boundary = discretise_boundary(input.domain, input.old_mesh, input.background,
                                          boundary_options, input.max_elements, monitor);
  statistics.boundary += watch.lap();
  // The boundary keeps its wanted edges, corrections of the number are made inside.
  input.background.set_size_factor(std::ldexp(attempt.size_factor, attempt.levels));
  const bool right = is_right_angled(attempt.start);
  advance_front(input.background, boundary.mesh, right ? right_angle_front_options() : input.front,
                expected, monitor);
  std::vector<Index> required;
  for (const Index v : boundary.point_vertices)
    if (v != kNoIndex) required.push_back(v);
  Patch patch = make_patch(input.background, boundary.mesh, required);
  insert_inner_points(input.domain, patch, boundary.point_vertices);
  if (!right) enhance(patch, input.enhance, monitor);
  statistics.front += watch.lap();
  return boundary;
}

LevelMesh coarse_quads(const QuadrangulateInput& input, const Attempt& attempt,
                       const Monitor& monitor) {
  // Sizes that change too fast make far too many triangles; a few do no harm.
  constexpr double kCrowded = 3, kFew = 200;
  LevelMesh level;
  Boundary boundary = coarse_triangulation(input, attempt, true, level.statistics, monitor);
  Stopwatch watch;
  level.statistics.triangles =
      std::count_if(boundary.mesh.triangles.begin(), boundary.mesh.triangles.end(),
                    [](const WorkTriangle& t) { return !t.dead(); });
  level.point_vertices = std::move(boundary.point_vertices);
  level.mesh = pair_triangles(boundary.mesh, level.point_vertices, pairing_of(attempt.start));
  level.statistics.leftovers = std::count_if(level.mesh.faces.begin(), level.mesh.faces.end(),
                                             [](const MixedFace& f) { return !f.is_quad(); });
  level.pure = merge_leftover_triangles(level.mesh) == 0;
  level.statistics.pairing += watch.lap();
  const double expected = 4 / std::sqrt(3.) * input.background.complexity();
  if (!level.pure || static_cast<double>(level.statistics.triangles) > kCrowded * expected + kFew) {
    level.pure = false;
    return level;
  }
  QuadWork work(input.background, make_quad_mesh(level.mesh), {});
  work.allow_sliding(input.domain, std::move(level.mesh.segments), level.point_vertices);
  remove_doublets(work);
  add(level.statistics, clean(work, clean_options(input, true), monitor));
  input.background.set_size_factor(std::ldexp(1., attempt.levels));
  look_up_metrics(input.background, work.mesh);
  judge(work, input.background.complexity(), level);
  level.mesh = glued(work.mesh, std::move(work.segments));
  level.statistics.cleaning += watch.lap();
  return level;
}

void refine_levels(const QuadrangulateInput& input, int levels, LevelMesh& coarse,
                   const Monitor& monitor) {
  Stopwatch watch;
  coarse.statistics.levels = levels;
  for (int level = levels - 1; level >= 0; --level) {
    input.background.set_size_factor(std::ldexp(1., level));
    coarse.mesh = divide_mixed(input.domain, input.background, coarse.mesh, false);
    clean_mesh(input, level == 0, coarse, monitor);
  }
  if (levels == 0) clean_mesh(input, true, coarse, monitor);
  coarse.statistics.cleaning += watch.lap();
}

void clean_mesh(const QuadrangulateInput& input, bool finest, LevelMesh& level,
                const Monitor& monitor) {
  QuadWork work(input.background, make_quad_mesh(level.mesh), {});
  work.allow_sliding(input.domain, std::move(level.mesh.segments), level.point_vertices);
  add(level.statistics, clean(work, clean_options(input, false), monitor));
  if (finest && input.options.effort == QuadEffort::best) add(level.statistics, polish(work));
  judge(work, input.background.complexity(), level);
  level.mesh = glued(work.mesh, std::move(work.segments));
}

}  // namespace anisofront
