#include "drivers/base/shell_words.hpp"

#include <doctest/doctest.h>

#include "tests/drivers/shell_output.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE_BEGIN("unit");

TEST_CASE("plain words stay as they are") {
  CHECK(shell_line({"run", "data/l-shape.toml", "--set", "adapt.cycles=3", "-j", "2"}) ==
        "run data/l-shape.toml --set adapt.cycles=3 -j 2");
  CHECK(shell_quoted("") == "''");
  CHECK(shell_quoted("a b") == "'a b'");
}

TEST_CASE("a shell reads back every word") {
  for (const std::string word : {"it's", "$HOME", "`id`", "a\\b", "*", "~", "#x", "a\nb", "\"", "!",
                                 "mesh.elements=\"triangle\"", "{ nodes = 3 }", "a;b", "-", "\x01"})
    CHECK(shell_output("printf %s " + shell_quoted(word)) == word);
}

TEST_SUITE_END();
