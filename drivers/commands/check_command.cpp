#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/commands/mesh_check.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

struct CheckArguments {
  std::string mesh, metric;
  bool json = false;
};

int check(const CheckArguments& arguments, Console& console) {
  const Mesh mesh = read_mesh_file(arguments.mesh, console.monitor("read")).mesh;
  MetricField metric;
  if (!arguments.metric.empty())
    metric = read_metric_file(arguments.metric, static_cast<Index>(mesh.points.size()));
  const MeshFindings findings = examine_mesh(arguments.mesh, mesh, metric);
  console.end_progress();
  if (arguments.json)
    console.print(findings_json(findings).dump(1, ' ', false, Json::error_handler_t::replace));
  else
    console.say(findings_text(findings));
  return findings.report.valid() ? 0 : static_cast<int>(ErrorKind::input);
}

}  // namespace

void add_check_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("check", "Validity, quality and edge lengths of any mesh");
  auto arguments = std::make_shared<CheckArguments>();
  command->add_option("MESH", arguments->mesh, "Mesh (.msh, .mesh)")
      ->required()
      ->check(file_name({".msh", ".mesh"}));
  command
      ->add_option("--metric", arguments->metric,
                   "Metric on the vertices of the mesh: .sol, or .msh with node data")
      ->type_name("FILE")
      ->check(file_name({".sol", ".msh"}));
  command->add_flag("--json", arguments->json, "JSON on stdout instead of text");
  add_verbosity(*command, session.console);
  command->footer(
      "Without a metric, shapes and angles are measured as they are; with one, in the metric, and "
      "the lengths of the edges too. The exit code is 4 when the mesh is not valid.\n\nExamples:\n"
      "  anisofront check quads.mesh --metric quads.sol\n"
      "  anisofront check floor.msh --json");
  command->callback(
      [arguments, &session] { session.exit_code = check(*arguments, session.console); });
}

}  // namespace anisofront
