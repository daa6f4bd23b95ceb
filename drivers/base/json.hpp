#pragma once

#include <nlohmann/json.hpp>

namespace anisofront {

/// Objects keep the order in which their keys were set.
using Json = nlohmann::ordered_json;

}  // namespace anisofront
