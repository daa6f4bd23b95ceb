#include "drivers/report/result_tables.hpp"

#include <doctest/doctest.h>

#include "drivers/history/history_csv.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

VariantHistory solved(const std::string& name, const std::string& mode, Index vertices,
                      double error) {
  CycleRecord record;
  record.cycle = 5;
  record.dofs = 2 * vertices;
  record.background.vertices = vertices;
  record.background.percent_unit = 99.98;
  record.error = {1.1 * error, error, 1.1};
  record.values = {{"centre", 0.00406235}};
  VariantHistory variant;
  variant.name = name;
  variant.settings = {{"adapt.mode", mode}, {"problem.thickness", "0.1"}};
  variant.cycles = {record};
  variant.stop_reason = "finished after 5 cycles";
  return variant;
}

/// Isotropic meshes need ten times as many vertices.
std::vector<VariantHistory> two_modes() {
  return {solved("iso", "isotropic", 1000, 0.01), solved("aniso", "anisotropic", 100, 0.01)};
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a problem is summed up in one row with the reason of stopping") {
  const TextTable table = result_table(history_json("t", two_modes()));
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0] == std::vector<std::string>{"iso", "5", "1000", "2000", "1.100e-02",
                                                  "1.000e-02", "1.100", "99.9",
                                                  "finished after 5 cycles"});
  CHECK(as_text(table).find("finished after 5 cycles\n") != std::string::npos);
}

TEST_CASE("unknown errors are dashes and a variant without a cycle says why") {
  VariantHistory bare = solved("bare", "isotropic", 10, 1);
  bare.cycles[0].error = {};
  VariantHistory failed;
  failed.name = "bad";
  failed.stop_reason = "failed: no mesh";
  const TextTable table = result_table(history_json("t", {bare, failed}));
  CHECK(table.rows[0][4] == "-");
  CHECK(table.rows[0][6] == "-");
  CHECK(table.rows[1].front() == "bad");
  CHECK(table.rows[1].back() == "failed: no mesh");
}

TEST_CASE("goal and named values have a table of their own") {
  std::vector<VariantHistory> variants = two_modes();
  variants[1].cycles[0].goal = GoalRecord{0.5, -1e-4};
  variants[1].cycles[0].values = {{"energy", 2}};
  const TextTable table = value_table(history_json("t", variants));
  CHECK(table.header ==
        std::vector<std::string>{"variant", "goal", "goal error", "centre", "energy"});
  CHECK(table.rows[0] == std::vector<std::string>{"iso", "-", "-", "0.00406235", "-"});
  CHECK(table.rows[1] == std::vector<std::string>{"aniso", "0.5", "-1.00e-04", "-", "2"});
}

TEST_CASE("the comparison at equal error is in history tables and CSV") {
  const Json history = history_json("t", two_modes());
  REQUIRE(history["comparison"].size() == 1);
  const Json& comparison = history["comparison"][0];
  CHECK(comparison["against"] == "true");
  CHECK(comparison["error"] == 0.01);
  CHECK(comparison["settings"] == Json{{"problem.thickness", 0.1}});
  CHECK(comparison["isotropic"]["vertices"] == 1000);
  CHECK(comparison["anisotropic"]["dofs"] == 200);
  CHECK(comparison["ratio"]["vertices"] == 0.1);
  const TextTable table = comparison_table(history);
  REQUIRE(table.rows.size() == 1);
  CHECK(table.rows[0] == std::vector<std::string>{"all", "true", "1.000e-02", "1000", "100",
                                                  "0.1000", "2000", "200", "0.1000"});
  CHECK(comparison_csv(history) ==
        "settings,against,error,isotropic_vertices,anisotropic_vertices,vertex_ratio,"
        "isotropic_dofs,anisotropic_dofs,dof_ratio\n"
        "\"problem.thickness = 0.1\",\"true\",0.01,1000.0,100.0,0.1,2000.0,200.0,0.1\n");
}

TEST_CASE("comparisons are told apart by the settings that differ") {
  std::vector<VariantHistory> variants = two_modes();
  for (VariantHistory variant : two_modes()) {
    variant.settings[1].second = "0.01";
    variant.settings.emplace_back("mesh.quad_method", "best");
    variants.push_back(variant);
  }
  const TextTable table = comparison_table(history_json("t", variants));
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0][0] == "thickness = 0.1");
  CHECK(table.rows[1][0] == "thickness = 0.01");
}

TEST_CASE("the console shows only tables that say something") {
  const std::string both = console_summary(history_json("t", two_modes()));
  CHECK(has(both, "unit band %"));
  CHECK(has(both, "at equal error"));
  CHECK_FALSE(has(both, "0.5-1.5 %"));  // the columns of the paper
  VariantHistory prescribed = two_modes()[0];
  prescribed.cycles[0].exact = prescribed.cycles[0].background;
  prescribed.cycles[0].dofs = 0;
  prescribed.cycles[0].error = {};
  prescribed.cycles[0].values.clear();
  const std::string paper = console_summary(history_json("t", {prescribed}));
  CHECK(has(paper, "0.5-1.5 %"));
  CHECK_FALSE(has(paper, "effectivity"));
  CHECK_FALSE(has(paper, "at equal error"));
  VariantHistory failed;
  failed.name = "bad";
  failed.stop_reason = "failed: no mesh";
  CHECK(has(console_summary(history_json("t", {failed})), "failed: no mesh"));
}

TEST_SUITE_END();
