#include "drivers/report/terminal_summary.hpp"

#include <sstream>

#include <doctest/doctest.h>

#include "drivers/history/history_json.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

Json statistics() {
  return {{"quality", {{"mean", 0.9}, {"min", 0.5}, {"against", "background"}}},
          {"edge_length", {{"in_unit_band", 99.9}}}};
}

/// A variant that has solved a problem in two cycles.
Json variant(const std::string& name, const Json& settings, int vertices, int dofs,
             const std::string& stop_reason) {
  Json cycle = statistics();
  cycle.update(
      {{"cycle", 2},
       {"vertices", vertices},
       {"dofs", dofs},
       {"error", {{"estimate", 1e-3}, {"relative_energy", nullptr}, {"effectivity", nullptr}}},
       {"goal", nullptr},
       {"values", {{"centre", 0.25}}}});
  return {
      {"name", name}, {"settings", settings}, {"stop_reason", stop_reason}, {"cycles", {cycle}}};
}

Json comparison(const Json& settings) {
  return {{"settings", settings},
          {"against", "true"},
          {"error", 1e-2},
          {"isotropic", {{"vertices", 1000}, {"dofs", 4000}}},
          {"anisotropic", {{"vertices", 250}, {"dofs", 1000}}},
          {"ratio", {{"vertices", 0.25}, {"dofs", 0.25}}}};
}

Json history(const std::vector<Json>& variants, const std::vector<Json>& comparisons = {}) {
  return {{"variants", variants}, {"comparison", comparisons}};
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
}

/// Supports as they are varied: several keys at once, named in the variants only.
std::vector<Json> sweep(int count) {
  std::vector<Json> variants;
  for (int i = 0; i < count; ++i) {
    const std::string support = i % 2 == 0 ? "soft" : "free-edges";
    const Json settings{{"problem.boundary.left", support + "-support-with-a-long-name"},
                        {"problem.boundary.right", support + "-support-with-a-long-name"}};
    variants.push_back(variant("0.1-" + std::to_string(i) + "-" + support, settings, 100, 700,
                               i == 0 ? "interrupted" : "finished after 2 cycles"));
  }
  return variants;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("what every row says is said once and what is unknown is left out") {
  const std::string text =
      terminal_summary(history({variant("a", {}, 100, 700, "finished after 2 cycles"),
                                variant("b", {}, 200, 1500, "finished after 2 cycles")}),
                       80);
  CHECK(text ==
        "variant  vertices  dofs   estimate  unit band %\n"
        "-------  --------  ----  ---------  -----------\n"
        "a             100   700  1.000e-03         99.9\n"
        "b             200  1500  1.000e-03         99.9\n"
        "finished after 2 cycles\n"
        "\n"
        "variant  centre\n"
        "-------  ------\n"
        "a          0.25\n"
        "b          0.25\n");
}

TEST_CASE("variants that end in different ways say so") {
  const std::string text =
      terminal_summary(history({variant("a", {}, 100, 100, "finished after 2 cycles"),
                                variant("b", {}, 200, 200, "failed: no mesh")}),
                       120);
  CHECK(has(text, "failed: no mesh\n"));
  CHECK(has(text, "cycles"));
  CHECK_FALSE(has(text, "dofs"));  // the vertices again
}

TEST_CASE("tables fit narrow terminals and keep what matters most") {
  const std::string name(30, 'n');
  const Json two = history({variant(name, {}, 100, 700, "finished after 2 cycles"),
                            variant("b", {}, 200, 1500, "interrupted")},
                           {comparison({{"eps", "0.01"}})});
  for (const int columns : {70, 80, 100, 120}) {
    const std::string text = terminal_summary(two, columns);
    CHECK(widest_line(text) <= static_cast<std::size_t>(columns));
    for (const char* part : {"vertices", "stopped", "interrupted", "0.2500", "at equal true error"})
      CHECK_MESSAGE(has(text, part), text);
  }
  CHECK(has(terminal_summary(two, 120), "iso dofs"));
  CHECK_FALSE(has(terminal_summary(two, 70), "iso dofs"));
}

TEST_CASE("of many variants only the comparisons are shown") {
  const auto variants = sweep(40);
  const Json many =
      history(variants, {comparison(variants[0]["settings"]), comparison(variants[1]["settings"])});
  const std::string text = terminal_summary(many, 80);
  CHECK(text.starts_with("40 variants: 1 interrupted, 39 finished after 2 cycles\n\n"));
  CHECK_FALSE(has(text, "centre"));
  CHECK(widest_line(text) <= 80);
  // Long settings are told by what the names of the variants have in common.
  CHECK(has(text, "\n0.1-soft "));
  CHECK(has(text, "\n0.1-free-edges "));
  CHECK(has(terminal_summary(history(sweep(30)), 80), "0.1-29-free-edges"));
}

TEST_CASE("the table of the paper is for prescribed metrics only") {
  VariantHistory prescribed;
  prescribed.name = "main";
  prescribed.cycles.resize(1);
  prescribed.cycles[0].background.vertices = 525;
  prescribed.cycles[0].exact = prescribed.cycles[0].background;
  prescribed.stop_reason = "finished after 5 cycles";
  const std::string paper = terminal_summary(history_json("t", {prescribed}), 200);
  CHECK(has(paper, "0.5-1.5 %"));
  CHECK_FALSE(has(paper, "effectivity"));
  CHECK_FALSE(has(terminal_summary(history_json("t", {prescribed}), 60), "unit band %"));
  prescribed.cycles[0].exact.reset();
  prescribed.cycles[0].dofs = 525;
  const std::string solved = terminal_summary(history_json("t", {prescribed}), 200);
  CHECK_FALSE(has(solved, "0.5-1.5 %"));
  CHECK(has(solved, "unit band %"));
}

TEST_CASE("a history without a single cycle has a summary") {
  Json failed = variant("a", {}, 1, 1, "failed: no mesh");
  failed["cycles"] = Json::array();
  CHECK(has(terminal_summary(history({failed}), 80), "failed: no mesh"));
  CHECK(terminal_summary(history({}), 80) == "");
}

TEST_SUITE_END();
