#pragma once

#include <CLI/CLI.hpp>

#include "drivers/commands/command_help.hpp"

namespace anisofront {

/// What the options, subcommands and footer of a command say. In the footer, lines that begin with
/// "  anisofront" are examples; the others are paragraphs, with an empty line between them.
CommandHelp describe(const CLI::App& app);

/// The command that the words name below `app`: {"metric", "explain"}. Throws UsageError for
/// unknown words, proposing the nearest.
const CLI::App& find_command(const CLI::App& app, const std::vector<std::string>& words);

/// "--metric" and "-o" of a command, names of its subcommands.
std::vector<std::string> known_words(const CLI::App& app);

/// "anisofront metric explain".
std::string full_name(const CLI::App& command);

}  // namespace anisofront
