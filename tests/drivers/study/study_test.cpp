#include "drivers/study/study.hpp"

#include <numbers>

#include <doctest/doctest.h>

#include "drivers/problem/loop_input.hpp"
#include "drivers/study/study_file.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

Study parse(const std::string& text) { return parse_study(toml::parse(text), "s.toml"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string failure(const std::string& text) {
  return message_of<UsageError>([&] { parse(text); });
}

NurbsCurve curve(const std::string& entry) {
  const toml::table table = toml::parse("c = " + entry);
  return parse_curve(TomlTable(*table.get_as<toml::table>("c"), "c", "s.toml"));
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a study becomes plain structs") {
  const Study study = parse(kTinyStudy);
  CHECK(study.title == "tiny");
  CHECK(study.adapt.cycles == 2);
  CHECK(study.initial.size == 0.5);
  CHECK(study.preset == Preset::best);
  CHECK(study.interpolation == Interpolation::linear_size);
  REQUIRE(study.domain.regions.size() == 1);
  CHECK(signed_area(study.domain, study.domain.regions[0].loops[0]) == doctest::Approx(1));
  REQUIRE(study.metric);
  CHECK(study.metric->list.front().h2.text == "h1");
  CHECK(study.output.formats == std::vector<std::string>{"msh"});
}

TEST_CASE("the preset paper brings its own interpolation") {
  const std::string text = replaced(kTinyStudy, "[metric]", "preset = \"paper\"\n[metric]");
  CHECK(parse(text).interpolation == Interpolation::simultaneous_reduction);
}

TEST_CASE("an unknown key is an error with line column and the nearest name") {
  CHECK(failure(replaced(kTinyStudy, "cycles = 2", "cycels = 2")) ==
        "s.toml:10:1: unknown key \"adapt.cycels\"; did you mean \"cycles\"?");
  CHECK(has(failure(replaced(kTinyStudy, "initial_size", "inital_size")),
            "s.toml:6:1: unknown key \"mesh.inital_size\"; did you mean \"initial_size\"?"));
  CHECK(has(failure(replaced(kTinyStudy, "h2 =", "e2 = \"0\", h2 =")),
            "unknown key \"metric.prescribed[0].e2\""));
  CHECK(has(failure(replaced(kTinyStudy, "{ polyline", "{ polylin")),
            "unknown key \"domain.curves.around.polylin\"; did you mean \"polyline\"?"));
}

TEST_CASE("a misspelt required key is called misspelt and not missing") {
  CHECK(has(message_of<UsageError>([] { curve("{ circle = { centre = [0,0], raduis = 1 } }"); }),
            "unknown key \"c.circle.raduis\"; did you mean \"radius\"?"));
  CHECK(has(message_of<UsageError>([] { curve("{ circle = { centre = [0,0] } }"); }),
            "the key \"c.circle.radius\" is missing"));
}

TEST_CASE("wrong values say what was found and what was expected") {
  CHECK(failure(replaced(kTinyStudy, "cycles = 2", "cycles = \"two\"")) ==
        "s.toml:10:10: adapt.cycles: expected a whole number, 0 to 2000000000, found the text "
        "\"two\"");
  CHECK(has(failure(replaced(kTinyStudy, "0.5", "-0.5")), "mesh.initial_size: must be positive"));
  CHECK(has(failure(replaced(kTinyStudy, "0.5", "nan")), "expected a finite number"));
  CHECK(has(failure(replaced(kTinyStudy, "[1, 0]", "[1]")), "point 2 of the list"));
  CHECK(has(failure(replaced(kTinyStudy, "[\"around\"]", "[\"arround\"]")),
            "no curve is called \"arround\"; did you mean \"around\"?"));
}

TEST_CASE("the elements and how to make them come from the file") {
  const auto with = [](const std::string& keys) {
    return replaced(kTinyStudy, "[metric]", keys + "\n[metric]");
  };
  CHECK(parse(kTinyStudy).elements == Elements::triangle);
  const Study quads = parse(with("elements = \"quadrilateral\""));
  CHECK(quads.elements == Elements::quadrilateral);
  CHECK(quads.quads.method == QuadMethod::best);
  CHECK(quads.quads.effort == QuadEffort::best);
  CHECK(quads.quads.start == QuadStart::automatic);
  const Study chosen =
      parse(with("elements = \"mixed\"\nquad_method = \"paper\"\nquad_effort = \"fast\"\n"
                 "quad_start = \"right-angle\""));
  CHECK(chosen.elements == Elements::mixed);
  CHECK(chosen.quads.method == QuadMethod::paper);
  CHECK(chosen.quads.effort == QuadEffort::fast);
  CHECK(chosen.quads.start == QuadStart::right_angle);
}

TEST_CASE("the preset paper makes quadrilaterals as published unless told otherwise") {
  const auto method = [](const std::string& keys) {
    return parse(replaced(kTinyStudy, "[metric]", "preset = \"paper\"\n" + keys + "[metric]"))
        .quads.method;
  };
  CHECK(method("") == QuadMethod::paper);
  CHECK(method("quad_method = \"best\"\n") == QuadMethod::best);
}

TEST_CASE("wrong words about elements are refused with the nearest one") {
  const auto complaint = [](const std::string& keys) {
    return failure(replaced(kTinyStudy, "[metric]", keys + "\n[metric]"));
  };
  CHECK(complaint("elements = \"quadrilatral\"") ==
        "s.toml:7:12: mesh.elements: found \"quadrilatral\", expected one of: triangle, "
        "quadrilateral, mixed; did you mean \"quadrilateral\"?");
  CHECK(has(complaint("quad_effort = \"fastest\""), "expected one of: best, fast"));
  CHECK(has(complaint("quad_start = \"right_angle\""), "did you mean \"right-angle\"?"));
  CHECK(has(complaint("quad_efort = \"fast\""), "did you mean \"quad_effort\"?"));
}

TEST_CASE("a study needs a metric or a problem and may have both") {
  CHECK(has(failure(replaced(kTinyStudy,
                             "[metric]\nprescribed = [{ h1 = \"0.2 + 0.1*x\", h2 = \"h1\" }]", "")),
            "needs a [metric] table (prescribed sizes) or a [problem] table"));
  const Study both = parse(replaced(kTinyStudy, "[metric]", "[problem]\n[metric]"));
  CHECK(both.metric.has_value());
  CHECK(both.problem.has_value());
}

TEST_CASE("the row of the paper fits mode and elements") {
  const auto row = [](const std::string& mode, const std::string& elements) {
    return parse(replaced(replaced(kTinyStudy, "cycles = 2", "mode = \"" + mode + "\""), "[metric]",
                          "elements = \"" + elements + "\"\n[metric]") +
                 "[report.paper]\nisotropic = { triangle = \"13b\", quadrilateral = \"13c\" }\n"
                 "anisotropic = { triangle = \"13d\", quadrilateral = \"13e\" }\n")
        .paper_row;
  };
  CHECK(row("isotropic", "triangle") == "13b");
  CHECK(row("isotropic", "quadrilateral") == "13c");
  CHECK(row("anisotropic", "triangle") == "13d");
  CHECK(row("anisotropic", "quadrilateral") == "13e");
  CHECK(row("anisotropic", "mixed") == "");
}

TEST_CASE("a row of triangles does not stand beside quadrilaterals") {
  const std::string text = std::string(kTinyStudy) + "[report]\npaper = \"12b\"\n";
  CHECK(parse(text).paper_row == "12b");
  CHECK(parse(replaced(text, "[metric]", "elements = \"quadrilateral\"\n[metric]")).paper_row ==
        "");
  CHECK(has(failure(replaced(text, "12b", "12z")), "the paper has no row \"12z\""));
  CHECK(has(failure(replaced(text, "\"12b\"", "{ triangle = \"12b\", quadrilateral = \"99q\" }")),
            "the paper has no row \"99q\""));
  CHECK(has(failure(replaced(text, "\"12b\"", "{ triangles = \"12b\" }")),
            "did you mean \"triangle\"?"));
}

TEST_CASE("the elements can vary") {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "v.toml", std::string(kTinyStudy) +
                    "[vary]\n\"mesh.elements\" = [\"triangle\", \"quadrilateral\", \"mixed\"]\n");
  const StudyFile file = read_study_file(path);
  REQUIRE(file.variants.size() == 3);
  CHECK(file.variants[0].study.elements == Elements::triangle);
  CHECK(file.variants[1].study.elements == Elements::quadrilateral);
  CHECK(file.variants[1].name == "quadrilateral");
  CHECK(file.variants[2].study.elements == Elements::mixed);
}

TEST_CASE("contradictions are refused") {
  CHECK(has(failure(replaced(kTinyStudy, "cycles = 2", "target = { nodes = 10 }")),
            "leave target out"));
}

TEST_CASE("every kind of curve has the points geometry says") {
  CHECK(evaluate(curve("{ line = [[1, 2], [3, 4]] }"), 0.5) == Point{2, 3});
  const NurbsCurve arc = curve("{ arc = { centre = [0, 0], radius = 2, start = 0, end = 90 } }");
  CHECK(norm(evaluate(arc, arc.end_parameter()) - Point{0, 2}) < 1e-14);
  CHECK(arc_length(arc, arc.begin_parameter(), arc.end_parameter()) ==
        doctest::Approx(std::numbers::pi));
  const NurbsCurve ellipse =
      curve("{ ellipse = { centre = [1, 0], radii = [3, 1], rotation = 90 } }");
  CHECK(norm(evaluate(ellipse, ellipse.begin_parameter()) - Point{1, 3}) < 1e-13);
  const NurbsCurve circle = curve("{ circle = { centre = [1, 1], radius = 1 } }");
  CHECK(is_closed(circle));
  const NurbsCurve quarter = curve(
      "{ nurbs = { degree = 2, knots = [0,0,0,1,1,1], weights = [1,0.7071067811865476,1], "
      "points = [[1,0],[1,1],[0,1]] } }");
  CHECK(norm(evaluate(quarter, 0.3)) == doctest::Approx(1));  // on the unit circle
  CHECK(evaluate(curve("{ spline = [[0,0],[1,1],[2,0]] }"), 1) == Point{1, 1});
}

TEST_CASE("a curve is of exactly one kind") {
  CHECK_THROWS_AS(curve("{}"), UsageError);
  CHECK_THROWS_AS(curve("{ line = [[0,0],[1,0]], spline = [[0,0],[1,0]] }"), UsageError);
  CHECK_THROWS_AS(curve("{ line = [[0,0],[1,0],[2,0]] }"), UsageError);
  CHECK_THROWS_AS(curve("{ nurbs = { degree = 2, knots = [0,1], points = [[0,0]] } }"), UsageError);
}

TEST_CASE("regions holes embedded curves and points come from the file") {
  const Study study = parse(R"(
    [domain]
    curves.outer = { polyline = [[0,0],[4,0],[4,4],[0,4],[0,0]] }
    curves.hole = { circle = { centre = [1,1], radius = 0.5 } }
    curves.crack = { line = [[2,2],[3,3]] }
    regions.plate = { boundary = ["outer"], holes = [["hole"]], embedded = ["crack"] }
    points.gauge = [3, 1]
    [mesh]
    initial_size = 1
    [metric]
    prescribed = [{ h1 = 1, h2 = 1 }])");
  const DomainRegion& region = study.domain.regions.at(0);
  CHECK(region.loops.size() == 2);
  CHECK(signed_area(study.domain, region.loops[1]) == doctest::Approx(-0.25 * std::numbers::pi));
  CHECK(region.embedded_curves == std::vector<Index>{2});
  CHECK(study.domain.points.at(0).point == Point{3, 1});
}

TEST_CASE("the metric of the mode is chosen") {
  const auto text = [](const std::string& mode) {
    return replaced(replaced(kTinyStudy, "[metric]\n",
                             "[metric]\nisotropic.prescribed = [{ h1 = 1, h2 = 1 }]\nanisotropic."),
                    "cycles = 2", "mode = \"" + mode + "\"");
  };
  CHECK(parse(text("isotropic")).metric->list.front().h1.text == "1");
  CHECK(parse(text("anisotropic")).metric->list.front().h1.text == "0.2 + 0.1*x");
}

TEST_CASE("the variants are the cartesian product with the last key fastest") {
  const TemporaryFolder folder;
  const auto path = folder.write("v.toml", std::string(kTinyStudy) +
                                               "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n"
                                               "\"adapt.cycles\" = [1, 3, 5]\n");
  const StudyFile file = read_study_file(path);
  std::vector<std::string> names;
  for (const Variant& variant : file.variants) names.push_back(variant.name);
  CHECK(names ==
        std::vector<std::string>{"best-1", "best-3", "best-5", "paper-1", "paper-3", "paper-5"});
  CHECK(file.variants[4].study.adapt.cycles == 3);
  CHECK(file.variants[4].study.preset == Preset::paper);
}

TEST_CASE("numbers that vary name their variants as they are written") {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "v.toml", std::string(kTinyStudy) + "[vary]\n\"adapt.limits.hmax\" = [0.1, 2.0, 1e-7]\n");
  const StudyFile file = read_study_file(path);
  REQUIRE(file.variants.size() == 3);
  CHECK(file.variants[0].name == "0.1");
  CHECK(file.variants[0].study.adapt.limits.hmax == 0.1);
  CHECK(file.variants[1].name == "2.0");
  CHECK(file.variants[2].name == "1e-07");
  CHECK(file.variants[2].study.adapt.limits.hmax == 1e-7);
}

namespace {

const char* const kAlternatives = R"([vary]
"mesh.preset" = ["best", "paper"]
[vary.kind]
long = { adapt.cycles = 7, metric.prescribed = [{ h1 = 1, h2 = 1 }] }
as-is = {}
"on quads" = { "mesh.elements" = "quadrilateral", adapt = { limits.hmax = 0.5 } }
)";

StudyFile with_alternatives(const TemporaryFolder& folder, const std::vector<std::string>& set) {
  std::string text(kTinyStudy);
  text.append(kAlternatives);
  return read_study_file(folder.write("v.toml", text), parse_overrides(set));
}

std::vector<std::string> names_of(const StudyFile& file) {
  std::vector<std::string> names;
  for (const Variant& variant : file.variants) names.push_back(variant.name);
  return names;
}

}  // namespace

TEST_CASE("named alternatives set several keys at once") {
  const TemporaryFolder folder;
  const StudyFile file = with_alternatives(folder, {});
  CHECK(names_of(file) == std::vector<std::string>{"best-long", "best-as-is", "best-on_quads",
                                                   "paper-long", "paper-as-is", "paper-on_quads"});
  CHECK(file.variants[0].study.adapt.cycles == 7);
  CHECK(file.variants[0].study.metric->list.front().h1.text == "1");
  CHECK(file.variants[1].study.adapt.cycles == 2);
  CHECK(file.variants[4].study.preset == Preset::paper);
  CHECK(file.variants[5].study.elements == Elements::quadrilateral);
  CHECK(file.variants[5].study.adapt.limits.hmax == 0.5);
  CHECK(file.variants[5].study.adapt.cycles == 2);
}

TEST_CASE("--set chooses an alternative or takes its keys out of all") {
  const TemporaryFolder folder;
  CHECK(names_of(with_alternatives(folder, {"vary.kind=long"})) ==
        std::vector<std::string>{"best-long", "paper-long"});
  CHECK(has(message_of<UsageError>([&] { with_alternatives(folder, {"vary.kind=lang"}); }),
            "no alternative is called \"lang\"; did you mean \"long\"?"));
  const StudyFile shorter = with_alternatives(folder, {"adapt.cycles=3", "mesh.preset=best"});
  CHECK(names_of(shorter) == std::vector<std::string>{"long", "as-is", "on_quads"});
  CHECK(shorter.variants[0].study.adapt.cycles == 3);
  // Nothing is left that differs.
  CHECK(names_of(with_alternatives(folder, {"adapt={}", "metric.prescribed=[{ h1 = 1, h2 = 1 }]",
                                            "mesh.preset=best", "mesh.elements=triangle"})) ==
        std::vector<std::string>{"main"});
}

TEST_CASE("entries of vary that are neither lists nor alternatives are refused") {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& vary) {
    return message_of<Error>(
        [&] { read_study_file(folder.write("v.toml", kTinyStudy + ("[vary]\n" + vary))); });
  };
  CHECK(has(complaint("adapt.mode = [\"isotropic\"]"), "v.toml:12:14: vary.adapt.mode: expected"));
  CHECK(has(complaint("adapt.mode = [\"isotropic\"]"), "a key with dots needs \"quotes\""));
  CHECK(has(complaint("kind = 3"), "vary.kind: expected a list of values"));
  CHECK(has(complaint("kind = {}"), "vary.kind: expected a list of values"));
  CHECK(has(complaint("\"adapt.cycles\" = [1, 1]"), "1 stands there twice"));
  CHECK(has(complaint("kind.a = { adapt.cycels = 1 }"), "unknown key \"adapt.cycels\""));
  CHECK(has(complaint("kind.a = { adapt.cycels = 1 }"), "(with [vary] adapt.cycels = 1)"));
}

TEST_CASE("--set replaces values and takes bare words") {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "v.toml", std::string(kTinyStudy) + "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n");
  const StudyFile file = read_study_file(
      path, {parse_override("mesh.preset=paper"), parse_override("adapt.limits.hmax=0.25")});
  REQUIRE(file.variants.size() == 1);  // a key that is set varies no longer
  CHECK(file.variants[0].study.preset == Preset::paper);
  CHECK(file.variants[0].study.adapt.limits.hmax == 0.25);
  CHECK(has(file.resolved, "hmax = 0.25"));
  const std::string unknown =
      message_of<Error>([&] { read_study_file(path, {parse_override("mesh.presett=paper")}); });
  CHECK(has(unknown, "unknown key \"mesh.presett\"; did you mean \"preset\"?"));
  CHECK(has(unknown, "--set mesh.presett = paper"));
  CHECK_THROWS_AS(parse_override("mesh.preset"), UsageError);
  CHECK_THROWS_AS(parse_override("=paper"), UsageError);
  CHECK_THROWS_AS(parse_override("a..b=1"), UsageError);
}

TEST_CASE("broken TOML is reported with line and column") {
  const TemporaryFolder folder;
  const auto path = folder.write("broken.toml", "title = \"a\"\n[domain\n");
  const std::string message = message_of<UsageError>([&] { read_study_file(path); });
  CHECK(has(message, "broken.toml:2:"));
  CHECK(has(message, "not valid TOML"));
}

TEST_CASE("all studies that we ship can be read") {
  int count = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ANISOFRONT_DATA "/studies"))
    if (entry.path().extension() == ".toml") {
      CAPTURE(entry.path());
      CHECK_FALSE(read_study_file(entry.path()).variants.empty());
      ++count;
    }
  CHECK(count >= 15);
}

TEST_SUITE_END();
