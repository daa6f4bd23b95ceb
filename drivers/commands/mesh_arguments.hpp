#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "drivers/commands/command_line.hpp"
#include "mesher/generate.hpp"

namespace anisofront {

/// What follows `anisofront mesh`; empty texts and zeros were not given.
struct MeshArguments {
  std::string input, metric, domain, output;
  double size = 0, corner_angle = 40, chord_height = 0, gradation = 0;
  std::string preset, elements, quad_method, quad_effort, quad_start;
  bool quad = false;
  bool smooth = false, write_metric = false;
  std::int64_t max_nodes = 5'000'000;
  OutputFormat format;
};

/// What --quad or --elements ask for, if one is given.
std::optional<Elements> asked_elements(const MeshArguments& arguments);

/// Adds the options to the command. Precondition: `arguments` outlives it.
void add_mesh_options(CLI::App& command, MeshArguments& arguments);

/// Changes options (defaults or those of a study) as the arguments say. Throws UsageError when the
/// arguments contradict each other.
void apply_arguments(const MeshArguments& arguments, GenerateOptions& options);

}  // namespace anisofront
