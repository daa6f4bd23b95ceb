#include "drivers/history/history_json.hpp"

#include <algorithm>
#include <sstream>

#include <doctest/doctest.h>

#include "drivers/history/history_csv.hpp"
#include "drivers/report/summary.hpp"
#include "drivers/study/paper_table.hpp"
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

VariantHistory quadrilaterals() {
  VariantHistory variant = example(true);
  variant.settings[1].second = "13c";
  MeshStatistics& s = variant.cycles[0].background;
  s.triangles = 0;
  s.quads = 14;
  s.angle_min = 61.6;
  s.angle_max = 118.4;
  s.scaled_jacobian_min = 0.875;
  variant.cycles[0].exact = s;
  return variant;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("history.json has schema 1") {
  const Json history = history_json("t", {example(true)});
  CHECK(history["schema"] == 1);
  CHECK(history["title"] == "t");
  CHECK(std::count(history["version"].get_ref<const std::string&>().begin(),
                   history["version"].get_ref<const std::string&>().end(), '.') == 2);
  const Json& variant = history["variants"][0];
  CHECK(variant["name"] == "iso");
  CHECK(variant["settings"]["adapt.mode"] == "isotropic");
  CHECK(variant["settings"]["report.paper"] == "13b");
  CHECK(variant["settings"]["k"] == 3);
  const Json& cycle = variant["cycles"][0];
  for (const char* key : {"cycle", "vertices", "elements", "edges", "boundary_edges", "triangles",
                          "dofs", "quality", "edge_length", "metric_complexity", "error", "seconds",
                          "quads", "angle", "scaled_jacobian_min"})
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

TEST_CASE("what stopped a variant is a word that is read back") {
  VariantHistory variant = example(false);
  CHECK(variant_json(variant, "")["stopped_by"].is_null());
  CHECK_FALSE(variant_history(variant_json(variant, "")).stopped_by.has_value());
  for (const auto& [by, word] :
       {std::pair{StoppedBy::cycles, "cycles"}, std::pair{StoppedBy::target, "target"},
        std::pair{StoppedBy::plateau, "plateau"}, std::pair{StoppedBy::budget, "budget"},
        std::pair{StoppedBy::interrupted, "interrupted"}, std::pair{StoppedBy::failed, "failed"}}) {
    variant.stopped_by = by;
    const Json json = variant_json(variant, "");
    CHECK(json["stopped_by"] == word);
    CHECK(variant_history(json).stopped_by == by);
  }
  Json old = variant_json(variant, "");
  old.erase("stopped_by");
  CHECK_FALSE(variant_history(old).stopped_by.has_value());
}

TEST_CASE("qualities are counted up to twenty bounds beside the lengths") {
  VariantHistory variant = example(true);
  variant.cycles[0].background.quality_histogram[17] = 14;
  variant.cycles[0].exact->quality_histogram[3] = 12;
  variant.cycles[0].exact->quality_histogram[19] = 2;
  const Json cycle = history_json("t", {variant})["variants"][0]["cycles"][0];
  const Json exact = cycle["quality"]["histogram"];
  REQUIRE(exact["bounds"].size() == 20);
  CHECK(exact["bounds"][0] == 0.05);
  CHECK(exact["bounds"][6] == 0.35);
  CHECK(exact["bounds"][19] == 1.0);
  REQUIRE(exact["counts"].size() == 20);
  CHECK(exact["counts"][3] == 12);
  CHECK(exact["counts"][19] == 2);
  CHECK(cycle["background"]["quality"]["histogram"]["counts"][17] == 14);
}

TEST_CASE("records of older programs come without counts of qualities") {
  VariantHistory variant = example(true);
  variant.cycles[0].background.quality_histogram[17] = 14;
  Json json = variant_json(variant, "");
  CHECK(variant_history(json).cycles[0].background.quality_histogram[17] == 14);
  for (Json* part : {&json["cycles"][0], &json["cycles"][0]["background"]})
    (*part)["quality"].erase("histogram");
  const CycleRecord old = variant_history(json).cycles[0];
  CHECK(old.background.quality_histogram == std::array<std::int64_t, kQualityBins>{});
  CHECK(old.background.quality_mean == 0.9);
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

TEST_CASE("goal values target and key are in the history and the CSV") {
  VariantHistory variant = example(false);
  CycleRecord& record = variant.cycles[0];
  record.goal = GoalRecord{2.5, -0.125};
  record.values = {{"w, centre", 0.5}, {"energy", 3}};
  record.background.stretch_max = 42.5;
  variant.target = TargetState::missed;
  const Json history = history_json("t", {variant, example(true)}, {"0123", "4567"});
  const Json& json = history["variants"][0];
  CHECK(json["key"] == "0123");
  CHECK(json["target"] == "missed");
  CHECK(history["variants"][1]["target"] == "none");
  const Json& cycle = json["cycles"][0];
  CHECK(cycle["goal"] == Json{{"value", 2.5}, {"error", -0.125}});
  CHECK(cycle["values"]["w, centre"] == 0.5);
  CHECK(cycle["stretch_max"] == 42.5);
  CHECK(cycle["error"]["kind"] == "true");
  CHECK(history["variants"][1]["cycles"][0]["goal"].is_null());
  CHECK(history["variants"][1]["cycles"][0]["error"]["kind"].is_null());
  CHECK(history["comparison"].empty());
  const std::string csv = history_csv(history);
  CHECK(has(csv,
            ",stretch_max,background_stretch_max,error_kind,goal_value,goal_error,"
            "\"value w, centre\",\"value energy\"\n"));
  CHECK(has(csv, ",42.5,42.5,\"true\",2.5,-0.125,0.5,3.0\n"));
  CHECK(has(csv, ",1.0,1.0,,,,,\n"));  // unknown values stay empty
}

TEST_CASE("an estimate alone is the kind of error that is known") {
  VariantHistory variant = example(false);
  variant.cycles[0].error = {0.5, {}, {}};
  CHECK(history_json("t", {variant})["variants"][0]["cycles"][0]["error"]["kind"] == "estimate");
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

TEST_CASE("angles and the scaled Jacobian are in history and CSV") {
  VariantHistory variant = quadrilaterals();
  variant.cycles[0].exact->angle_max = 121;
  const Json history = history_json("t", {variant});
  const Json& cycle = history["variants"][0]["cycles"][0];
  CHECK(cycle["triangles"] == 0);
  CHECK(cycle["quads"] == 14);
  CHECK(cycle["angle"]["against"] == "exact");
  CHECK(cycle["angle"]["min"] == 61.6);
  CHECK(cycle["angle"]["max"] == 121);
  CHECK(cycle["background"]["angle"]["max"] == 118.4);
  CHECK(cycle["scaled_jacobian_min"] == 0.875);
  const std::string csv = history_csv(history);
  CHECK(has(csv, ",angle_min,angle_max,scaled_jacobian_min,"));
  CHECK(has(csv, ",61.6,121.0,0.875,"));
}

TEST_CASE("the summary of quadrilaterals sets the row Q of the paper below ours") {
  const std::string text = as_text(summary_table(history_json("t", {quadrilaterals()})));
  CHECK(has(text, " Q "));
  CHECK(has(text, "62-118"));
  CHECK(has(text, "0.875"));
  CHECK(has(text, "(Fig. 13c)"));
  CHECK(has(text, "2584"));
  CHECK(has(text, "432"));  // boundary edges of the paper's mesh: 2 ND - 4 NE
}

TEST_CASE("the summary counts the triangles of a mixed mesh") {
  VariantHistory variant = quadrilaterals();
  variant.cycles[0].exact->triangles = 3;
  variant.cycles[0].exact->elements = 17;
  CHECK(has(as_text(summary_table(history_json("t", {variant}))), "Q+3T"));
}

TEST_CASE("a history without angles can still be tabled") {
  Json history = history_json("t", {example(true)});
  Json& cycle = history["variants"][0]["cycles"][0];
  cycle.erase("angle");
  cycle.erase("scaled_jacobian_min");
  CHECK(has(as_text(summary_table(history)), "(Fig. 13b)"));
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
