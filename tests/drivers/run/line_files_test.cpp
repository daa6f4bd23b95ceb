#include "drivers/run/line_files.hpp"

#include <doctest/doctest.h>

#include "drivers/run/cycle_files.hpp"
#include "tests/drivers/result_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

using Names = std::set<std::string>;

const std::vector<Profile> kProfiles{
    {"cut", {{"s", "x", "y", "u"}, {{0, 0.1, 1. / 3, 1e-300}, {1, 2, 3, -4}}}, {}},
    {"rim", {{"s", "u"}, {{0, 5}}}, NumberTable{{"s", "u"}, {{0, 6}}}}};

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("profiles are tables by cycle and line with their references") {
  const TemporaryFolder folder;
  write_profiles(folder.path(), 3, kProfiles);
  CHECK(files_below(folder.path()) ==
        Names{"lines/cycle-3-cut.csv", "lines/cycle-3-rim.csv", "lines/reference-rim.csv"});
  CHECK(read_text_file(folder.path() / "lines/cycle-3-cut.csv") ==
        "s,x,y,u\n0,0.1,0.3333333333333333,1e-300\n1,2,3,-4\n");
  CHECK(read_text_file(folder.path() / "lines/reference-rim.csv") == "s,u\n0,6\n");
}

TEST_CASE("a variant without lines gets no folder for them") {
  const TemporaryFolder folder;
  write_profiles(folder.path(), 0, {});
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("profiles go with their cycles and references with the first") {
  const TemporaryFolder folder;
  for (int cycle = 0; cycle < 12; ++cycle) write_profiles(folder.path(), cycle, kProfiles);
  write_text_file(folder.path() / "lines/mine.txt", "kept");
  write_text_file(folder.path() / "lines/cycle-11-cut.csv.part-x", "half");
  remove_cycles(folder.path(), 2);
  CHECK(files_below(folder.path() / "lines") == Names{"cycle-0-cut.csv", "cycle-0-rim.csv",
                                                      "cycle-1-cut.csv", "cycle-1-rim.csv",
                                                      "mine.txt", "reference-rim.csv"});
  remove_cycles(folder.path(), 0);
  CHECK(files_below(folder.path() / "lines") == Names{"mine.txt"});
  std::filesystem::remove(folder.path() / "lines/mine.txt");
  remove_cycles(folder.path(), 0);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "lines"));
}

TEST_SUITE_END();
