#pragma once

#include <string>
#include <string_view>

namespace anisofront {

/// The base64 encoding of RFC 4648, padded, in one line.
std::string base64(std::string_view bytes);

}  // namespace anisofront
