#pragma once

#include <functional>
#include <optional>

#include "drivers/base/console.hpp"
#include "drivers/run/run_progress.hpp"
#include "drivers/run/run_state.hpp"

namespace anisofront {

/// A variant, what was found of it in the folder of the results, and what is to be run.
struct VariantJob {
  const Variant* variant = nullptr;
  std::filesystem::path folder;
  /// The earlier run when it is finished or gone on with; else only its key counts.
  EarlierRun earlier;
  std::optional<LoopInput> input;  ///< empty: finished earlier
};

/// What came out of one variant: finished cycles, and the error that ended it, if any.
struct Outcome {
  VariantHistory history;
  std::optional<ErrorKind> failure;
};

/// Runs a variant, or returns what an earlier run has found. Every cycle leaves its files and then
/// its record. `cancelled` is asked often: true ends the run. Errors end up in the outcome.
/// Precondition: unless it is finished, the variant is planned in `progress`.
Outcome run_variant(VariantJob job, const std::function<bool()>& cancelled, Console& console,
                    RunProgress& progress);

}  // namespace anisofront
