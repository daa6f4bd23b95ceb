#include "drivers/run/run_json.hpp"

#include <ctime>

namespace anisofront {
namespace {

/// ISO 8601, UTC, whole seconds.
std::string date_text(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[] = "0000-00-00T00:00:00Z";
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

Json run_json(const RunFacts& facts) {
  return {{"program", "anisofront"},
          {"version", ANISOFRONT_VERSION},
          {"command", facts.command.empty() ? Json(nullptr) : Json(facts.command)},
          {"date", date_text(facts.started)},
          {"seconds", facts.seconds},
          {"threads", facts.threads},
          {"exit_code", facts.exit_code}};
}

}  // namespace anisofront
