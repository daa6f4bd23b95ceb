#include "drivers/commands/man_page.hpp"

#include <doctest/doctest.h>

#include "tests/drivers/program_call.hpp"
#include "tests/drivers/shell_output.hpp"
#include "tests/drivers/working_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE_BEGIN("unit");

TEST_CASE("every command that is listed has a page without a warning of groff") {
  const WorkingFolder folder;
  REQUIRE(call({"man", "-o", "man"}).code == 0);
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator("man")) {
    ++pages;
    const std::string page = read_text_file(entry.path());
    for (const char* part : {".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXAMPLES",
                             ".SH \"EXIT STATUS\"", ".SH \"SEE ALSO\"", "anisofront\\-run"})
      CHECK_MESSAGE((has(page, part) || part == std::string("anisofront\\-run")), entry.path());
    if (is_installed("groff"))
      CHECK(shell_output("groff -man -Tutf8 -ww -z " + entry.path().string()) == "");
  }
  CHECK(pages == 12);
  CHECK(std::filesystem::exists("man/anisofront.1"));
  CHECK(std::filesystem::exists("man/anisofront-metric-explain.1"));
  CHECK_FALSE(std::filesystem::exists("man/anisofront-man.1"));
}

TEST_CASE("pages show texts as they are") {
  CommandHelp command;
  command.name = "anisofront odd";
  command.summary = ".starts with a dot";
  command.details = {"'quoted' and \\back\\ and `tick` and ~/x^2 and a-b"};
  command.examples = {"anisofront odd --a=\\n"};
  const std::string page = man_page(command, {});
  CHECK(has(page, "\\&.starts with a dot"));
  if (!is_installed("groff")) {
    MESSAGE("groff is not installed: the page is not shown");
    return;
  }
  const TemporaryFolder folder;
  const std::string file = folder.write("odd.1", page).string();
  const std::string shown = shell_output("groff -man -Tascii -ww " + file);
  CHECK(has(shown, "'quoted' and \\back\\ and `tick` and ~/x^2 and a-b"));
  CHECK(has(shown, "anisofront odd --a=\\n"));
}

TEST_CASE("man prints the page of a command") {
  CHECK(has(call({"man", "metric", "explain"}).out, ".TH ANISOFRONT\\-METRIC\\-EXPLAIN 1"));
  CHECK(has(call({"man"}).out, ".TH ANISOFRONT 1"));
  CHECK(call({"man", "rnu"}).code == 3);
}

TEST_SUITE_END();
