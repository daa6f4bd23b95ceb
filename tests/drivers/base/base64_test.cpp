#include "drivers/base/base64.hpp"

#include <doctest/doctest.h>

using anisofront::base64;

TEST_SUITE_BEGIN("unit");

TEST_CASE("base64 knows all digits and all bytes") {
  // 0x00108310518720928b... is the sequence of the 64 digits (RFC 4648, Table 1).
  std::string bytes;
  for (unsigned digit = 0; digit < 64; digit += 4) {
    const unsigned group = digit << 18 | (digit + 1) << 12 | (digit + 2) << 6 | (digit + 3);
    for (const unsigned shift : {16u, 8u, 0u}) bytes += static_cast<char>(group >> shift & 255u);
  }
  CHECK(base64(bytes) == "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
  CHECK(base64(std::string_view("\xff\x00\xfe", 3)) == "/wD+");
  CHECK(base64(std::string_view("\0", 1)) == "AA==");
}
