#include "drivers/base/log_line.hpp"

#include <chrono>
#include <ctime>

#include <spdlog/fmt/fmt.h>

namespace anisofront {
namespace {

std::string utc_now() {
  using std::chrono::milliseconds;
  const auto since_1970 =
      std::chrono::duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch());
  const std::time_t seconds = since_1970.count() / 1000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900,
                     utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec,
                     since_1970.count() % 1000);
}

}  // namespace

std::string json_log_line(const std::string& level, const std::string& message,
                          const Json& fields) {
  Json line{{"time", utc_now()}, {"level", level}, {"message", message}};
  line.update(fields);
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace anisofront
