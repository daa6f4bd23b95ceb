#include "drivers/base/console.hpp"

#include <chrono>
#include <iostream>

#include <unistd.h>

#include "drivers/base/interrupt.hpp"
#include "drivers/base/log_line.hpp"

namespace anisofront {
namespace {

// ECMA-48, 8.3.41 and 8.3.117: to the first column, erase to the end of the line, bold red, ...
constexpr const char* kEraseLine = "\r\033[K";
constexpr const char* kRed = "\033[1;31m";
constexpr const char* kYellow = "\033[1;33m";
constexpr const char* kPlain = "\033[0m";

double now() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

Console::Console(std::ostream& out, std::ostream& err)
    : out_(out),
      err_(err),
      terminal_(&err == &std::cerr ? terminal_of(STDERR_FILENO) : Terminal()),
      last_drawn_(now()) {}

Console::~Console() { end_progress(); }

void Console::set_verbosity(Verbosity verbosity) { verbosity_ = verbosity; }

void Console::set_log_format(LogFormat format) { format_ = format; }

void Console::say(const std::string& text) {
  if (verbosity_ != Verbosity::quiet) print(text);
}

void Console::write(const std::string& text) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  out_ << text << std::flush;
}

void Console::print(const std::string& text) { write(text + '\n'); }

void Console::detail(const std::string& text) {
  if (is_verbose()) print(text);
}

void Console::warn(const std::string& text) {
  if (verbosity_ != Verbosity::quiet) log("warning", kYellow, text);
}

void Console::error(const std::string& text) { log("error", kRed, text); }

void Console::log(const std::string& level, const std::string& colour, const std::string& text) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  if (format_ == LogFormat::json)
    err_ << json_log_line(level, text) << std::endl;
  else if (terminal_.has_colour)
    err_ << colour << level << ':' << kPlain << ' ' << text << std::endl;
  else
    err_ << level << ": " << text << std::endl;
}

void Console::event(const std::string& name, const std::string& message, const Json& fields) {
  if (format_ != LogFormat::json) return;
  Json event{{"event", name}};
  event.update(fields);
  const std::lock_guard lock(mutex_);
  err_ << json_log_line("info", message, event) << std::endl;
}

void Console::progress(const WorkState& state) {
  constexpr double kSecondsBetween = 0.1;
  if (!terminal_.can_redraw || verbosity_ == Verbosity::quiet || format_ == LogFormat::json) return;
  const std::lock_guard lock(mutex_);
  const double time = now();
  if (time - last_drawn_ < kSecondsBetween) return;
  last_drawn_ = time;
  bar_shown_ = true;
  const int columns = terminal_columns(STDERR_FILENO, 80);
  err_ << kEraseLine << bar_line(state, columns, terminal_.has_colour) << std::flush;
}

void Console::end_progress() {
  const std::lock_guard lock(mutex_);
  erase_bar();
  last_drawn_ = 0;  // what follows need not wait
}

void Console::erase_bar() {
  if (bar_shown_) err_ << kEraseLine << std::flush;
  bar_shown_ = false;
}

Monitor Console::monitor(const std::string& label, const PhasePlan& plan) {
  Monitor monitor;
  monitor.warn = [this](const std::string& message) { warn(message); };
  monitor.progress = [this, work = PhasedWork(label, plan), start = now()](
                         std::string_view phase, double fraction) mutable {
    progress(work.report(phase, fraction, now() - start));
    return !InterruptGuard::requested();
  };
  return monitor;
}

}  // namespace anisofront
