#include "drivers/base/text.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE_BEGIN("unit");

TEST_CASE("edit distance counts insertions deletions replacements and swaps") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);  // the textbook example
  CHECK(edit_distance("metric", "metirc") == 1);   // one swap
}

TEST_CASE("the nearest name is proposed only when it can be meant") {
  const std::vector<std::string> known{"cycles", "mode", "target", "limits"};
  CHECK(nearest_name("cicles", known) == "cycles");
  CHECK(nearest_name("modus", known) == "mode");
  CHECK(nearest_name("viscosity", known) == "");
  CHECK(name_proposal("tagret", known) == "; did you mean \"target\"?");
  CHECK(name_proposal("viscosity", known) == "; known: cycles, mode, target, limits");
  CHECK(name_proposal("x", {}) == "");
}

TEST_CASE("a text file is replaced as a whole or not at all") {
  const TemporaryFolder folder;
  const auto path = folder.write("a.txt", "old");
  write_text_file(path, "new");
  CHECK(read_text_file(path) == "new");
  CHECK_THROWS_AS(write_text_file(folder.path() / "missing" / "a.txt", "x"), InputError);
  CHECK_THROWS_AS(read_text_file(folder.path() / "b.txt"), UsageError);
  CHECK_THROWS_AS(read_text_file(path, 2), InputError);
}

TEST_SUITE_END();
