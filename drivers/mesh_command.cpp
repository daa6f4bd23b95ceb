#include <memory>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "drivers/command_line.hpp"
#include "drivers/commands.hpp"
#include "drivers/loop_input.hpp"
#include "drivers/prescribed_metric.hpp"
#include "drivers/study_file.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

struct MeshArguments {
  std::string input, metric, domain, output;
  double size = 0, corner_angle = 40, chord_height = 0, gradation = 0;
  std::string preset;
  bool smooth = false, write_metric = false;
  std::int64_t max_nodes = 5'000'000;
  OutputFormat format;
};

/// What generate() takes.
struct Source {
  Domain domain;
  Mesh background;
  MetricField field;
  GenerateOptions options;
};

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
    throw UsageError(study.file.string() +
                     ": has no [metric]; give --metric or --size, or solve it with `run`");
  const MetricFunction metric = prescribed_metric(*study.metric, start.domain, study.limits);
  MetricField field;
  for (const Point p : start.mesh.points) field.push_back(metric(p));
  return field;
}

Source source_from_study(const MeshArguments& arguments, Console& console) {
  const StudyFile file = read_study_file(arguments.input);
  if (file.variants.size() > 1)
    console.say("the study has several variants; this is " + file.variants.front().name);
  const Study& study = file.variants.front().study;
  Start start = study_start(study, console.monitor("initial mesh"));
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

void apply_arguments(const MeshArguments& arguments, GenerateOptions& options) {
  if (!arguments.preset.empty()) {
    const GenerateOptions before = options;
    options = generate_options(arguments.preset == "paper" ? Preset::paper : Preset::best);
    options.boundary.chord_height = before.boundary.chord_height;
    options.gradation = before.gradation;
  }
  if (arguments.chord_height > 0) options.boundary.chord_height = arguments.chord_height;
  if (arguments.gradation > 1) options.gradation = arguments.gradation;
  options.max_elements = arguments.max_nodes;
}

void say_times(const GenerateResult& result, std::size_t count, double read, double write,
               Console& console) {
  const auto triangles = static_cast<double>(count);
  const PhaseSeconds& s = result.seconds;
  const std::pair<const char*, double> phases[] = {
      {"read", read},     {"background", s.background}, {"boundary", s.boundary},
      {"front", s.front}, {"enhance", s.enhance},       {"verify", s.verify},
      {"write", write}};
  double total = 0;
  for (const auto& [name, seconds] : phases) {
    console.detail(fmt::format("{:<11}{:9.3f} s {:12.0f} triangles/s", name, seconds,
                               seconds > 0 ? triangles / seconds : 0));
    total += seconds;
  }
  console.detail(fmt::format("{:<11}{:9.3f} s {:12.0f} triangles/s", "total", total,
                             total > 0 ? triangles / total : 0));
}

void write_result(const MeshArguments& arguments, MeshFile file, const MetricField& metric) {
  if (arguments.write_metric) file.vertex_fields.push_back(metric_file_field(metric));
  write_mesh_file(arguments.output, file, gmsh_format(arguments.format));
}

void mesh(const MeshArguments& arguments, Console& console) {
  require_writable_mesh(arguments.output);
  Stopwatch watch;
  Source source = is_study(arguments.input) ? source_from_study(arguments, console)
                                            : source_from_mesh(arguments, console);
  apply_arguments(arguments, source.options);
  const double read = watch.lap();
  GenerateResult result =
      generate(source.domain, std::move(source.background), std::move(source.field), source.options,
               console.monitor("mesh"));
  console.end_progress();
  watch.lap();
  const std::size_t vertices = result.mesh.points.size(), triangles = result.mesh.triangles.size();
  write_result(arguments, {std::move(result.mesh), {}, {}}, result.metric);
  say_times(result, triangles, read, watch.lap(), console);
  console.say(
      fmt::format("wrote {}: {} vertices, {} triangles", arguments.output, vertices, triangles));
}

CLI::Validator positive_number() {
  const auto complaint = [](const std::string& text) {
    double value = 0;
    return CLI::detail::lexical_cast(text, value) && value > 0
               ? std::string()
               : "expected a positive number, found " + text;
  };
  return {complaint, "POSITIVE"};
}

void add_options(CLI::App& command, MeshArguments& a) {
  command.add_option("INPUT", a.input, "Study (.toml), .msh or .mesh")->required();
  auto* metric = command.add_option("--metric", a.metric,
                                    "Metric on the vertices of INPUT: .sol, or .msh with node data"
                                    " (default for NAME.mesh: NAME.sol)");
  command.add_option("--size", a.size, "The same size everywhere instead")
      ->check(positive_number())
      ->excludes(metric);
  command.add_option("--domain", a.domain, "Study whose curves replace the boundary of INPUT");
  command.add_option("-o,--output", a.output, "Mesh to write (.msh, .mesh, .vtu, .svg)")
      ->required();
  command.add_option("--preset", a.preset, "best (default) or paper")
      ->check(CLI::IsMember({"best", "paper"}));
  command
      .add_option("--corner-angle", a.corner_angle,
                  "Boundary vertices that turn by more degrees are corners")
      ->check(CLI::Range(0., 180.))
      ->capture_default_str();
  command.add_flag("--smooth", a.smooth, "Smooth curves through the boundary between corners");
  command
      .add_option("--chord-height", a.chord_height, "Largest distance of an edge from its curve")
      ->check(positive_number());
  command.add_option("--gradation", a.gradation, "Largest growth of sizes per element, e.g. 1.5")
      ->check(CLI::Range(1.0001, 1e6));
  command
      .add_option("--max-nodes,--max-elements", a.max_nodes,
                  "Refuse a metric that asks for more elements")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{2'000'000'000}))
      ->capture_default_str();
  command.add_flag("--write-metric", a.write_metric,
                   "Write the metric too: OUT.sol beside a .mesh, node data in a .msh");
}

}  // namespace

void add_mesh_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("mesh", "One mesh that fits a metric");
  auto arguments = std::make_shared<MeshArguments>();
  add_options(*command, *arguments);
  add_output_format(*command, arguments->format);
  add_verbosity(*command, console);
  command->footer(
      "References, corners and required vertices of INPUT are kept.\nExample:\n"
      "  anisofront mesh in.mesh --metric in.sol -o out.mesh");
  command->callback([arguments, &console] { mesh(*arguments, console); });
}

}  // namespace anisofront
