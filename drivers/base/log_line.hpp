#pragma once

#include <string>

#include "drivers/base/json.hpp"

namespace anisofront {

/// A line of --log-format json, without the newline: {"time" (ISO 8601, UTC, milliseconds),
/// "level", "message"} and the fields of an event. Bytes that are not UTF-8 become U+FFFD.
std::string json_log_line(const std::string& level, const std::string& message,
                          const Json& fields = Json::object());

}  // namespace anisofront
