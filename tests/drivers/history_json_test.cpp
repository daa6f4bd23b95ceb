#include "drivers/history_json.hpp"

#include <algorithm>
#include <sstream>

#include <doctest/doctest.h>

#include "drivers/paper_table.hpp"
#include "drivers/summary.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

VariantHistory example(bool prescribed) {
  CycleRecord record;
  record.cycle = 5;
  record.background.vertices = 12;
  record.background.elements = record.background.triangles = 14;
  record.background.edges = 25;
  record.background.boundary_edges = 8;
  record.background.quality_mean = 0.9;
  record.background.percent_unit = 99.999;
  record.background.histogram[9] = 25;
  if (prescribed) {
    record.exact = record.background;
    record.exact->quality_mean = 0.8;
  } else {
    record.error.relative_energy = 0.0125;
  }
  VariantHistory variant{"iso",
                         {{"adapt.mode", "isotropic"}, {"report.paper", "13b"}, {"k", "3"}},
                         {record},
                         "finished",
                         TargetState::none};
  return variant;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("history.json has schema 1") {
  const Json history = history_json("t", {example(true)});
  CHECK(history["schema"] == 1);
  CHECK(history["title"] == "t");
  const Json& variant = history["variants"][0];
  CHECK(variant["name"] == "iso");
  CHECK(variant["settings"]["adapt.mode"] == "isotropic");
  CHECK(variant["settings"]["report.paper"] == "13b");
  CHECK(variant["settings"]["k"] == 3);
  const Json& cycle = variant["cycles"][0];
  for (const char* key :
       {"cycle", "vertices", "elements", "edges", "boundary_edges", "triangles", "dofs", "quality",
        "edge_length", "metric_complexity", "error", "seconds"})
    CHECK_MESSAGE(cycle.contains(key), key);
  for (const char* key : {"min", "max", "in_0.5_1.5", "in_unit_band", "histogram"})
    CHECK_MESSAGE(cycle["edge_length"].contains(key), key);
  for (const char* key : {"metric", "front", "enhance", "quads", "solve", "estimate"})
    CHECK_MESSAGE(cycle["seconds"].contains(key), key);
  CHECK(cycle["edge_length"]["histogram"]["bounds"].size() == 30);
  CHECK(cycle["edge_length"]["histogram"]["bounds"][9] == 1.0);
  CHECK(cycle["edge_length"]["histogram"]["counts"].size() == 31);
  CHECK(cycle["error"]["estimate"].is_null());
}

TEST_CASE("a prescribed metric has statistics against the formula and the background") {
  const Json cycle = history_json("t", {example(true)})["variants"][0]["cycles"][0];
  CHECK(cycle["quality"]["against"] == "exact");
  CHECK(cycle["quality"]["mean"] == 0.8);
  CHECK(cycle["background"]["quality"]["against"] == "background");
  CHECK(cycle["background"]["quality"]["mean"] == 0.9);
}

TEST_CASE("a problem is measured against the background") {
  const Json cycle = history_json("t", {example(false)})["variants"][0]["cycles"][0];
  CHECK(cycle["quality"]["against"] == "background");
  CHECK(cycle["error"]["relative_energy"] == 0.0125);
}

TEST_CASE("the CSV has one line per cycle and as many fields as titles") {
  const std::string csv = history_csv(history_json("t", {example(true), example(false)}));
  std::istringstream stream(csv);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  REQUIRE(lines.size() == 3);
  const auto commas = std::count(lines[0].begin(), lines[0].end(), ',');
  CHECK(std::count(lines[1].begin(), lines[1].end(), ',') == commas);
  CHECK(std::count(lines[2].begin(), lines[2].end(), ',') == commas);
  CHECK(lines[0].starts_with("variant,cycle,vertices,elements,edges,boundary_edges"));
  CHECK(lines[1].starts_with("\"iso\",5,12,14,25,8,14,0,0,\"exact\",0.8,"));
}

TEST_CASE("the summary sets the row of the paper below ours") {
  const std::string text = as_text(summary_table(history_json("t", {example(true)})));
  CHECK(has(text, "(Fig. 13b)"));
  CHECK(has(text, "4958"));
  CHECK(has(text, "434"));    // boundary edges of the paper's mesh: 2 ND - 3 NE
  CHECK(has(text, "99.99"));  // 99.999 percent is not all
  CHECK_FALSE(has(text, "100.00"));
}

TEST_CASE("a variant without a cycle shows why") {
  VariantHistory failed;
  failed.name = "bad";
  failed.stop_reason = "failed: no metric";
  CHECK(has(as_text(summary_table(history_json("t", {failed}))), "failed: no metric"));
}

TEST_CASE("the rows of the paper obey Euler's formula where the paper does") {
  for (const std::string& name : paper_row_names()) {
    const PaperRow& row = *paper_row(name);
    const int holes = name[1] == '5' ? 3 : 0;
    if (name == "14e") continue;  // one of its counts is misprinted
    CHECK_MESSAGE(row.vertices - row.edges + row.elements == 1 - holes, name);
  }
  CHECK(paper_row("99z") == nullptr);
}

TEST_SUITE_END();
