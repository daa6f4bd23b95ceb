#include "drivers/run/run_progress.hpp"

#include <algorithm>
#include <array>

#include <spdlog/fmt/fmt.h>

namespace anisofront {
namespace {

/// Reported by the loop itself, where VariantWork::stage() says it better.
constexpr std::array<std::string_view, 3> kStages{"cycles", "reference", "resume"};

}  // namespace

void RunProgress::plan(const std::string& variant, const VariantPlan& plan) {
  const std::lock_guard lock(mutex_);
  entries_.push_back({variant, VariantWork(plan), {}, false});
  start_ = Clock::now();
}

RunProgress::Entry* RunProgress::find(const std::string& variant) {
  for (Entry& entry : entries_)
    if (entry.variant == variant) return &entry;
  return nullptr;
}

/// Of the variants that are not finished the first speaks, so that the line is calm.
std::string RunProgress::label() const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (entry.is_finished) continue;
    const bool is_phase = !entry.phase.empty() &&
                          std::find(kStages.begin(), kStages.end(), entry.phase) == kStages.end();
    const std::string stage = entry.work.stage() + (is_phase ? ", " + entry.phase : "");
    if (entries_.size() == 1) return stage;
    return fmt::format("{} of {}: {}  {}", i + 1, entries_.size(), stage, entry.variant);
  }
  return {};
}

WorkState RunProgress::current_state() {
  double done = 0, total = 0;
  for (const Entry& entry : entries_) {
    done += entry.work.done();
    total += entry.work.total();
  }
  if (total <= 0) return {};
  const double now = std::chrono::duration<double>(Clock::now() - start_).count();
  // What was done in less than a second says little.
  if (has_finished_cycle_ && now > 1) time_.update(now, done / total);
  // Work may turn out to be more than expected; the bar never shrinks.
  fraction_ = std::max(fraction_, done / total);
  return {fraction_, time_.seconds_left(now), label()};
}

WorkState RunProgress::state() {
  const std::lock_guard lock(mutex_);
  return current_state();
}

void RunProgress::report(const std::string& variant, std::string_view phase, double fraction) {
  const std::lock_guard lock(mutex_);
  Entry* entry = find(variant);
  if (entry == nullptr)
    return console_.progress({0, {}, fmt::format("preparing {}: {}", variant, phase)});
  entry->phase = phase;
  entry->work.report(phase, fraction);
  console_.progress(current_state());
}

void RunProgress::finish_cycle(const std::string& variant, double vertices, double next_vertices) {
  const std::lock_guard lock(mutex_);
  Entry* entry = find(variant);
  // The initial mesh is no measure: it is small, and was made before.
  has_finished_cycle_ = has_finished_cycle_ || entry->work.cycle() > 0;
  entry->work.finish_cycle(vertices, next_vertices);
  entry->phase.clear();
  console_.progress(current_state());
}

void RunProgress::finish(const std::string& variant) {
  const std::lock_guard lock(mutex_);
  Entry* entry = find(variant);
  entry->is_finished = true;
  entry->work.finish();
  console_.progress(current_state());
}

}  // namespace anisofront
