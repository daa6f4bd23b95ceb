#pragma once

#include <chrono>
#include <string>

#include "drivers/base/json.hpp"

namespace anisofront {

/// When, how and how long a study was run.
struct RunFacts {
  std::string command;  ///< as the user gave it; empty: not known
  std::chrono::system_clock::time_point started;
  double seconds = 0;  ///< wall-clock time
  int threads = 1;     ///< variants side by side
  int exit_code = 0;
};

/// run.json: {"program", "version", "command" (or null), "date" (of the start, UTC,
/// "2026-11-22T08:15:00Z"), "seconds", "threads", "exit_code"}.
Json run_json(const RunFacts& facts);

}  // namespace anisofront
