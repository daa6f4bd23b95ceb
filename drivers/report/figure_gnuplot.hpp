#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anisofront {

/// Runs gnuplot on STEM.gp of each stem, in the folder where these are: all in one process, and
/// after a script that fails the rest in another, up to three failures. Returns what went wrong,
/// one sentence each: nothing when all is drawn; one sentence when there is no gnuplot.
std::vector<std::string> run_gnuplot(const std::filesystem::path& folder,
                                     const std::vector<std::string>& stems);

}  // namespace anisofront
