#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

struct ConvertArguments {
  std::string input, output;
  OutputFormat format;
};

void convert(const ConvertArguments& arguments, Console& console) {
  require_writable_mesh(arguments.output);
  MeshFile file = read_mesh_file(arguments.input, console.monitor("read"));
  const fs::path beside = fs::path(arguments.input).replace_extension(".sol");
  if (fs::path(arguments.input).extension() == ".mesh" && fs::exists(beside)) {
    const auto vertices = static_cast<Index>(file.mesh.points.size());
    file.vertex_fields.push_back(metric_file_field(read_metric_file(beside, vertices)));
    console.say("metric from " + beside.string());
  }
  write_mesh_file(arguments.output, file, gmsh_format(arguments.format));
  console.say("wrote " + arguments.output);
}

}  // namespace

void add_convert_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "convert", "Meshes between .msh (2.2, 4.1, ASCII, binary), .mesh/.sol, .vtu and .svg");
  auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("IN", arguments->input, "Mesh to read (.msh, .mesh)")
      ->required()
      ->check(file_name({".msh", ".mesh"}));
  command->add_option("OUT", arguments->output, "Mesh to write (.msh, .mesh, .vtu, .svg)")
      ->required()
      ->check(file_name({".msh", ".mesh", ".vtu", ".svg"}));
  add_output_format(*command, arguments->format);
  add_verbosity(*command, session.console);
  command->footer(
      "Fields and references come along. The metric in NAME.sol is read with NAME.mesh.\n\n"
      "Examples:\n"
      "  anisofront convert floor.msh floor.vtu\n"
      "  anisofront convert quads.mesh quads.msh --format 2.2");
  command->callback([arguments, &session] { convert(*arguments, session.console); });
}

}  // namespace anisofront
