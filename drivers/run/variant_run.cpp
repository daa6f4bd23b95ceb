#include "drivers/run/variant_run.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "drivers/run/cycle_files.hpp"

namespace anisofront {
namespace {

class VariantRun {
 public:
  VariantRun(VariantJob job, const std::function<bool()>& cancelled, Console& console,
             RunProgress& progress)
      : job_(std::move(job)),
        variant_(*job_.variant),
        record_(std::move(job_.earlier.record)),
        cancelled_(cancelled),
        console_(console),
        progress_(progress) {
    record_.history.name = variant_.name;
    record_.history.settings = variant_settings(variant_);
  }

  Outcome run() {
    if (job_.input) {
      try_loop();
      progress_.finish(variant_.name);
    }
    return {std::move(record_.history), failure_};
  }

 private:
  void try_loop() {
    try {
      loop();
    } catch (const Error& error) {
      fail(error.kind(), error.what());
    } catch (const std::bad_alloc&) {
      fail(ErrorKind::budget, "out of memory");
    } catch (const std::exception& error) {
      fail(ErrorKind::failed, error.what());
    }
  }

  void loop() {
    if (cancelled_()) throw Interrupted();
    LoopInput& input = *job_.input;
    input.done = std::move(job_.earlier.cycles);
    if (!input.done.empty()) remove_cycles(job_.folder, static_cast<int>(input.done.size()));
    input.finished = [this](const CycleRecord& record, const Mesh& mesh, const Analysis& analysis) {
      finish_cycle(record, mesh, analysis);
    };
    const VariantHistory history = adapt_loop(input, monitor());
    // Errors may have been measured after the last cycle.
    for (std::size_t k = 0; k < history.cycles.size(); ++k)
      record_.history.cycles[k].error = history.cycles[k].error;
    record_.history.stop_reason = history.stop_reason;
    record_.history.target = history.target;
    record_.history.stopped_by = history.stopped_by;
    record_.is_finished = true;
    write_record(job_.folder, record_);
  }

  void fail(ErrorKind kind, const std::string& message) {
    failure_ = kind;
    const bool is_interrupted = kind == ErrorKind::interrupted;
    record_.history.stopped_by = is_interrupted ? StoppedBy::interrupted : StoppedBy::failed;
    record_.history.stop_reason = is_interrupted ? "interrupted" : "failed: " + message;
    if (!is_interrupted) console_.error(variant_.name + ": " + message);
  }

  /// Of an earlier run that is not gone on with.
  void remove_results() {
    remove_record(job_.folder);
    remove_cycles(job_.folder, 0);
  }

  void finish_cycle(const CycleRecord& record, const Mesh& mesh, const Analysis& analysis) {
    if (record.cycle == 0) remove_results();
    write_cycle(job_.folder, variant_.study.output.formats, record.cycle, mesh, analysis);
    record_.history.cycles.push_back(with_warnings(record));
    record_.digests.push_back(file_digest(job_.folder / cycle_mesh_name(record.cycle)));
    write_record(job_.folder, record_);
    progress_.finish_cycle(variant_.name, record.background.vertices, analysis.next_vertices);
    tell(record);
  }

  void tell(const CycleRecord& record) {
    const MeshStatistics& mesh = record.background;
    const std::string message = fmt::format("{}: cycle {}: {} vertices, {} elements", variant_.name,
                                            record.cycle, mesh.vertices, mesh.elements);
    console_.detail(message);
    const auto end = std::chrono::steady_clock::now();
    const double seconds =
        std::chrono::duration<double>(end - std::exchange(cycle_start_, end)).count();
    console_.event("cycle", message,
                   {{"variant", variant_.name},
                    {"cycle", record.cycle},
                    {"vertices", mesh.vertices},
                    {"elements", mesh.elements},
                    {"seconds", seconds}});
  }

  /// Adds the warnings heard since the last finished cycle.
  CycleRecord with_warnings(CycleRecord record) {
    for (const std::string& warning : std::exchange(warnings_, {}))
      if (std::find(record.warnings.begin(), record.warnings.end(), warning) ==
          record.warnings.end())
        record.warnings.push_back(warning);
    return record;
  }

  Monitor monitor() {
    Monitor monitor;
    monitor.warn = [this](const std::string& message) {
      warnings_.push_back(message);
      console_.warn(variant_.name + ": " + message);
    };
    monitor.progress = [this](std::string_view phase, double fraction) {
      progress_.report(variant_.name, phase, fraction);
      return !cancelled_();
    };
    return monitor;
  }

  VariantJob job_;
  const Variant& variant_;
  RunRecord record_;
  const std::function<bool()>& cancelled_;
  Console& console_;
  RunProgress& progress_;
  std::optional<ErrorKind> failure_;
  std::chrono::steady_clock::time_point cycle_start_ = std::chrono::steady_clock::now();
  std::vector<std::string> warnings_;  ///< since the last finished cycle
};

}  // namespace

Outcome run_variant(VariantJob job, const std::function<bool()>& cancelled, Console& console,
                    RunProgress& progress) {
  return VariantRun(std::move(job), cancelled, console, progress).run();
}

}  // namespace anisofront
