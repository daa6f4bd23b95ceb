#include "drivers/report/page_profiles.hpp"

#include <doctest/doctest.h>

#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE_BEGIN("unit");

TEST_CASE("lines of a variant are read by name and cycle with their reference") {
  const TemporaryFolder folder;
  folder.write("cycle-10-near-wall.csv", "s,x,y,u\n0,0,1,2.5\n");
  folder.write("cycle-2-near-wall.csv", "s,x,y,u\n0,0,1,0.12345678901\n1,1,1,nan\n");
  folder.write("reference-near-wall.csv", "s,u\n0,3\n");
  folder.write("cycle-0-across.csv", "s,x,y,u\n");
  const Json profiles = profiles_json(folder.path());
  REQUIRE(profiles.size() == 2);
  CHECK(profiles[0]["name"] == "across");
  CHECK(profiles[0]["reference"].is_null());
  const Json& wall = profiles[1];
  CHECK(wall["name"] == "near-wall");
  CHECK(wall["columns"] == Json{"s", "x", "y", "u"});
  REQUIRE(wall["cycles"].size() == 2);
  CHECK(wall["cycles"][0]["cycle"] == 2);
  CHECK(wall["cycles"][0]["rows"] == Json::parse("[[0,0,1,0.1234568],[1,1,1,null]]"));
  CHECK(wall["cycles"][1]["cycle"] == 10);
  CHECK(wall["reference"] == Json::parse(R"({"columns":["s","u"],"rows":[[0.0,3.0]]})"));
}

TEST_CASE("files that are no profiles and rows of another width are passed over") {
  const TemporaryFolder folder;
  folder.write("cycle-x-a.csv", "s,u\n0,1\n");
  folder.write("cycle-1.csv", "s,u\n0,1\n");
  folder.write("cycle--1-a.csv", "s,u\n0,1\n");
  folder.write("notes.txt", "s,u\n");
  folder.write("reference-b.csv", "s,u\n0,1\n");
  folder.write("cycle-1-c.csv", "s,u\n0\n0,1,2\n0,1\n");
  const Json profiles = profiles_json(folder.path());
  REQUIRE(profiles.size() == 1);
  CHECK(profiles[0]["cycles"][0]["rows"] == Json::parse("[[0.0,1.0]]"));
  CHECK(profiles_json(folder.path() / "none") == Json::array());
}
