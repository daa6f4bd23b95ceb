#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "drivers/base/console.hpp"

namespace anisofront {

/// What the subcommands share with the program around them.
struct Session {
  Console& console;
  std::string command_line;  ///< as typed, for a shell to read again
  int exit_code = 0;
};

/// The subcommands. Each adds itself with its options to the program; its callback does the work
/// and sets the exit code (left at 0 for success). Errors leave the callbacks as exceptions.
/// Precondition: the session outlives `app`.
void add_new_command(CLI::App& app, Session& session);
void add_run_command(CLI::App& app, Session& session);
void add_solve_command(CLI::App& app, Session& session);
void add_metric_command(CLI::App& app, Session& session);
void add_report_command(CLI::App& app, Console& console);
void add_mesh_command(CLI::App& app, Session& session);
void add_check_command(CLI::App& app, Session& session);
void add_convert_command(CLI::App& app, Session& session);
void add_help_command(CLI::App& app, Session& session);
void add_completion_command(CLI::App& app, Session& session);
void add_man_command(CLI::App& app, Session& session);

}  // namespace anisofront
