#pragma once

#include <string>
#include <vector>

#include "drivers/commands/command_help.hpp"

namespace anisofront {

/// "anisofront-metric-explain": pages have no subfolders.
std::string man_page_name(const CommandHelp& command);

/// The page of section 1 in roff, man macros. `others`: names of pages to be seen also.
std::string man_page(const CommandHelp& command, const std::vector<std::string>& others);

struct ManPage {
  std::string file;  ///< "anisofront-run.1"
  std::string text;
};
/// The pages of the program and all its commands that are not hidden.
std::vector<ManPage> man_pages(const CommandHelp& program);

}  // namespace anisofront
