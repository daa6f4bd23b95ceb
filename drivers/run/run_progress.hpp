#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "drivers/base/console.hpp"
#include "drivers/run/variant_work.hpp"

namespace anisofront {

/// Draws how far the variants of a run are, several at once, and estimates the time left from the
/// first finished cycle on. Variants that are never planned (finished earlier) cost nothing. Thread
/// safe.
class RunProgress {
 public:
  explicit RunProgress(Console& console) : console_(console) {}

  /// To be called for every variant that will be run, before the first is started.
  void plan(const std::string& variant, const VariantPlan& plan);
  /// As the loop and the libraries report it to a Monitor, also before the variant is planned.
  void report(const std::string& variant, std::string_view phase, double fraction);
  void finish_cycle(const std::string& variant, double vertices, double next_vertices);
  void finish(const std::string& variant);

  /// What the bar shows.
  WorkState state();

 private:
  struct Entry {
    std::string variant;
    VariantWork work;
    std::string phase;  ///< last reported
    bool is_finished = false;
  };
  using Clock = std::chrono::steady_clock;

  Entry* find(const std::string& variant);
  std::string label() const;
  WorkState current_state();

  Console& console_;
  std::vector<Entry> entries_;
  Clock::time_point start_ = Clock::now();
  bool has_finished_cycle_ = false;
  double fraction_ = 0;
  RemainingTime time_;
  std::mutex mutex_;
};

}  // namespace anisofront
