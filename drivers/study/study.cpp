#include "drivers/study/study.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/study/element_names.hpp"
#include "drivers/study/paper_table.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// Paths in a study are relative to it.
fs::path beside(const fs::path& study, const std::string& name) {
  return (study.parent_path() / name).lexically_normal();
}

void read_domain(TomlTable& root, Study& study) {
  auto table = root.required(root.table("domain"), "domain");
  const auto mesh = table.text("mesh");
  if (!mesh) {
    study.domain = parse_domain(table);
    return;
  }
  study.domain_mesh = beside(study.file, *mesh);
  study.domain_options.corner_angle =
      table.positive("corner_angle").value_or(study.domain_options.corner_angle);
  const std::string shape = table.choice("boundary", {"linear", "smooth"}, "linear");
  study.domain_options.shape = shape == "smooth" ? BoundaryShape::smooth : BoundaryShape::linear;
  table.finish();
}

/// One of the words of a table; `fallback` when the key is absent.
template <class Value, std::size_t N>
Value read_named(TomlTable& table, const std::string& key, const std::array<Named<Value>, N>& names,
                 Value fallback) {
  return value_named(names, table.choice(key, names_of(names), name_of(names, fallback)));
}

void read_elements(TomlTable& table, Study& study) {
  study.elements = read_named(table, "elements", kElementNames, Elements::triangle);
  const QuadOptions preset = generate_options(study.preset).quads;
  study.quads.method = read_named(table, "quad_method", kQuadMethodNames, preset.method);
  study.quads.effort = read_named(table, "quad_effort", kQuadEffortNames, preset.effort);
  study.quads.start = read_named(table, "quad_start", kQuadStartNames, preset.start);
}

Interpolation interpolation_named(const std::string& name) {
  if (name == "simultaneous-reduction") return Interpolation::simultaneous_reduction;
  return name == "log-euclidean" ? Interpolation::log_euclidean : Interpolation::linear_size;
}

/// Each preset has its own default interpolation.
std::string default_interpolation(Preset preset) {
  return preset == Preset::paper ? "simultaneous-reduction" : "linear-size";
}

void read_initial(TomlTable& table, Study& study) {
  const auto file = table.text("initial");
  const auto size = table.positive("initial_size");
  if (file && size) table.fail("initial_size", "give either initial or initial_size, not both");
  if (file) study.initial.file = beside(study.file, *file);
  if (size) study.initial.size = *size;
  if (!file && !size) study.initial.file = study.domain_mesh;
}

void read_mesh(TomlTable& root, Study& study) {
  static const toml::table kEmpty;
  TomlTable table = root.table("mesh").value_or(TomlTable(kEmpty, "mesh", study.file.string()));
  read_initial(table, study);
  study.preset =
      table.choice("preset", {"best", "paper"}, "best") == "paper" ? Preset::paper : Preset::best;
  read_elements(table, study);
  study.interpolation = interpolation_named(
      table.choice("interpolation", {"linear-size", "simultaneous-reduction", "log-euclidean"},
                   default_interpolation(study.preset)));
  study.chord_height = table.positive("chord_height").value_or(0);
  study.max_elements = table.integer("max_nodes").value_or(5'000'000);
  table.finish();
  if (study.initial.file.empty() && study.initial.size == 0)
    table.fail({}, "needs an initial mesh: initial = \"FILE\" or initial_size = SIZE");
}

void read_problem(TomlTable& root, Study& study) {
  auto table = root.table("problem");
  if (!table) return;
  if (table->choice("kind", {"poisson", "mindlin"}, "poisson") == "mindlin")
    study.plate = parse_plate_problem(*table);
  else
    study.problem = parse_scalar_problem(*table);
}

void read_solver(TomlTable& root, Study& study) {
  if (auto table = root.table("solver")) study.solver = parse_solver(*table);
  const LinearMethod method = study.solver.method;
  const bool has_convection = study.problem && study.problem->has_convection();
  if (method == LinearMethod::multigrid && study.plate)
    root.table("solver")->fail("method", "multigrid is for kind = \"poisson\" only");
  if (has_convection && method != LinearMethod::automatic && method != LinearMethod::general)
    root.table("solver")->fail(
        "method", "a velocity makes the system unsymmetric; write \"general\" or \"automatic\"");
}

/// The row that fits the study: a name, or a table by mode or elements whose entries are the same
/// again. Every entry is read, so that mistakes in those not used are found too.
std::string fitting_row(TomlTable& table, const std::string& key, const Study& study) {
  if (!table.is_table(key)) {
    const std::string name = table.text(key).value_or("");
    if (!name.empty() && paper_row(name) == nullptr)
      table.fail(key, fmt::format("the paper has no row \"{}\"; known: {}", name,
                                  joined(paper_row_names())));
    return name;
  }
  TomlTable rows = *table.table(key);
  const std::pair<const char*, bool> entries[] = {
      {"isotropic", study.adapt.mode == AdaptMode::isotropic},
      {"anisotropic", study.adapt.mode == AdaptMode::anisotropic},
      {"triangle", study.elements == Elements::triangle},
      {"quadrilateral", study.elements == Elements::quadrilateral}};
  std::string fitting;
  for (const auto& [word, fits] : entries) {
    const std::string row = fitting_row(rows, word, study);
    if (fits && !row.empty()) fitting = row;
  }
  rows.finish();
  return fitting;
}

/// [report] paper = "12b", or paper = { isotropic = { triangle = "13b", ... }, ... }. A row of
/// triangles does not stand beside quadrilaterals.
void read_report(TomlTable& root, Study& study) {
  auto table = root.table("report");
  if (!table) return;
  const PaperRow* row = paper_row(fitting_row(*table, "paper", study));
  const Elements elements =
      row != nullptr && has_quads(*row) ? Elements::quadrilateral : Elements::triangle;
  if (row != nullptr && elements == study.elements) study.paper_row = row->name;
  table->finish();
}

/// With an initial mesh from a file the solver says it.
void check_plate_element(TomlTable& root, const Study& study) {
  if (!study.plate || !study.initial.file.empty()) return;
  const PlateElement element = study.plate->element;
  if (element == PlateElement::mitc4 && study.elements != Elements::quadrilateral)
    root.table("problem")->fail(
        "element", "mitc4 is for quadrilaterals; write mesh.elements = \"quadrilateral\"");
  if (element == PlateElement::arnold_falk && study.elements != Elements::triangle)
    root.table("problem")->fail("element",
                                "arnold-falk is for triangles; write mesh.elements = \"triangle\"");
}

/// What a prescribed metric decides itself.
void check_prescribed(TomlTable& adapt, const Study& study, bool has_problem) {
  if (study.adapt.target.vertices || study.adapt.target.error)
    adapt.fail("target",
               "a prescribed [metric] says itself how fine the mesh is; leave target out");
  if (has_problem) return;
  for (const std::string& key : keys_for_problems())
    if (adapt.has(key)) adapt.fail(key, "is about the error of a [problem], and there is none");
}

void check_adapt(TomlTable& root, const Study& study, bool has_problem) {
  auto adapt = root.table("adapt");
  if (!adapt) return;
  if (study.metric) check_prescribed(*adapt, study, has_problem);
  if (study.adapt.reference && study.problem && !study.problem->exact.empty())
    adapt->fail("reference", "the exact solution is known; leave one of reference and exact out");
  if (study.adapt.goal && study.problem && study.problem->has_convection())
    adapt->fail("goal", "errors of goals are estimated for problems without velocity only");
}

void check_purpose(TomlTable& root, const Study& study) {
  const bool has_problem = study.problem || study.plate;
  if (!study.metric && !has_problem)
    root.fail({}, "a study needs a [metric] table (prescribed sizes) or a [problem] table");
  check_adapt(root, study, has_problem);
}

}  // namespace

Study parse_study(const toml::table& table, const fs::path& file) {
  TomlTable root(table, {}, file.string());
  Study study;
  study.file = file;
  study.title = root.text("title").value_or(file.stem().string());
  read_domain(root, study);
  read_mesh(root, study);
  if (auto adapt = root.table("adapt")) study.adapt = parse_adapt(*adapt);
  if (auto metric = root.table("metric")) study.metric = parse_metric(*metric, study.adapt.mode);
  read_problem(root, study);
  read_solver(root, study);
  if (auto output = root.table("output")) study.output = parse_output(*output);
  read_report(root, study);
  root.has("vary");
  root.finish();
  check_purpose(root, study);
  check_plate_element(root, study);
  return study;
}

}  // namespace anisofront
