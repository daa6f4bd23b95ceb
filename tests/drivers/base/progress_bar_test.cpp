#include "drivers/base/progress_bar.hpp"

#include <regex>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

/// As seen on a terminal, without the sequences that set colours.
std::string seen(const std::string& line) {
  return std::regex_replace(line, std::regex("\033\\[[0-9;]*m"), "");
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the time left is rounded as estimates deserve") {
  const std::pair<double, const char*> expected[] = {
      {-3, "about 1 s left"},      {0.2, "about 1 s left"},        {7.4, "about 7 s left"},
      {22, "about 20 s left"},     {58, "about 1 min left"},       {79, "about 1 min 20 s left"},
      {120, "about 2 min left"},   {594, "about 9 min 50 s left"}, {600, "about 10 min left"},
      {1499, "about 25 min left"}, {3590, "about 1 h left"},       {4300, "about 1 h 10 min left"},
      {7200, "about 2 h left"},    {86400, "about 24 h left"}};
  for (const auto& [seconds, text] : expected) CHECK(time_left_text(seconds) == text);
}

TEST_CASE("the bar shows share and time and label") {
  const WorkState state{0.42, 80., "3 of 96: cycle 2 of 4, front  0.01-soft"};
  const std::string line = bar_line(state, 120, false);
  CHECK(line ==
        "[========>           ]  42 %  about 1 min 20 s left  3 of 96: cycle 2 of 4, front  "
        "0.01-soft");
  CHECK(seen(bar_line(state, 120, true)) == line);
  CHECK(bar_line(state, 120, true) != line);
  CHECK(bar_line({1, {}, "page"}, 80, false) == "[=============] 100 %  page");
}

TEST_CASE("the bar never reaches the last column of the terminal") {
  const std::string label(300, 'x');
  for (const double fraction : {-1., 0., 0.3, 1., 2.})
    for (int columns = 1; columns < 200; ++columns) {
      const std::string line = seen(bar_line({fraction, 4000., label}, columns, true));
      CHECK(static_cast<int>(line.size()) < std::max(columns, 2));
      if (columns > 40) CHECK(line.find(" %  about") != std::string::npos);
    }
}

TEST_CASE("a name is left out rather than cut to a few letters") {
  const std::string name = "0.01-anisotropic";
  const WorkState state{0.5, {}, "3 of 96: cycle 2 of 4  " + name};
  // 45 columns have no bar: " 50 %  " and 37 letters, 14 of them of the name.
  CHECK(bar_line(state, 45, false) == " 50 %  3 of 96: cycle 2 of 4  0.01-anisotrop");
  CHECK(bar_line(state, 36, false) == " 50 %  3 of 96: cycle 2 of 4");
}

TEST_SUITE_END();
