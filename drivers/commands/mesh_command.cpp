#include <memory>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/commands/mesh_arguments.hpp"
#include "drivers/problem/adapt_setup.hpp"
#include "drivers/problem/loop_input.hpp"
#include "drivers/problem/prescribed_metric.hpp"
#include "drivers/run/quality_fields.hpp"
#include "drivers/study/study_file.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// What generate() takes.
struct Source {
  Domain domain;
  Mesh background;
  MetricField field;
  GenerateOptions options;
};

/// How many of what a mesh has.
struct Counts {
  std::size_t vertices = 0, triangles = 0, quads = 0;

  std::string text() const {
    std::string text = fmt::format("{} vertices", vertices);
    if (triangles > 0) text += fmt::format(", {} triangles", triangles);
    if (quads > 0) text += fmt::format(", {} quadrilaterals", quads);
    return text;
  }
};

Counts counts_of(const Mesh& mesh) {
  return {mesh.points.size(), mesh.triangles.size(), mesh.quads.size()};
}

bool is_study(const std::string& path) { return fs::path(path).extension() == ".toml"; }

/// The file that holds the metric, or empty. mmg's habit: NAME.sol beside NAME.mesh.
fs::path metric_file(const MeshArguments& arguments, Console& console) {
  if (!arguments.metric.empty()) return arguments.metric;
  const fs::path beside = fs::path(arguments.input).replace_extension(".sol");
  if (is_study(arguments.input) || arguments.size > 0 || !fs::exists(beside)) return {};
  console.say("metric from " + beside.string());
  return beside;
}

MetricField metric_on(const Mesh& mesh, const MeshArguments& arguments, Console& console) {
  const auto vertices = static_cast<Index>(mesh.points.size());
  const fs::path file = metric_file(arguments, console);
  if (!file.empty()) return read_metric_file(file, vertices);
  if (arguments.size > 0) return MetricField(mesh.points.size(), metric_from_size(arguments.size));
  throw UsageError(arguments.input + ": what size shall the elements have? Give --metric FILE or " +
                   "--size H, or put the metric into " +
                   fs::path(arguments.input).replace_extension(".sol").string());
}

MetricField study_metric(const Study& study, const Start& start) {
  if (!study.metric)
    throw UsageError(
        study.file.string() +
        ": has no [metric]; give --metric or --size, or solve it with `run` or `solve`");
  const MetricFunction metric =
      prescribed_metric(*study.metric, start.domain, prescribed_limits(study));
  MetricField field;
  for (const Point p : start.mesh.points) field.push_back(metric(p));
  return field;
}

/// The first variant with the elements asked for, or else the first of all.
const Variant& fitting_variant(const StudyFile& file, std::optional<Elements> elements) {
  for (const Variant& variant : file.variants)
    if (variant.study.elements == elements) return variant;
  return file.variants.front();
}

Source source_from_study(const MeshArguments& arguments, Console& console) {
  const StudyFile file = read_study_file(arguments.input);
  const Variant& variant = fitting_variant(file, asked_elements(arguments));
  if (file.variants.size() > 1)
    console.say("the study has several variants; this is " + variant.name);
  const Study& study = variant.study;
  Start start = study_start(study, InitialElements::triangles, console.monitor("initial mesh"));
  const bool own_metric = arguments.metric.empty() && arguments.size == 0;
  MetricField field =
      own_metric ? study_metric(study, start) : metric_on(start.mesh, arguments, console);
  return {std::move(start.domain), std::move(start.mesh), std::move(field), study_options(study)};
}

Source source_from_mesh(const MeshArguments& arguments, Console& console) {
  Source source;
  source.options = generate_options(Preset::best);
  source.background = usable_mesh(arguments.input, console.monitor("read"));
  source.field = metric_on(source.background, arguments, console);
  if (!arguments.domain.empty()) {
    source.domain = read_study_file(arguments.domain).variants.front().study.domain;
    if (source.domain.curves.empty())
      throw UsageError(arguments.domain + ": --domain needs a study with [domain] curves");
    attach_to_domain(source.background, source.domain);
    return source;
  }
  BoundaryDomainOptions options;
  options.corner_angle = arguments.corner_angle;
  options.shape = arguments.smooth ? BoundaryShape::smooth : BoundaryShape::linear;
  source.domain = domain_from_mesh(source.background, options);
  return source;
}

void say_times(const PhaseSeconds& s, const Counts& counts, double read, double write,
               Console& console) {
  const auto elements = static_cast<double>(counts.triangles + counts.quads);
  const char* unit = counts.quads == 0 ? "triangles/s" : "elements/s";
  std::vector<std::pair<const char*, double>> phases{
      {"read", read},           {"background", s.background},
      {"boundary", s.boundary}, {"front", s.front},
      {"enhance", s.enhance},   {"quads", s.quads},
      {"verify", s.verify},     {"write", write}};
  const auto say = [&](const char* name, double seconds) {
    console.detail(fmt::format("{:<11}{:9.3f} s {:12.0f} {}", name, seconds,
                               seconds > 0 ? elements / seconds : 0, unit));
  };
  double total = 0;
  for (const auto& [name, seconds] : phases) {
    total += seconds;
    if (seconds > 0) say(name, seconds);
  }
  say("total", total);
}

void say_quads(const QuadStatistics& s, Console& console) {
  console.detail(fmt::format(
      "quads: {} coarse triangles, {} left over by pairing, {} operations kept of {}, {} divisions",
      s.triangles, s.leftovers, s.operations, s.trials, s.levels));
}

void write_result(const MeshArguments& arguments, MeshFile file, const MetricField& metric) {
  if (arguments.write_metric) file.vertex_fields.push_back(metric_file_field(metric));
  if (fs::path(arguments.output).extension() == ".vtu") add_quality_fields(file, metric);
  write_mesh_file(arguments.output, file, gmsh_format(arguments.format));
}

/// As large meshes take their time; how often quadrilaterals are cleaned up cannot be foretold.
PhasePlan phases(const GenerateOptions& options) {
  if (options.elements == Elements::triangle)
    return {{{"front", 0, 0.3}, {"enhance", 0.3, 0.9}}, true};
  return {{{"front", 0, 0.05}, {"enhance", 0.05, 0.1}, {"quads", 0.1, 0.9}}, false};
}

void mesh(const MeshArguments& arguments, Console& console) {
  require_writable_mesh(arguments.output);
  Stopwatch watch;
  Source source = is_study(arguments.input) ? source_from_study(arguments, console)
                                            : source_from_mesh(arguments, console);
  apply_arguments(arguments, source.options);
  if (!is_study(arguments.input) && arguments.domain.empty())
    source.options.boundary.corner_angle = arguments.corner_angle;
  const double read = watch.lap();
  GenerateResult result =
      generate(source.domain, std::move(source.background), std::move(source.field), source.options,
               console.monitor("mesh", phases(source.options)));
  console.end_progress();
  watch.lap();
  const Counts counts = counts_of(result.mesh);
  write_result(arguments, {std::move(result.mesh), {}, {}}, result.metric);
  say_times(result.seconds, counts, read, watch.lap(), console);
  if (counts.quads > 0) say_quads(result.quads, console);
  console.say(fmt::format("wrote {}: {}", arguments.output, counts.text()));
}

}  // namespace

void add_mesh_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("mesh", "One mesh that fits a metric");
  auto arguments = std::make_shared<MeshArguments>();
  add_mesh_options(*command, *arguments);
  add_verbosity(*command, session.console);
  command->footer(
      "A study brings its domain and its prescribed metric. A mesh brings the boundary, whose "
      "references, corners and required vertices are kept, and NAME.mesh the metric in "
      "NAME.sol.\n\nExamples:\n"
      "  anisofront mesh floor.toml --size 0.05 -o floor.msh\n"
      "  anisofront mesh floor.msh --size 0.1 --quad --write-metric -o quads.mesh\n"
      "  anisofront mesh quads.mesh --metric quads.sol --gradation 1.3 -o triangles.mesh");
  command->callback([arguments, &session] { mesh(*arguments, session.console); });
}

}  // namespace anisofront
