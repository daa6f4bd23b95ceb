#include "drivers/commands/mesh_arguments.hpp"

#include <utility>

#include "drivers/study/element_names.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

void refuse_contradictions(const MeshArguments& a, Elements elements) {
  if (a.quad && elements != Elements::quadrilateral)
    throw UsageError("--quad asks for quadrilaterals and --elements for " + a.elements +
                     "; give one of them");
  if (elements != Elements::triangle) return;
  const std::pair<const char*, const std::string&> options[] = {{"--quad-method", a.quad_method},
                                                                {"--quad-effort", a.quad_effort},
                                                                {"--quad-start", a.quad_start}};
  for (const auto& [name, value] : options)
    if (!value.empty())
      throw UsageError(std::string(name) + " " + value +
                       " says how to make quadrilaterals, but triangles are made; add --quad");
}

void apply_elements(const MeshArguments& arguments, GenerateOptions& options) {
  const auto set = [](const auto& names, const std::string& word, auto& value) {
    if (!word.empty()) value = value_named(names, word);
  };
  options.elements = asked_elements(arguments).value_or(options.elements);
  refuse_contradictions(arguments, options.elements);
  set(kQuadMethodNames, arguments.quad_method, options.quads.method);
  set(kQuadEffortNames, arguments.quad_effort, options.quads.effort);
  set(kQuadStartNames, arguments.quad_start, options.quads.start);
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

void add_element_options(CLI::App& command, MeshArguments& a) {
  const std::string group = "Elements";
  command.add_flag("--quad", a.quad, "Quadrilaterals only: short for --elements quadrilateral")
      ->group(group);
  command
      .add_option("--elements", a.elements,
                  "What the mesh consists of (default: triangle); mixed: triangles stay where no "
                  "good quadrilateral can be made of them")
      ->check(one_of(names_of(kElementNames)))
      ->type_name("WORD")
      ->group(group);
  command
      .add_option("--quad-method", a.quad_method,
                  "best: coarse frame, clean-up, division, clean-up; paper: merging and division "
                  "as published (default: that of --preset)")
      ->check(one_of(names_of(kQuadMethodNames)))
      ->type_name("WORD")
      ->group(group);
  command
      .add_option("--quad-effort", a.quad_effort,
                  "fast: several times the speed, a little less quality (default: best)")
      ->check(one_of(names_of(kQuadEffortNames)))
      ->type_name("WORD")
      ->group(group);
  command
      .add_option("--quad-start", a.quad_start,
                  "What the first quadrilaterals are made from; automatic tries several")
      ->check(one_of(names_of(kQuadStartNames)))
      ->type_name("WORD")
      ->group(group);
}

void add_metric_options(CLI::App& command, MeshArguments& a) {
  const std::string group = "Metric";
  auto* metric = command
                     .add_option("--metric", a.metric,
                                 "Metric on the vertices of INPUT: .sol, or .msh with node data "
                                 "(default for NAME.mesh: NAME.sol)")
                     ->type_name("FILE")
                     ->check(file_name({".sol", ".msh"}))
                     ->group(group);
  command.add_option("--size", a.size, "The same size everywhere instead")
      ->check(positive_number())
      ->excludes(metric)
      ->type_name("H")
      ->group(group);
  command.add_option("--gradation", a.gradation, "Largest growth of sizes per element, e.g. 1.5")
      ->check(CLI::Range(1.0001, 1e6))
      ->type_name("RATIO")
      ->group(group);
  command
      .add_option("--max-nodes,--max-elements", a.max_nodes,
                  "Refuse a metric that asks for more elements")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{2'000'000'000}))
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
}

void add_boundary_options(CLI::App& command, MeshArguments& a) {
  const std::string group = "Boundary";
  command.add_option("--domain", a.domain, "Study whose curves replace the boundary of INPUT")
      ->type_name("STUDY")
      ->check(file_name({".toml"}))
      ->group(group);
  command
      .add_option("--corner-angle", a.corner_angle,
                  "Boundary vertices that turn by more degrees are corners")
      ->check(CLI::Range(0., 180.))
      ->type_name("DEGREES")
      ->capture_default_str()
      ->group(group);
  command.add_flag("--smooth", a.smooth, "Smooth curves through the boundary between corners")
      ->group(group);
  command
      .add_option("--chord-height", a.chord_height, "Largest distance of an edge from its curve")
      ->check(positive_number())
      ->type_name("H")
      ->group(group);
}

void add_output_options(CLI::App& command, MeshArguments& a) {
  const std::string group = "Output";
  command.add_option("-o,--output", a.output, "Mesh to write (.msh, .mesh, .vtu, .svg)")
      ->required()
      ->type_name("OUT")
      ->check(file_name({".msh", ".mesh", ".vtu", ".svg"}))
      ->group(group);
  command
      .add_flag("--write-metric", a.write_metric,
                "Write the metric too: OUT.sol beside a .mesh, node data in a .msh")
      ->group(group);
  add_output_format(command, a.format);
}

}  // namespace

std::optional<Elements> asked_elements(const MeshArguments& arguments) {
  if (!arguments.elements.empty()) return value_named(kElementNames, arguments.elements);
  if (arguments.quad) return Elements::quadrilateral;
  return {};
}

void add_mesh_options(CLI::App& command, MeshArguments& a) {
  command.add_option("INPUT", a.input, "Study (.toml) or mesh (.msh, .mesh)")
      ->required()
      ->check(file_name({".toml", ".msh", ".mesh"}));
  add_output_options(command, a);
  add_metric_options(command, a);
  add_element_options(command, a);
  add_boundary_options(command, a);
  command
      .add_option("--preset", a.preset,
                  "paper: every stage as published (default: that of the study, or best)")
      ->check(one_of({"best", "paper"}))
      ->type_name("WORD")
      ->group("Elements");
}

void apply_arguments(const MeshArguments& arguments, GenerateOptions& options) {
  if (!arguments.preset.empty()) {
    const GenerateOptions before = options;
    options = generate_options(arguments.preset == "paper" ? Preset::paper : Preset::best);
    options.boundary.chord_height = before.boundary.chord_height;
    options.gradation = before.gradation;
    options.elements = before.elements;
    options.quads.effort = before.quads.effort;
    options.quads.start = before.quads.start;
  }
  apply_elements(arguments, options);
  if (arguments.chord_height > 0) options.boundary.chord_height = arguments.chord_height;
  if (arguments.gradation > 1) options.gradation = arguments.gradation;
  options.max_elements = arguments.max_nodes;
}

}  // namespace anisofront
