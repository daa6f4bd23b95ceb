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

/// A unit square has area 1; two triangles make a quadrilateral of a mixed mesh.
double expected_elements(const BackgroundMesh& background, Elements elements) {
  if (elements == Elements::quadrilateral) return background.complexity();
  const double triangles = expected_triangles(background);
  return elements == Elements::mixed ? triangles / 2 : triangles;
}

void require_budget(double expected, std::int64_t limit) {
  if (expected <= static_cast<double>(limit)) return;
  throw BudgetError("the metric asks for about " +
                    std::to_string(static_cast<std::int64_t>(std::min(expected, 9e18))) +
                    " elements, more than the limit of " + std::to_string(limit) +
                    "; ask for larger sizes or raise the limit");
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

/// What generate() was given, the metric read.
struct Making {
  const Domain& domain;
  Mesh old_mesh;
  std::unique_ptr<BackgroundMesh> background;
  const GenerateOptions& options;
  const Monitor& monitor;
};

GenerateResult verified(Collected made) {
  require_valid(made.mesh);
  return {std::move(made.mesh), std::move(made.metric), {}, {}, {}, {}};
}

GenerateResult make_triangles(Making making, PhaseSeconds seconds) {
  const double expected = expected_triangles(*making.background);
  Boundary boundary = timed(seconds.boundary, [&] {
    return discretise_boundary(making.domain, making.old_mesh, *making.background,
                               making.options.boundary, making.options.max_elements,
                               making.monitor);
  });
  making.old_mesh = Mesh();
  reserve(boundary.mesh, expected);
  const FrontStatistics front = timed(seconds.front, [&] {
    return advance_front(*making.background, boundary.mesh, making.options.front, expected,
                         making.monitor);
  });
  const EnhanceStatistics enhanced = timed(seconds.enhance, [&] {
    return improve(making.domain, *making.background, boundary, making.options, making.monitor);
  });
  making.background.reset();
  GenerateResult result =
      timed(seconds.verify, [&] { return verified(collect(making.domain, std::move(boundary))); });
  result.front = front;
  result.enhance = enhanced;
  result.seconds = seconds;
  return result;
}

GenerateResult make_quadrilaterals(Making making, PhaseSeconds seconds) {
  const GenerateOptions& options = making.options;
  const QuadrangulateInput input{making.domain,    making.old_mesh,     *making.background,
                                 options.boundary, options.front,       options.enhance,
                                 options.quads,    options.max_elements};
  double spent = 0;
  Quadrangulation made = timed(spent, [&] {
    return options.elements == Elements::mixed ? quad_dominant(input, making.monitor)
                                               : quadrangulate(input, making.monitor);
  });
  seconds.boundary = made.statistics.boundary;
  seconds.front = made.statistics.front;
  seconds.quads = std::max(spent - seconds.boundary - seconds.front, 0.);
  if (options.elements == Elements::quadrilateral) require_quadrilaterals(made.mesh);
  making.old_mesh = Mesh();
  making.background.reset();
  GenerateResult result = timed(seconds.verify, [&] {
    return verified(collect(making.domain, std::move(made.mesh), made.point_vertices));
  });
  result.quads = made.statistics;
  result.seconds = seconds;
  return result;
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
  options.quads.method = QuadMethod::paper;
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
  require_budget(expected_elements(*background, options.elements), options.max_elements);
  Making making{domain, std::move(background_mesh), std::move(background), options, monitor};
  return options.elements == Elements::triangle ? make_triangles(std::move(making), seconds)
                                                : make_quadrilaterals(std::move(making), seconds);
}

}  // namespace anisofront
