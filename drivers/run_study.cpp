#include "drivers/run_study.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

#include <spdlog/fmt/fmt.h>

#include "adapt/loop.hpp"
#include "drivers/cycle_files.hpp"
#include "drivers/loop_input.hpp"
#include "drivers/report.hpp"
#include "drivers/summary.hpp"
#include "drivers/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// What came out of one variant: finished cycles, and the error that ended it, if any.
struct Outcome {
  VariantHistory history;
  std::optional<ErrorKind> failure;
};

/// Counts finished cycles of all variants for the progress bar.
struct Progress {
  std::atomic<int> finished{0};
  int total = 1;
  double fraction() const { return static_cast<double>(finished) / total; }
};

class VariantRun {
 public:
  VariantRun(const Variant& variant, const RunOptions& options, Console& console,
             Progress& progress)
      : variant_(variant), options_(options), console_(console), progress_(progress) {}

  Outcome run(LoopInput input) {
    outcome_.history.name = variant_.name;
    outcome_.history.settings = variant_settings(variant_);
    input.finished = [this](const CycleRecord& record, const Mesh& mesh, const Analysis& analysis) {
      finish_cycle(record, mesh, analysis);
    };
    try {
      const VariantHistory history = adapt_loop(input, monitor());
      outcome_.history.stop_reason = history.stop_reason;
      outcome_.history.target = history.target;
    } catch (const Error& error) {
      fail(error.kind(), error.what());
    } catch (const std::bad_alloc&) {
      fail(ErrorKind::budget, "out of memory");
    } catch (const std::exception& error) {
      fail(ErrorKind::failed, error.what());
    }
    return std::move(outcome_);
  }

 private:
  void fail(ErrorKind kind, const std::string& message) {
    outcome_.failure = kind;
    outcome_.history.stop_reason =
        kind == ErrorKind::interrupted ? "interrupted" : "failed: " + message;
    if (kind != ErrorKind::interrupted) console_.error(variant_.name + ": " + message);
  }

  void finish_cycle(const CycleRecord& record, const Mesh& mesh, const Analysis& analysis) {
    CycleRecord kept = record;
    for (const std::string& warning : warnings_)
      if (std::find(kept.warnings.begin(), kept.warnings.end(), warning) == kept.warnings.end())
        kept.warnings.push_back(warning);
    warnings_.clear();
    write_cycle(options_.directory / variant_.name, variant_.study.output.formats, record.cycle,
                mesh, analysis);
    outcome_.history.cycles.push_back(std::move(kept));
    ++progress_.finished;
    console_.detail(fmt::format("{}: cycle {}: {} vertices, {} elements", variant_.name,
                                record.cycle, record.background.vertices,
                                record.background.elements));
  }

  Monitor monitor() {
    Monitor monitor;
    monitor.warn = [this](const std::string& message) {
      warnings_.push_back(message);
      console_.warn(variant_.name + ": " + message);
    };
    monitor.progress = [this](std::string_view phase, double) {
      console_.progress(fmt::format("{} cycle {}/{} {}", variant_.name,
                                    outcome_.history.cycles.size(), variant_.study.cycles, phase),
                        progress_.fraction());
      return !options_.cancelled();
    };
    return monitor;
  }

  const Variant& variant_;
  const RunOptions& options_;
  Console& console_;
  Progress& progress_;
  Outcome outcome_;
  std::vector<std::string> warnings_;  ///< since the last finished cycle
};

std::vector<LoopInput> prepare(const StudyFile& study, Console& console) {
  std::vector<LoopInput> inputs;
  for (const Variant& variant : study.variants)
    inputs.push_back(loop_input(variant.study, console.monitor(variant.name)));
  return inputs;
}

std::vector<Outcome> run_variants(const StudyFile& study, std::vector<LoopInput> inputs,
                                  const RunOptions& options, Console& console) {
  std::vector<Outcome> outcomes(inputs.size());
  Progress progress;
  progress.total = 0;
  for (const LoopInput& input : inputs) progress.total += input.cycles + 1;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < inputs.size(); i = next++)
      outcomes[i] =
          VariantRun(study.variants[i], options, console, progress).run(std::move(inputs[i]));
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < options.threads; ++i) helpers.emplace_back(work);
  work();
  helpers.clear();
  console.end_progress();
  return outcomes;
}

int exit_code(const std::vector<Outcome>& outcomes) {
  int code = 0;
  for (const Outcome& outcome : outcomes) {
    if (outcome.failure == ErrorKind::interrupted) return static_cast<int>(ErrorKind::interrupted);
    if (outcome.failure && code <= 1) code = static_cast<int>(*outcome.failure);
    if (outcome.history.target == TargetState::missed && code == 0) code = 1;
  }
  return code;
}

void write_results(const StudyFile& study, const std::vector<Outcome>& outcomes,
                   const fs::path& directory, Console& console) {
  std::vector<VariantHistory> variants;
  bool has_cycles = false;
  for (const Outcome& outcome : outcomes) {
    variants.push_back(outcome.history);
    has_cycles = has_cycles || !outcome.history.cycles.empty();
  }
  if (!has_cycles) return;
  const Json history = history_json(study.title, variants);
  write_text_file(directory / "study.toml", study.resolved);
  write_text_file(directory / "history.json",
                  history.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  write_text_file(directory / "history.csv", history_csv(history));
  for (const std::string& problem : make_report(directory)) console.warn(problem);
  console.say(as_text(summary_table(history)));
  console.say("results in " + directory.string() +
              ", page: " + (directory / "report.html").string());
}

}  // namespace

int run_study(const StudyFile& study, const RunOptions& options, Console& console) {
  std::vector<LoopInput> inputs = prepare(study, console);
  const std::vector<Outcome> outcomes = run_variants(study, std::move(inputs), options, console);
  write_results(study, outcomes, options.directory, console);
  const int code = exit_code(outcomes);
  if (code == 1) console.warn("the target error was missed; see stop_reason in history.json");
  if (code == 130) console.warn("interrupted; finished cycles are kept");
  return code;
}

}  // namespace anisofront
