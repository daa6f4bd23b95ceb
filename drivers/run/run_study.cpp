#include "drivers/run/run_study.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "drivers/base/terminal.hpp"
#include "drivers/base/text.hpp"
#include "drivers/history/history_csv.hpp"
#include "drivers/problem/loop_input.hpp"
#include "drivers/report/report.hpp"
#include "drivers/report/terminal_summary.hpp"
#include "drivers/run/line_files.hpp"
#include "drivers/run/run_json.hpp"
#include "drivers/run/variant_run.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

using State = EarlierRun::State;

/// Files have lines as long as need be.
constexpr int kNoTerminal = 1000;

std::size_t cycle_count(const EarlierRun& earlier) { return earlier.record.history.cycles.size(); }

/// What is done with the earlier results, in words; empty when there are none.
std::string what_happens(const EarlierRun& earlier, EarlierResults use) {
  if (earlier.state == State::finished)
    return "finished by an earlier run with the same settings; --fresh runs it again";
  if (earlier.state == State::other_settings)
    return "the results in the folder have other settings; runs anew";
  if (earlier.state == State::none) return {};
  const std::size_t last = cycle_count(earlier) - 1;
  if (use == EarlierResults::resume) return fmt::format("goes on after cycle {}", last);
  return fmt::format("an earlier run was not finished; runs anew (--resume goes on after cycle {})",
                     last);
}

/// Texts, and the variants that each is about.
using Notes = std::vector<std::pair<std::string, std::vector<std::string>>>;

void add_note(const std::string& text, const std::string& variant, Notes& notes) {
  if (text.empty()) return;
  for (auto& [known, variants] : notes)
    if (known == text) return variants.push_back(variant);
  notes.push_back({text, {variant}});
}

/// A line per variant, or one for many.
void say_notes(const Notes& notes, Console& console) {
  constexpr std::size_t kMany = 6;
  for (const auto& [text, variants] : notes)
    if (variants.size() >= kMany)
      console.say(fmt::format("{} variants: {}", variants.size(), text));
    else
      for (const std::string& variant : variants) console.say(variant + ": " + text);
}

EarlierRun usable_earlier_run(const VariantJob& job, const std::string& key,
                              const RunOptions& options, Notes& notes, Console& console) {
  EarlierRun earlier;
  if (options.earlier != EarlierResults::ignore) earlier = read_earlier_run(job.folder, key);
  if (!earlier.damage.empty())
    console.warn(fmt::format("{}: {}: {} complete cycles before it can be used", job.variant->name,
                             earlier.damage, cycle_count(earlier)));
  add_note(what_happens(earlier, options.earlier), job.variant->name, notes);
  const bool is_used =
      earlier.state == State::finished ||
      (earlier.state == State::unfinished && options.earlier == EarlierResults::resume);
  if (!is_used) earlier = {};
  earlier.record.key = key;
  return earlier;
}

/// Profiles are not guarded by digests as meshes are: those of cycles that are gone on from are
/// written again.
auto profile_writer(const fs::path& folder) {
  return [folder](const CycleRecord& record, const Mesh&, const Analysis& analysis) {
    write_profiles(folder, record.cycle, analysis.profiles);
  };
}

/// For the work on a variant before it runs, and for what is reported later from within.
Monitor variant_monitor(const std::string& variant, const RunOptions& options, Console& console,
                        RunProgress& progress) {
  Monitor monitor = console.monitor(variant);
  monitor.progress = [variant, &options, &progress](std::string_view phase, double fraction) {
    progress.report(variant, phase, fraction);
    return !options.cancelled();
  };
  return monitor;
}

std::vector<VariantJob> prepare(const StudyFile& study, const RunOptions& options, Console& console,
                                RunProgress& progress) {
  std::vector<VariantJob> jobs;
  Notes notes;
  for (const Variant& variant : study.variants) {
    VariantJob job{&variant, options.directory / variant.name, {}, {}};
    job.earlier = usable_earlier_run(job, variant_key(study, variant), options, notes, console);
    if (job.earlier.state != State::finished) {
      job.input =
          loop_input(variant.study, variant_monitor(variant.name, options, console, progress));
      job.input->replayed = profile_writer(job.folder);
    }
    jobs.push_back(std::move(job));
  }
  say_notes(notes, console);
  for (const VariantJob& job : jobs)
    if (job.input)
      progress.plan(job.variant->name,
                    variant_plan(job.variant->study, *job.input, job.earlier.cycles));
  return jobs;
}

std::vector<Outcome> run_jobs(std::vector<VariantJob> jobs, const RunOptions& options,
                              Console& console, RunProgress& progress) {
  std::vector<Outcome> outcomes(jobs.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++)
      outcomes[i] = run_variant(std::move(jobs[i]), options.cancelled, console, progress);
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < options.threads; ++i) helpers.emplace_back(work);
  work();
  helpers.clear();
  console.end_progress();
  return outcomes;
}

int exit_code(const std::vector<Outcome>& outcomes) {
  int failure = 0;
  bool has_budget_stop = false, has_missed = false;
  for (const Outcome& outcome : outcomes) {
    if (outcome.failure == ErrorKind::interrupted) return static_cast<int>(ErrorKind::interrupted);
    if (outcome.failure && failure == 0) failure = static_cast<int>(*outcome.failure);
    has_budget_stop = has_budget_stop || outcome.history.stopped_by == StoppedBy::budget;
    has_missed = has_missed || outcome.history.target == TargetState::missed;
  }
  if (failure != 0) return failure;
  if (has_budget_stop) return static_cast<int>(ErrorKind::budget);
  return has_missed ? 1 : 0;
}

void write_json(const Json& json, const fs::path& path) {
  write_text_file(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void write_tables(const Json& history, const fs::path& directory) {
  write_json(history, directory / "history.json");
  write_text_file(directory / "history.csv", history_csv(history));
  fs::remove(directory / "comparison.csv");
  if (!history["comparison"].empty())
    write_text_file(directory / "comparison.csv", comparison_csv(history));
}

void write_results(const StudyFile& study, const std::vector<Outcome>& outcomes,
                   const std::vector<std::string>& keys, const RunFacts& facts,
                   const fs::path& directory, Console& console) {
  std::vector<VariantHistory> variants;
  bool has_cycles = false;
  for (const Outcome& outcome : outcomes) {
    variants.push_back(outcome.history);
    has_cycles = has_cycles || !outcome.history.cycles.empty();
  }
  if (!has_cycles) return;
  const Json history = history_json(study.title, variants, keys);
  write_text_file(directory / "study.toml", study.resolved);
  write_tables(history, directory);
  write_json(run_json(facts), directory / "run.json");
  console.progress({1, {}, "figures and page"});
  for (const std::string& problem : make_report(directory)) console.warn(problem);
  console.say(terminal_summary(history, terminal_columns(STDOUT_FILENO, kNoTerminal)));
  console.say("results in " + directory.string() +
              ", page: " + (directory / "report.html").string());
}

void explain_exit_code(int code, Console& console) {
  if (code == 1) console.warn("the target error was missed; see stop_reason in history.json");
  if (code == static_cast<int>(ErrorKind::budget))
    console.warn("a budget was reached; see stop_reason in history.json");
  if (code == static_cast<int>(ErrorKind::interrupted))
    console.warn("interrupted; finished cycles are kept, --resume goes on from them");
}

}  // namespace

int run_study(const StudyFile& study, const RunOptions& options, Console& console) {
  const auto start = std::chrono::steady_clock::now();
  RunFacts facts{options.command, std::chrono::system_clock::now(), 0, options.threads, 0};
  RunProgress progress(console);
  std::vector<VariantJob> jobs = prepare(study, options, console, progress);
  std::vector<std::string> keys;
  for (const VariantJob& job : jobs) keys.push_back(job.earlier.record.key);
  const std::vector<Outcome> outcomes = run_jobs(std::move(jobs), options, console, progress);
  facts.exit_code = exit_code(outcomes);
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_results(study, outcomes, keys, facts, options.directory, console);
  explain_exit_code(facts.exit_code, console);
  return facts.exit_code;
}

}  // namespace anisofront
