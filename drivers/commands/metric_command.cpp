#include <charconv>
#include <memory>

#include "drivers/base/text.hpp"
#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/commands/metric_explanation.hpp"

namespace anisofront {
namespace {

struct ExplainArguments {
  std::string study, at, mesh, variant;
  std::vector<std::string> overrides;
};

/// "0.5,-2e-3".
Point point_of(const std::string& text) {
  Point p;
  const char* end = text.data() + text.size();
  const auto [comma, bad_x] = std::from_chars(text.data(), end, p.x);
  if (bad_x == std::errc() && comma != end && *comma == ',') {
    const auto [rest, bad_y] = std::from_chars(comma + 1, end, p.y);
    if (bad_y == std::errc() && rest == end && std::isfinite(p.x) && std::isfinite(p.y)) return p;
  }
  throw UsageError("--at " + text + ": expected the two coordinates of a point such as 0.5,0.25");
}

const Variant& named_variant(const StudyFile& study, const std::string& name, Console& console) {
  if (name.empty()) {
    if (study.variants.size() > 1)
      console.say("the study has several variants; this is " + study.variants.front().name +
                  " (--variant NAME takes another)");
    return study.variants.front();
  }
  std::vector<std::string> known;
  for (const Variant& variant : study.variants) {
    if (variant.name == name) return variant;
    known.push_back(variant.name);
  }
  throw UsageError("--variant " + name + ": no variant of " + study.path.string() +
                   " is called that" + name_proposal(name, known));
}

void explain(const ExplainArguments& arguments, Console& console) {
  const Point at = point_of(arguments.at);
  const StudyFile study = read_study_file(arguments.study, parse_overrides(arguments.overrides));
  const Variant& variant = named_variant(study, arguments.variant, console);
  const std::string text =
      explain_study_metric(variant, {at, arguments.mesh}, console.monitor(variant.name));
  console.end_progress();
  console.print(text);
}

void add_explain_command(CLI::App& metric, Session& session) {
  CLI::App* command =
      metric.add_subcommand("explain", "Which stage of its making set the sizes at a point");
  command->group("Commands");
  auto arguments = std::make_shared<ExplainArguments>();
  command->add_option("STUDY", arguments->study, "Study file (.toml)")
      ->required()
      ->check(file_name({".toml"}));
  command->add_option("--at", arguments->at, "The point")->required()->type_name("X,Y");
  command
      ->add_option("--mesh", arguments->mesh,
                   "A mesh of the same domain, such as cycle-3.msh of an earlier run (default: the "
                   "initial mesh)")
      ->type_name("FILE")
      ->check(file_name({".msh", ".mesh"}));
  command->add_option("--variant", arguments->variant, "Variant of the study (default: the first)")
      ->type_name("NAME");
  add_overrides(*command, arguments->overrides);
  add_verbosity(*command, session.console);
  command->footer(
      "Solves on the mesh, then says in words what set the two sizes of the metric there: the "
      "error, a layer, a limit or the gradation, or the entry of a prescribed list. The sizes "
      "after each stage follow.\n\nExamples:\n"
      "  anisofront metric explain floor.toml --at 0.02,0.5\n"
      "  anisofront metric explain layer.toml --at 1,0.5 --mesh layer-results/coarse/cycle-3.msh");
  command->callback([arguments, &session] { explain(*arguments, session.console); });
}

}  // namespace

void add_metric_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("metric", "Questions about the metric of a study");
  command->require_subcommand(1);
  add_verbosity(*command, session.console);
  add_explain_command(*command, session);
  command->footer("Example:\n  anisofront metric explain floor.toml --at 0.02,0.5");
}

}  // namespace anisofront
