#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anisofront {

inline constexpr int kProgramNotFound = 127;

struct ProgramRun {
  int status = 0;        ///< kProgramNotFound when there is no such program
  std::string messages;  ///< its standard error, at most the first 64 KiB
};

/// Runs a program of the PATH in a folder, without a shell, with nothing on its standard input and
/// its standard output thrown away, and waits for it.
ProgramRun run_program_in(const std::filesystem::path& folder,
                          const std::vector<std::string>& words);

/// run_program_in() for each of the commands, as many at a time as the machine has cores (four at
/// most); results in the order of the commands.
std::vector<ProgramRun> run_programs_in(const std::filesystem::path& folder,
                                        const std::vector<std::vector<std::string>>& commands);

}  // namespace anisofront
