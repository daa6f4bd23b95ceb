#pragma once

#include <filesystem>
#include <functional>

#include "drivers/console.hpp"
#include "drivers/history_json.hpp"
#include "drivers/interrupt.hpp"
#include "drivers/study_file.hpp"

namespace anisofront {

struct RunOptions {
  std::filesystem::path directory;
  /// Variants computed side by side. The results do not depend on it.
  int threads = 1;
  /// Asked often, from every thread: true ends the run and keeps the finished cycles.
  std::function<bool()> cancelled = InterruptGuard::requested;
};

/// All variants, all cycles; files, figures and report in the directory (DESIGN.md, section 6); the
/// summary on the console. Returns the exit code of the program: 130 when cancelled, else that of
/// the first variant that failed, else 1 when a target was missed, else 0. A variant that fails
/// does not stop the others.
/// Throws UsageError and InputError for mistakes that show before the first cycle.
int run_study(const StudyFile& study, const RunOptions& options, Console& console);

}  // namespace anisofront
