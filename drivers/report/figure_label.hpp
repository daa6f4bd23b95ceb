#pragma once

#include <string>
#include <vector>

#include "drivers/base/json.hpp"

namespace anisofront {

/// Short labels that tell objects of settings apart: "anisotropic, triangles, t = 0.01". A setting
/// is named only where those before it leave some alike. Empty for a single one.
std::vector<std::string> distinguishing_labels(const std::vector<Json>& settings);

}  // namespace anisofront
