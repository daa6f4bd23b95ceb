#pragma once

#include <cstdio>
#include <string>

namespace anisofront::testing {

/// What a command line prints, both streams together.
inline std::string shell_output(const std::string& command_line) {
  std::string text;
  FILE* pipe = popen((command_line + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return "cannot run a shell";
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  pclose(pipe);
  return text;
}

/// Whether the PATH has this program.
inline bool is_installed(const std::string& program) {
  return !shell_output("command -v " + program).empty();
}

}  // namespace anisofront::testing
