#pragma once

#include <string>
#include <vector>

namespace anisofront {

/// A word as a POSIX shell reads it back: as it is, or in single quotes where it must be.
std::string shell_quoted(const std::string& word);

/// The words of a command as one line to be typed again.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace anisofront
