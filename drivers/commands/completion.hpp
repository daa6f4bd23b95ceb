#pragma once

#include <string>

#include "drivers/commands/command_help.hpp"

namespace anisofront {

/// A script for bash that completes the command: subcommands, options, words of options that must
/// be one of a list, names of files by suffix, folders. Needs bash 4 and nothing else.
std::string bash_completion(const CommandHelp& program);

/// The same for zsh, with the texts of --help: a file to be called _anisofront in the fpath.
std::string zsh_completion(const CommandHelp& program);

}  // namespace anisofront
