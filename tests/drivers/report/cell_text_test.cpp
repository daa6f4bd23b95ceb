#include "drivers/report/cell_text.hpp"

#include <doctest/doctest.h>

using namespace anisofront;

TEST_SUITE_BEGIN("unit");

TEST_CASE("cells show numbers in their format and dashes for what is unknown") {
  CHECK(number_cell(Json(0.0125), "{:.3e}") == "1.250e-02");
  CHECK(number_cell(Json(3), "{:.0f}") == "3");
  CHECK(number_cell(Json(nullptr), "{:.0f}") == "-");
  CHECK(number_cell(Json("3"), "{:.0f}") == "-");
}

TEST_CASE("percentages are cut so that a hundred means all") {
  CHECK(percent_cell(Json(99.999), 2) == "99.99");
  CHECK(percent_cell(Json(99.99), 1) == "99.9");
  CHECK(percent_cell(Json(100), 2) == "100.00");
  CHECK(percent_cell(Json(28.7), 1) == "28.7");  // 28.7 itself lies a little below
  CHECK(percent_cell(Json(nullptr), 1) == "-");
}

TEST_SUITE_END();
