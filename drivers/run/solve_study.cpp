#include "drivers/run/solve_study.hpp"

#include <chrono>
#include <set>
#include <utility>

#include "drivers/base/text.hpp"
#include "drivers/problem/loop_input.hpp"
#include "drivers/run/solution_json.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// Wall-clock time: the solver uses several threads.
class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Work on variant `i` of so many. How long systems take cannot be foretold.
Monitor variant_monitor(const StudyFile& study, std::size_t i, Console& console) {
  const auto count = static_cast<double>(study.variants.size());
  PhasePlan plan{
      {{"front", 0, 0.1}, {"enhance", 0.1, 0.3}, {"quads", 0.1, 0.3}, {"linear system", 0.3, 0.9}}};
  for (Phase& phase : plan.phases) {
    phase.begin = (static_cast<double>(i) + phase.begin) / count;
    phase.end = (static_cast<double>(i) + phase.end) / count;
  }
  return console.monitor(count == 1 ? "solve" : study.variants[i].name, plan);
}

/// The monitor, keeping the warnings.
Monitor collecting(std::vector<std::string>& warnings, Monitor monitor, Console& console) {
  monitor.warn = [&warnings, &console](const std::string& message) {
    warnings.push_back(message);
    console.warn(message);
  };
  return monitor;
}

/// Elements of second order follow the curves of the domain.
bool has_curved_elements(const Study& study) {
  return study.plate ? study.plate->element == PlateElement::mitc : study.problem->order == 2;
}

FeMesh fe_mesh(const Study& study, const Start& start, const Monitor& monitor) {
  return has_curved_elements(study) ? curved_fe_mesh(start.mesh, start.domain, monitor)
                                    : straight_fe_mesh(start.mesh);
}

void write_meshes(const fs::path& folder, const SolutionRecord& record) {
  std::set<std::string> formats{"msh", "vtu"};
  for (const std::string& format : record.variant.study.output.formats) formats.insert(format);
  const MeshFile file{record.mesh.mesh, record.solved.vertex_fields, {}};
  for (const std::string& format : formats) write_mesh_file(folder / ("solution." + format), file);
}

/// solution.json vouches for the other files: it goes first and comes last.
void write_solution(const fs::path& folder, const SolutionRecord& record) {
  make_folder(folder);
  fs::remove(folder / "solution.json");
  write_meshes(folder, record);
  if (!record.samples.lines.empty()) make_folder(folder / "lines");
  for (const Profile& line : record.samples.lines)
    write_text_file(folder / "lines" / (line.name + ".csv"), table_csv(line.values));
  const Json json = solution_json(record);
  write_text_file(folder / "solution.json",
                  json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// What the solver says about the problem gets the line of the problem, unless it has one.
Solved solve_problem(const Study& study, const Domain& domain, const FeMesh& mesh,
                     const Monitor& monitor) {
  try {
    return study.plate ? solve_plate_study(study, domain, mesh, monitor)
                       : solve_scalar_study(study, domain, mesh, monitor);
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.starts_with(study.file.string())) throw;
    throw InputError((study.plate ? study.plate->place : study.problem->place) + ": " + message);
  }
}

void solve_variant(const Variant& variant, const fs::path& folder, const Monitor& progress,
                   Console& console) {
  const Study& study = variant.study;
  std::vector<std::string> warnings;
  const Monitor monitor = collecting(warnings, progress, console);
  Clock clock;
  SolveSeconds seconds;
  const Start start = study_start(study, InitialElements::as_in_study, monitor);
  const FeMesh mesh = fe_mesh(study, start, monitor);
  const SamplePoints points = locate_requests(study.output, start.domain, mesh);
  seconds.mesh = clock.lap();
  Solved solved = solve_problem(study, start.domain, mesh, monitor);
  Samples samples = sample(study.output, points, solved.state);
  const double rest = clock.lap();
  seconds.total = seconds.mesh + rest;
  seconds.fields =
      rest - solved.assembly_seconds - solved.linear.factor_seconds - solved.linear.solve_seconds;
  const SolutionRecord record{variant,  mesh,   std::move(solved), std::move(samples),
                              warnings, seconds};
  console.end_progress();
  write_solution(folder, record);
  console.say(solution_summary(record));
}

}  // namespace

void solve_study(const StudyFile& study, const fs::path& directory, Console& console) {
  const bool is_single = study.variants.size() == 1;
  for (std::size_t i = 0; i < study.variants.size(); ++i) {
    const Variant& variant = study.variants[i];
    if (variant.study.metric)
      throw UsageError(study.path.string() +
                       ": prescribes a [metric], there is no [problem] to solve; see `run`");
    try {
      solve_variant(variant, is_single ? directory : directory / variant.name,
                    variant_monitor(study, i, console), console);
    } catch (const Error& error) {
      if (is_single) throw;
      throw Error(error.kind(), variant.name + ": " + error.what());
    }
  }
  console.say("results in " + directory.string());
}

}  // namespace anisofront
