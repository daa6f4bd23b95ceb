#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anisofront {

inline constexpr int kProgramNotFound = 127;

/// Runs a program of the PATH in a folder, without a shell and with its output thrown away, and
/// waits for it. Returns its exit status; kProgramNotFound when there is no such program.
int run_program_in(const std::filesystem::path& folder, const std::vector<std::string>& words);

}  // namespace anisofront
