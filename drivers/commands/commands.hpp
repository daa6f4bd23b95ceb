#pragma once

#include <CLI/CLI.hpp>

#include "drivers/base/console.hpp"

namespace anisofront {

/// The subcommands. Each adds itself with its options to the program; its callback does the work
/// and sets `exit_code` (left at 0 for success). Errors leave the callbacks as exceptions.
/// Precondition: console and exit_code outlive `app`.
void add_run_command(CLI::App& app, Console& console, int& exit_code);
void add_solve_command(CLI::App& app, Console& console);
void add_mesh_command(CLI::App& app, Console& console);
void add_check_command(CLI::App& app, Console& console, int& exit_code);
void add_convert_command(CLI::App& app, Console& console);
void add_metric_command(CLI::App& app, Console& console);
void add_report_command(CLI::App& app, Console& console);

}  // namespace anisofront
