#include "drivers/loop_input.hpp"

#include <algorithm>

#include "drivers/prescribed_metric.hpp"
#include "drivers/scalar_setup.hpp"
#include "mesher/io/mesh_io.hpp"
#include "mesher/mesh/check.hpp"

namespace anisofront {
namespace {

/// Two triangles that cover the domain with room to spare.
Mesh box_around(const Domain& domain) {
  Point low = domain.curves.front().curve.points.front(), high = low;
  // A NURBS curve lies in the convex hull of its control points.
  for (const DomainCurve& curve : domain.curves)
    for (const Point p : curve.curve.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const Vector margin = 0.01 * norm(high - low) * Vector{1, 1};
  low = low - margin;
  high = high + margin;
  Mesh box;
  box.points = {low, {high.x, low.y}, high, {low.x, high.y}};
  box.triangles = {{0, 1, 2}, {0, 2, 3}};
  box.triangle_regions = {1, 1};
  return box;
}

AdaptSettings adapt_settings(const Study& study) {
  AdaptSettings settings;
  settings.mode = study.mode;
  if (study.target.nodes) settings.target_vertices = *study.target.nodes;
  settings.target_error = study.target.error;
  settings.limits = study.limits;
  settings.limits.gradation = study_options(study).gradation;
  return settings;
}

/// What cycles cannot adapt yet, one solve can.
void require_adaptable(const Study& study) {
  const auto refuse = [&](const std::string& place, const std::string& what) {
    throw UsageError(place + ": " + what + ": anisofront solve " + study.file.string());
  };
  if (study.plate) refuse(study.plate->place, "plates are solved on one mesh so far");
  if (!study.problem) return;
  const std::string& place = study.problem->place;
  if (study.problem->order != 1)
    refuse(place + ".order", "cycles are run with order 1 so far; for one mesh");
  if (study.elements != Elements::triangle)
    refuse(place, "cycles of a [problem] are run on triangles so far; for one mesh of others");
  if (!study.target.nodes && !study.target.error)
    refuse(place, "cycles need adapt.target = { nodes = 1000 } or { error = 0.01 }; for one mesh");
}

void set_purpose(const Study& study, LoopInput& input) {
  if (study.metric) {
    // One copy to sample, one for the statistics: the same compiled expressions.
    input.exact_metric = prescribed_metric(*study.metric, input.domain, study.limits);
    input.analyse = analyse_prescribed(input.exact_metric, input.generate.gradation);
    return;
  }
  const auto exact = known_solution(*study.problem);
  input.analyse = analyse_scalar(scalar_problem(*study.problem, input.domain, exact), exact,
                                 adapt_settings(study));
}

}  // namespace

GenerateOptions study_options(const Study& study) {
  GenerateOptions options = generate_options(study.preset);
  options.interpolation = study.interpolation;
  if (study.preset == Preset::best)
    options.gradation = study.gradation;  // the paper limits nothing
  options.elements = study.elements;
  options.quads = study.quads;
  options.max_elements = study.max_elements;
  options.boundary.chord_height = study.chord_height;
  return options;
}

Mesh uniform_mesh(const Domain& domain, double size, const GenerateOptions& options,
                  const Monitor& monitor) {
  const Mesh box = box_around(domain);
  const MetricField field(box.points.size(), metric_from_size(size));
  GenerateOptions uniform = generate_options(Preset::best);
  uniform.max_elements = options.max_elements;
  uniform.elements = options.elements;
  uniform.quads = options.quads;
  uniform.boundary.chord_height = options.boundary.chord_height;
  return generate(domain, box, field, uniform, monitor).mesh;
}

Mesh usable_mesh(const std::filesystem::path& file, const Monitor& monitor) {
  Mesh mesh = read_mesh_file(file, monitor).mesh;
  require_usable(mesh, file.string());
  return mesh;
}

Start study_start(const Study& study, InitialElements elements, const Monitor& monitor) {
  Start start{study.domain, {}};
  if (!study.domain_mesh.empty()) {
    start.mesh = usable_mesh(study.domain_mesh, monitor);
    start.domain = domain_from_mesh(start.mesh, study.domain_options);
  }
  if (study.initial.file.empty()) {
    GenerateOptions options = study_options(study);
    if (elements == InitialElements::triangles) options.elements = Elements::triangle;
    start.mesh = uniform_mesh(start.domain, study.initial.size, options, monitor);
  } else if (study.initial.file != study.domain_mesh) {
    start.mesh = usable_mesh(study.initial.file, monitor);
    attach_to_domain(start.mesh, start.domain);
  }
  return start;
}

LoopInput loop_input(const Study& study, const Monitor& monitor) {
  require_adaptable(study);
  Start start = study_start(study, InitialElements::triangles, monitor);
  LoopInput input;
  input.domain = std::move(start.domain);
  input.initial = std::move(start.mesh);
  input.cycles = study.cycles;
  input.generate = study_options(study);
  set_purpose(study, input);
  input.generate.gradation = 0;  // the analysis limits the metric, so that the history sees it
  return input;
}

}  // namespace anisofront
