#include <cmath>

#include <doctest/doctest.h>

#include "drivers/report/figure_label.hpp"
#include "drivers/report/figure_plot.hpp"
#include "drivers/report/figure_series.hpp"
#include "drivers/report/figure_slope.hpp"
#include "drivers/report/figure_table.hpp"
#include "drivers/report/figure_text.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// 3 n^-order at n = 100, 100 factor, ...
std::vector<ErrorPoint> power_law(double order, double factor, int count, double scale = 3) {
  std::vector<ErrorPoint> points;
  for (double n = 100; count-- > 0; n *= factor)
    points.emplace_back(n, scale * std::pow(n, -order));
  return points;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("texts of gnuplot are in single quotes and on one line") {
  CHECK(gnuplot_string("a `b` \"c\" $d") == "'a `b` \"c\" $d'");
  CHECK(gnuplot_string("it's\n'quoted'\t") == "'it''s ''quoted'' '");
  CHECK(gnuplot_string("") == "''");
}

TEST_CASE("names become stems that are safe in a file name") {
  CHECK(file_stem("0.01-fine_2") == "0.01-fine_2");
  CHECK(file_stem("../a b") == "_.._a_b");
  CHECK(file_stem("-rf") == "_-rf");
  CHECK(file_stem("") == "_");
  CHECK(file_stem("é") == "___");
  CHECK(file_stem(std::string(1000, 'a')).size() == 100);
}

TEST_CASE("long texts are cut between characters") {
  CHECK(shortened("Ménage", 6) == "Ménage");
  CHECK(shortened("Ménage", 5) == "Ména…");
  CHECK(shortened("éé", 1) == "…");
  CHECK(character_count("Ména…") == 5);
}

TEST_CASE("short labels stand side by side and long ones below each other") {
  CHECK(legend_layout({}, 8).rows == 0);
  CHECK(legend_layout(std::vector<std::string>(6, "cycle 1"), 8.5).rows == 2);
  CHECK(legend_layout(std::vector<std::string>(6, std::string(40, 'a')), 8.5).rows == 6);
  CHECK(legend_layout({std::string(400, 'a')}, 8.5).rows == 1);
}

TEST_CASE("logarithmic axes run between round numbers") {
  CHECK(log_axis('x', 400, 25000) ==
        "set logscale x\nset xrange [200:50000]\nset format x '10^{%L}'\n");
  CHECK(log_axis('y', 0.0021, 0.0099) ==
        "set logscale y\nset yrange [0.002:0.01]\nset ytics (0.002, 0.005, 0.01)\n");
  CHECK(log_axis('x', 1940, 2000) ==
        "set logscale x\nset xrange [1686.96:2300]\nset xtics (1800, 2000, 2200)\n");
  CHECK(log_axis('y', 1, 1) ==
        "set logscale y\nset yrange [0.869565:1.15]\nset ytics (0.9, 1, 1.1)\n");
  CHECK(has(log_axis('y', 1e-12, 1), "[1e-12:1]"));
}

TEST_CASE("steps are round and cover the length") {
  CHECK(round_step(10, 5) == 2);
  CHECK(round_step(10.1, 5) == 5);
  CHECK(round_step(0.034, 5) == doctest::Approx(0.01));
  for (const double length : {1e-7, 0.3, 7., 2e9}) {
    CHECK(5 * round_step(length, 5) >= length * (1 - 1e-8));
    CHECK(round_step(length, 5) <= length / 2 * (1 + 1e-8));
  }
}

TEST_CASE("the order is measured where the unknowns span enough") {
  CHECK(*measured_order(power_law(0.7, 2, 4)) == doctest::Approx(0.7));
  CHECK(*measured_order(power_law(-0.3, 4, 2)) == doctest::Approx(-0.3));
  CHECK_FALSE(measured_order(power_law(0.7, 1.3, 3)));
  CHECK_FALSE(measured_order({{100, 1}}));
  CHECK_FALSE(measured_order({}));
}

TEST_CASE("reference slopes are halves and lie below their curves") {
  const auto coarse = power_law(0.55, 4, 3), same = power_law(0.47, 4, 4, 2),
             fine = power_law(1.1, 4, 3);
  const auto slopes = reference_slopes({coarse, fine, same, power_law(0.1, 4, 3)});
  REQUIRE(slopes.size() == 2);
  CHECK(slopes[0].order == 0.5);
  CHECK(slopes[1].order == 1);
  CHECK(slopes[0].first == 100);
  CHECK(slopes[0].last == 6400);
  CHECK(slopes[1].last == 1600);
  for (const auto& curve : {coarse, same})
    for (const auto& [n, error] : curve) CHECK(slopes[0].factor * std::pow(n, -0.5) < 0.61 * error);
  CHECK(reference_slopes({}).empty());
}

TEST_CASE("of many curves only the commonest slope is shown below all") {
  std::vector<std::vector<ErrorPoint>> curves(9, power_law(1, 4, 3));
  curves.insert(curves.end(), 4, power_law(0.5, 4, 3, 1e-6));
  const auto slopes = reference_slopes(curves);
  REQUIRE(slopes.size() == 1);
  CHECK(slopes[0].order == 1);
  CHECK(slopes[0].factor * std::pow(100, -1) < 1e-6 * std::pow(100, -0.5));
}

TEST_CASE("labels name only the settings that are needed") {
  const auto settings = [](const char* mode, const char* bottom, const char* right, double t) {
    return Json{{"adapt.mode", mode},
                {"mesh.elements", "triangle"},
                {"problem.boundary.bottom", bottom},
                {"problem.boundary.right", right},
                {"problem.constants.t", t}};
  };
  CHECK(distinguishing_labels({settings("isotropic", "clamped", "clamped", 0.1),
                               settings("anisotropic", "clamped", "clamped", 0.1),
                               settings("anisotropic", "free", "clamped", 0.1),
                               settings("anisotropic", "soft", "soft", 0.1)}) ==
        std::vector<std::string>{"isotropic, bottom = clamped", "anisotropic, bottom = clamped",
                                 "anisotropic, bottom = free", "anisotropic, bottom = soft"});
  CHECK(distinguishing_labels({settings("isotropic", "free", "free", 0.1)}) ==
        std::vector<std::string>{""});
  CHECK(distinguishing_labels({Json{{"mesh.elements", "triangle"}},
                               Json{{"mesh.elements", "quadrilateral"}, {"x.effort", 2}},
                               Json{{"mesh.elements", "quadrilateral"}}}) ==
        std::vector<std::string>{"triangles", "quadrilaterals, effort = 2", "quadrilaterals"});
  CHECK(distinguishing_labels({}).empty());
}

TEST_CASE("looks tell modes by colour and elements by marker") {
  const auto looks = curve_looks({{"a", false, "triangle"},
                                  {"b", true, "triangle"},
                                  {"c", false, "quadrilateral"},
                                  {"d", true, "quadrilateral"}});
  REQUIRE(looks.size() == 4);
  CHECK(looks[0].style == "linestyle 1 pointtype 9");
  CHECK(looks[1].style == "linestyle 11 pointtype 8");
  CHECK(looks[2].style == "linestyle 2 pointtype 5");
  CHECK(looks[3].style == "linestyle 12 pointtype 4");
  CHECK(looks[3].label == "d");
  CHECK(curve_looks({}).empty());
}

TEST_CASE("many curves share the looks of their class and one entry of the legend") {
  std::vector<CurveKind> kinds;
  for (int k = 0; k < 20; ++k)
    kinds.push_back({std::to_string(k), k % 2 == 0, k < 10 ? "triangle" : "mixed"});
  const auto looks = curve_looks(kinds);
  std::vector<std::string> labels;
  for (const CurveLook& look : looks)
    if (!look.label.empty()) labels.push_back(look.label);
  CHECK(labels == std::vector<std::string>{"isotropic, triangles", "anisotropic, triangles",
                                           "isotropic, mixed", "anisotropic, mixed"});
  CHECK(looks[0].style == looks[8].style);
  CHECK(looks[0].style != looks[1].style);
  CHECK(looks[0].style != looks[10].style);
}

TEST_CASE("tables are read with gaps and odd lines") {
  const TemporaryFolder folder;
  const auto path = folder.write("t.csv", "s,u\r\n0,1.5e-3\r\n1\n\n0.5,nonsense\n1,2,3\n");
  const NumberTable table = read_number_table(path);
  CHECK(table.columns == std::vector<std::string>{"s", "u"});
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[0] == std::vector<double>{0, 1.5e-3});
  CHECK(std::isnan(table.rows[1][1]));
  CHECK(table.rows[2][1] == 2);
  CHECK(*column_of(table, "u") == 1);
  CHECK_FALSE(column_of(table, "v"));
  CHECK(read_number_table(folder.write("empty.csv", "")).rows.empty());
}

TEST_SUITE_END();
