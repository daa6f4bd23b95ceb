#include "drivers/base/console.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include <spdlog/fmt/fmt.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <unistd.h>

#include "drivers/base/interrupt.hpp"

namespace anisofront {
namespace {

std::shared_ptr<spdlog::logger> make_log(std::ostream& err) {
  spdlog::sink_ptr sink;
  if (&err == &std::cerr) {
    // https://no-color.org: set and not empty
    const char* no_colour = std::getenv("NO_COLOR");
    const bool plain = no_colour != nullptr && *no_colour != '\0';
    sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>(
        plain ? spdlog::color_mode::never : spdlog::color_mode::automatic);
  } else {
    sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(err, true);
  }
  auto log = std::make_shared<spdlog::logger>("anisofront", sink);
  log->set_pattern("%^%l%$: %v");
  return log;
}

double now() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

Console::Console(std::ostream& out, std::ostream& err) : out_(out), log_(make_log(err)) {
  draws_bar_ = &err == &std::cerr && isatty(STDERR_FILENO) != 0;
}

void Console::set_verbosity(Verbosity verbosity) {
  verbosity_ = verbosity;
  if (verbosity == Verbosity::quiet) draws_bar_ = false;
}

void Console::say(const std::string& text) {
  if (verbosity_ != Verbosity::quiet) print(text);
}

void Console::print(const std::string& text) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  out_ << text << '\n' << std::flush;
}

void Console::detail(const std::string& text) {
  if (is_verbose()) print(text);
}

void Console::warn(const std::string& text) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  if (verbosity_ != Verbosity::quiet) log_->warn("{}", text);
}

void Console::error(const std::string& text) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  log_->error("{}", text);
}

void Console::progress(std::string_view label, double fraction) {
  constexpr double kSecondsBetween = 0.1;
  constexpr int kWidth = 30;
  const std::lock_guard lock(mutex_);
  const double time = now();
  if (!draws_bar_ || time - last_drawn_ < kSecondsBetween) return;
  last_drawn_ = time;
  bar_shown_ = true;
  const int filled = static_cast<int>(std::lround(kWidth * std::clamp(fraction, 0., 1.)));
  std::cerr << fmt::format("\r\033[K[{:#<{}}{:.<{}}] {}", "", filled, "", kWidth - filled, label)
            << std::flush;
}

void Console::end_progress() {
  const std::lock_guard lock(mutex_);
  erase_bar();
}

void Console::erase_bar() {
  if (bar_shown_) std::cerr << "\r\033[K" << std::flush;
  bar_shown_ = false;
}

Monitor Console::monitor(const std::string& label) {
  Monitor monitor;
  monitor.warn = [this](const std::string& message) { warn(message); };
  monitor.progress = [this, label](std::string_view phase, double fraction) {
    progress(fmt::format("{}: {}", label, phase), fraction);
    return !InterruptGuard::requested();
  };
  return monitor;
}

}  // namespace anisofront
