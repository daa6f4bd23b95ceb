#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "drivers/base/console.hpp"
#include "mesher/io/gmsh.hpp"

namespace anisofront {

/// Help texts of a program and of the subcommands added from now on (see help_text()), as wide as
/// the terminal, at most 100 columns.
void set_help_style(CLI::App& app);

/// The help of just this command, whatever was parsed.
std::string help_of(const CLI::App& command);

/// Adds what every command has: -q, -v and --log-format.
void add_verbosity(CLI::App& command, Console& console);

/// Adds --set key=value, any number of times.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

/// Options of mesh files to be written.
struct OutputFormat {
  std::string version = "4.1";
  bool binary = false;
};
/// Adds --format and --binary.
void add_output_format(CLI::App& command, OutputFormat& format);
GmshFormat gmsh_format(const OutputFormat& format);

/// Refuses other words than those of the list and proposes the nearest one.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Accepts everything, and tells the shell which files to propose.
CLI::Validator file_name(const std::vector<std::string>& suffixes);

/// Refuses, before any work is done, names that write_mesh_file() would refuse afterwards. Throws
/// UsageError for other suffixes than .msh .mesh .vtu .svg and for missing folders.
void require_writable_mesh(const std::filesystem::path& path);

}  // namespace anisofront
