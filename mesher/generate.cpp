#include "mesher/generate.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "mesher/background/background_mesh.hpp"
#include "mesher/enhance/required_points.hpp"
#include "mesher/generate_collect.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/mesh/check.hpp"
#include "mesher/metric/gradation.hpp"

namespace anisofront {
namespace {

/// The result of the work, whose time is added to a phase.
template <class Work>
auto timed(double& seconds, Work&& work) {
  Stopwatch watch;
  auto result = work();
  seconds += watch.lap();
  return result;
}

/// A unit equilateral triangle has area sqrt(3)/4.
double expected_triangles(const BackgroundMesh& background) {
  return 4 / std::sqrt(3.) * background.complexity();
}

void require_budget(double expected, std::int64_t limit) {
  if (expected <= static_cast<double>(limit)) return;
  throw BudgetError("the metric asks for about " +
                    std::to_string(static_cast<std::int64_t>(std::min(expected, 9e18))) +
                    " elements, more than the limit of " + std::to_string(limit) +
                    "; ask for larger sizes or raise the limit");
}

/// Domain points inside regions become vertices; those on curves are vertices already.
void insert_inner_points(const Domain& domain, Patch& patch, std::vector<Index>& point_vertices) {
  std::vector<Point> inner;
  for (std::size_t i = 0; i < point_vertices.size(); ++i)
    if (point_vertices[i] == kNoIndex) inner.push_back(domain.points[i].point);
  const std::vector<Index> inserted = insert_required_points(patch, inner);
  std::size_t next = 0;
  for (Index& v : point_vertices)
    if (v == kNoIndex) v = inserted[next++];
}

EnhanceStatistics improve(const Domain& domain, const BackgroundMesh& background,
                          Boundary& boundary, const GenerateOptions& options,
                          const Monitor& monitor) {
  std::vector<Index> required;
  for (const Index v : boundary.point_vertices)
    if (v != kNoIndex) required.push_back(v);
  Patch patch = make_patch(background, boundary.mesh, required);
  insert_inner_points(domain, patch, boundary.point_vertices);
  enhance(patch, options.enhance, monitor);
  return patch.statistics;
}

/// Room for what the metric asks for and some more, so that nothing is copied on the way.
void reserve(WorkMesh& work, double expected_triangles) {
  work.triangles.reserve(static_cast<std::size_t>(1.15 * expected_triangles) + 64);
  work.vertices.reserve(static_cast<std::size_t>(0.58 * expected_triangles) + work.vertices.size() +
                        64);
}

}  // namespace

GenerateOptions generate_options(Preset preset) {
  GenerateOptions options;
  options.preset = preset;
  if (preset == Preset::best) return options;
  options.interpolation = Interpolation::simultaneous_reduction;
  options.boundary.over_old_segments = true;
  options.front = paper_front_options();
  options.enhance.paper = true;
  return options;
}

GenerateResult generate(const Domain& domain, Mesh background_mesh, MetricField field,
                        const GenerateOptions& options, const Monitor& monitor) {
  PhaseSeconds seconds;
  auto background = timed(seconds.background, [&] {
    validate(domain);
    if (options.gradation > 1) limit_gradation(background_mesh, field, options.gradation);
    return std::make_unique<BackgroundMesh>(background_mesh, field, options.interpolation);
  });
  field = MetricField();  // unlike {}, which keeps the capacity
  const double expected = expected_triangles(*background);
  require_budget(expected, options.max_elements);
  Boundary boundary = timed(seconds.boundary, [&] {
    return discretise_boundary(domain, background_mesh, *background, options.boundary,
                               options.max_elements, monitor);
  });
  background_mesh = Mesh();
  reserve(boundary.mesh, expected);
  const FrontStatistics front = timed(seconds.front, [&] {
    return advance_front(*background, boundary.mesh, options.front, expected, monitor);
  });
  const EnhanceStatistics enhanced = timed(
      seconds.enhance, [&] { return improve(domain, *background, boundary, options, monitor); });
  background.reset();
  GenerateResult result = timed(seconds.verify, [&] {
    Collected made = collect(domain, std::move(boundary));
    require_valid(made.mesh);
    return GenerateResult{std::move(made.mesh), std::move(made.metric), {}, {}, {}};
  });
  result.front = front;
  result.enhance = enhanced;
  result.seconds = seconds;
  return result;
}

}  // namespace anisofront
