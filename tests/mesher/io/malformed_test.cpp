#include <functional>
#include <random>

#include <doctest/doctest.h>

#include "io_support.hpp"
#include "mesher/io/medit.hpp"

// Truncated and garbled files: an InputError or a mesh, nothing else.

using namespace anisofront;
using namespace anisofront::test;

namespace {

enum class Outcome { mesh, input_error, other };

using Parse = std::function<void(const std::string&)>;

Outcome outcome(const Parse& parse, const std::string& bytes) {
  try {
    parse(bytes);
    return Outcome::mesh;
  } catch (const InputError&) {
    return Outcome::input_error;
  } catch (...) {
    return Outcome::other;
  }
}

struct Format {
  std::string name;
  std::string bytes;
  Parse parse;
};

std::vector<Format> formats() {
  const std::filesystem::path folder = std::filesystem::path(ANISOFRONT_TEST_DATA) / "gmsh";
  const Parse gmsh = [](const std::string& bytes) { parse_gmsh(bytes, "m"); };
  const Parse medit = [](const std::string& bytes) { parse_medit(bytes, "m"); };
  const Parse metric = [](const std::string& bytes) { parse_medit_metric(bytes, "m", 4); };
  std::vector<Format> list;
  for (const char* name :
       {"two-squares.22.ascii.msh", "two-squares.22.binary.msh", "two-squares.41.ascii.msh",
        "two-squares.41.binary.msh", "partitioned.41.binary.msh", "node-data.41.binary.msh",
        "element-node-data.22.ascii.msh"})
    list.push_back({name, contents(folder / name), gmsh});
  const Scratch scratch;
  for (const GmshFormat format : kFlavours) {
    write_gmsh(scratch / "m.msh", small_file(), format);
    list.push_back({"written", contents(scratch / "m.msh"), gmsh});
  }
  write_medit(scratch / "m.mesh", small_file().mesh);
  list.push_back({"medit", contents(scratch / "m.mesh"), medit});
  write_medit_metric(scratch / "m.sol", MetricField(4, Metric{2, 1, 3}));
  list.push_back({"sol", contents(scratch / "m.sol"), metric});
  return list;
}

}  // namespace

TEST_SUITE("property") {
  TEST_CASE("truncated files never do worse than an input error") {
    for (const Format& format : formats()) {
      CAPTURE(format.name);
      REQUIRE(outcome(format.parse, format.bytes) == Outcome::mesh);
      std::size_t refused = 0;
      std::size_t tried = 0;
      for (std::size_t n = 0; n < format.bytes.size(); n += 3, ++tried) {
        const Outcome found = outcome(format.parse, format.bytes.substr(0, n));
        if (found == Outcome::other) FAIL("other error at byte " << n);
        refused += found == Outcome::input_error;
      }
      // Only what follows the last section that matters can be missed.
      CHECK(refused > tried / 4);
    }
  }

  TEST_CASE("files with flipped bytes never do worse than an input error") {
    std::mt19937 random(20261122);
    for (const Format& format : formats()) {
      CAPTURE(format.name);
      std::size_t refused = 0;
      for (int trial = 0; trial < 1000; ++trial) {
        std::string bytes = format.bytes;
        for (int flip = 0; flip <= trial % 4; ++flip)
          bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        const Outcome found = outcome(format.parse, bytes);
        if (found == Outcome::other) FAIL("other error in trial " << trial);
        refused += found == Outcome::input_error;
      }
      CHECK(refused > 100);
    }
  }
}
