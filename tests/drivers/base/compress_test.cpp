#include "drivers/base/compress.hpp"

#include <vector>

#include <doctest/doctest.h>

#include "tests/drivers/gunzip.hpp"

namespace anisofront {
namespace {

using testing::gunzip;

TEST_SUITE("unit") {
  TEST_CASE("gzip holds its blocks one after the other") {
    std::string noise;
    unsigned state = 1;
    for (int i = 0; i < 100'000; ++i) {
      state = state * 1664525 + 1013904223;
      noise += static_cast<char>(static_cast<unsigned char>(state >> 24));
    }
    const std::vector<std::string> blocks{"header", "", noise, std::string(200'000, 'x'), "end"};
    const std::string packed = gzip(blocks);
    CHECK(gunzip(packed) == "header" + noise + blocks[3] + "end");
    CHECK(packed.size() < noise.size() + 2000);
  }

  TEST_CASE("gzip of nothing is a file of nothing") {
    CHECK(gunzip(gzip({})).empty());
    CHECK(gzip({}).size() < 30);
  }

  TEST_CASE("gzip names no file and no time") {
    const std::vector<std::string> block{"same"};
    const std::string packed = gzip(block);
    REQUIRE(packed.size() > 10);
    CHECK(packed.substr(0, 4) == std::string("\x1f\x8b\x08\0", 4));  // no flags
    CHECK(packed.substr(4, 4) == std::string(4, '\0'));              // RFC 1952: MTIME
    CHECK(gzip(block) == packed);
  }
}

}  // namespace
}  // namespace anisofront
