#include "drivers/problem/loop_input.hpp"

#include "adapt/reference_errors.hpp"
#include "drivers/problem/adapt_setup.hpp"
#include "drivers/problem/prescribed_metric.hpp"
#include "drivers/problem/sample_points.hpp"
#include "drivers/problem/study_model.hpp"
#include "mesher/io/mesh_io.hpp"
#include "mesher/mesh/check.hpp"

namespace anisofront {
namespace {

/// Two triangles that cover the domain with room to spare.
Mesh box_around(const Domain& domain) {
  const Box box = control_box(domain);
  const Vector margin = 0.01 * norm(box.high - box.low) * Vector{1, 1};
  const Point low = box.low - margin, high = box.high + margin;
  Mesh mesh;
  mesh.points = {low, {high.x, low.y}, high, {low.x, high.y}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_regions = {1, 1};
  return mesh;
}

bool has_problem(const Study& study) { return study.problem || study.plate; }

void require_target(const Study& study) {
  const Target& target = study.adapt.target;
  if (study.metric || target.vertices || target.error) return;
  throw UsageError((study.plate ? study.plate->place : study.problem->place) +
                   ": cycles need adapt.target = { nodes = 1000 } or { error = 0.01 }; for one "
                   "mesh: anisofront solve " +
                   study.file.string());
}

/// Cycles start from triangles, but for the one element that cannot.
InitialElements first_elements(const Study& study) {
  const bool is_mitc4 = study.plate && study.plate->element == PlateElement::mitc4;
  return is_mitc4 ? InitialElements::as_in_study : InitialElements::triangles;
}

/// Places where values are asked for must lie in the domain.
void require_points(const Study& study, const Start& start) {
  if (has_problem(study))
    locate_requests(study.output, start.domain, curved_fe_mesh(start.mesh, start.domain));
}

/// Analysis and true errors.
void set_purpose(const Study& study, const Monitor& monitor, LoopInput& input) {
  const AdaptSettings settings = adapt_settings(study, input.domain);
  const Model model = has_problem(study) ? study_model(study, input.domain, monitor) : Model{};
  if (study.metric) {
    // One copy to sample, one for the statistics: the same compiled expressions.
    const MetricLimits limits = prescribed_limits(study);
    input.exact_metric = prescribed_metric(*study.metric, input.domain, limits);
    input.analyse = analyse_prescribed(input.exact_metric, limits.gradation, model, input.domain);
  } else {
    input.analyse = analyse_model(model, input.domain, settings);
  }
  if (study.adapt.reference)
    input.measure_errors =
        errors_against_reference(reference_model(study, input.domain), input.domain, settings,
                                 input.generate, {study.adapt.reference->nodes}, monitor);
}

}  // namespace

GenerateOptions study_options(const Study& study) {
  GenerateOptions options = generate_options(study.preset);
  options.interpolation = study.interpolation;
  options.gradation = prescribed_limits(study).gradation;
  options.elements = study.elements;
  options.quads = study.quads;
  options.max_elements = study.max_elements;
  options.boundary.chord_height = study.chord_height;
  // The outline of a mesh has corners where the study says so.
  if (!study.domain_mesh.empty()) options.boundary.corner_angle = study.domain_options.corner_angle;
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
  uniform.boundary.corner_angle = options.boundary.corner_angle;
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
  require_target(study);
  Start start = study_start(study, first_elements(study), monitor);
  require_points(study, start);
  LoopInput input;
  input.domain = std::move(start.domain);
  input.initial = std::move(start.mesh);
  input.cycles = study.adapt.cycles;
  input.stop = study.adapt.stop;
  input.generate = study_options(study);
  input.generate.gradation = 0;  // the analysis limits the metric, so that the history sees it
  set_purpose(study, monitor, input);
  return input;
}

}  // namespace anisofront
