#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "drivers/base/console.hpp"
#include "drivers/base/interrupt.hpp"
#include "drivers/study/study_file.hpp"

namespace anisofront {

/// What becomes of the results that an earlier run has left in the same folder. Results made with
/// other settings (see variant_key()) are never used.
enum class EarlierResults {
  keep_finished,  ///< finished variants are not run again, others start anew
  resume,         ///< the same, and unfinished variants go on after their last complete cycle
  ignore          ///< everything is run anew
};

struct RunOptions {
  std::filesystem::path directory;
  EarlierResults earlier = EarlierResults::keep_finished;
  /// Variants computed side by side. The results do not depend on it.
  int threads = 1;
  std::string command;  ///< what the user typed, for run.json; empty: not known
  /// Asked often, from every thread: true ends the run and keeps the finished cycles.
  std::function<bool()> cancelled = InterruptGuard::requested;
};

/// All variants, all cycles; files, figures, report and run.json in the directory (DESIGN.md,
/// section 6); the summary on the console. Returns the exit code of the program: 130 when
/// cancelled, else that of the first variant that failed, else 5 when a budget ended a variant,
/// else 1 when a target was missed, else 0. A variant that fails does not stop the others. Throws
/// UsageError and InputError for mistakes that show before the first cycle.
int run_study(const StudyFile& study, const RunOptions& options, Console& console);

}  // namespace anisofront
