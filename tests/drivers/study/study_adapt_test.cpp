#include "drivers/study/study_adapt.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "drivers/problem/adapt_setup.hpp"
#include "drivers/problem/loop_input.hpp"
#include "tests/drivers/problem_studies.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const std::string kHeld =
    "boundary.bottom = { value = 0 }\nboundary.right = { value = 0 }\n"
    "boundary.top = { value = 0 }\nboundary.left = { value = 0 }";
const std::string kPlate =
    "kind = \"mindlin\"\nthickness = 0.1\nyoung = 1\npoisson_ratio = 0.3\n"
    "boundary.bottom = \"clamped\"\nboundary.left = \"soft-support\"\nboundary.top = \"free\"";

/// The table [adapt] starts on line 17.
Study scalar_study(const std::string& adapt) {
  return parse_text(square_study(kHeld, "[adapt]\n" + adapt));
}
Study plate_study(const std::string& adapt) {
  return parse_text(square_study(kPlate, "[adapt]\n" + adapt));
}
std::string failure(const std::string& adapt) {
  return parse_failure(square_study(kHeld, "[adapt]\n" + adapt));
}
std::string setup_failure(const Study& study) {
  return message_of<UsageError>([&] { loop_input(study); });
}

std::vector<std::string> names_of_tags(const Domain& domain, const std::vector<Index>& tags) {
  std::vector<std::string> names;
  for (const Index tag : tags)
    for (const DomainCurve& curve : domain.curves)
      if (curve.tag == tag) names.push_back(curve.name);
  return names;
}

/// Cycles of a study, errors of the last one.
VariantHistory cycles_of(const std::string& problem, const std::string& rest,
                         const std::string& mesh) {
  return adapt_loop(loop_input(parse_text(square_study(problem, rest, mesh))));
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("all keys of the adapt table are read") {
  const AdaptSection adapt = scalar_study(R"(cycles = 3
mode = "isotropic"
target = { error = 0.02 }
limits = { hmin = 0.01, hmax = 2, stretch = 30, gradation = 1.5 }
norm = "L1.5"
combination = "intersection"
curvature_floor = 1e-3
align = false
equidistribute = false
layer = { curves = ["left"], width = 0.1, first_size = 0.25, reach = 8, growth = 0, metric = true }
goal = { kind = "patch-mean", at = [0.5, 0.25], radius = 0.1, steer = false }
reference = { nodes = 9000 }
plateau = 0.05
budget = { nodes = 5000, seconds = 60 }
stages = true)")
                                 .adapt;
  CHECK(adapt.cycles == 3);
  CHECK(adapt.mode == AdaptMode::isotropic);
  CHECK(adapt.target.error == 0.02);
  CHECK_FALSE(adapt.target.vertices);
  CHECK(adapt.limits.stretch == 30);
  CHECK(adapt.norm == MetricNorm::lp);
  CHECK(adapt.p == 1.5);
  CHECK(adapt.combination == Combination::intersection);
  CHECK(adapt.curvature_floor == 1e-3);
  CHECK_FALSE(adapt.align);
  CHECK_FALSE(adapt.equidistribute);
  CHECK(adapt.layer.growth == 0);
  CHECK(adapt.layer.metric == true);
  REQUIRE(adapt.goal);
  CHECK(adapt.goal->goal.kind == Goal::Kind::patch_mean);
  CHECK(adapt.goal->goal.at == Point{0.5, 0.25});
  CHECK(adapt.goal->goal.radius == 0.1);
  CHECK_FALSE(adapt.goal->steers);
  REQUIRE(adapt.reference);
  CHECK(adapt.reference->nodes == 9000);
  CHECK(adapt.stop.plateau == 0.05);
  CHECK(adapt.stop.max_vertices == 5000);
  CHECK(adapt.stop.max_seconds == 60);
  CHECK(adapt.stages);
}

TEST_CASE("what the adapt table leaves out has defaults") {
  const Study study = scalar_study("target = { nodes = 100 }");
  CHECK(study.adapt.cycles == 5);
  CHECK(study.adapt.target.vertices == 100);
  CHECK_FALSE(study.adapt.goal);
  CHECK_FALSE(study.adapt.reference);
  const AdaptSettings settings = adapt_settings(study, study.domain);
  CHECK(settings.density.mode == AdaptMode::anisotropic);
  CHECK(settings.density.p == 2);
  CHECK(settings.limits.hmin == 0);
  CHECK(std::isinf(settings.limits.stretch));
  CHECK(settings.limits.gradation == 3);
  CHECK(settings.layers.tags.empty());
  CHECK(settings.align);
  CHECK(settings.equidistribute);
  CHECK_FALSE(settings.use_goal);
  CHECK_FALSE(settings.keep_stages);
}

TEST_CASE("limits and layers of plates follow from thickness and supports") {
  const Study study = plate_study("target = { nodes = 100 }");
  const AdaptSettings settings = adapt_settings(study, study.domain);
  CHECK(settings.limits.hmin == doctest::Approx(1e-3));
  CHECK(settings.limits.stretch == 10);  // 0.15 L/t = 1.5, at least 10
  CHECK(settings.limits.gradation == 3);
  // Clamped at the bottom; no condition at the right is a free edge.
  CHECK(names_of_tags(study.domain, settings.layers.tags) ==
        std::vector<std::string>{"left", "top", "right"});
  CHECK(settings.layers.width == doctest::Approx(0.1 / std::sqrt(10.)));
  CHECK(settings.layer_metric);
  const Study isotropic = plate_study("target = { nodes = 100 }\nmode = \"isotropic\"");
  CHECK_FALSE(adapt_settings(isotropic, isotropic.domain).layer_metric);
}

TEST_CASE("a plate cut along a line of symmetry is twice as long") {
  const auto stretch = [](const std::string& right) {
    const Study study = parse_text(
        square_study("kind = \"mindlin\"\nthickness = 0.005\nyoung = 1\npoisson_ratio = 0.3\n"
                     "boundary.left = \"clamped\"\nboundary.right = \"" +
                     right + "\""));
    return problem_limits(study, study.domain).stretch;
  };
  CHECK(stretch("free") == doctest::Approx(30));
  CHECK(stretch("symmetry") == doctest::Approx(60));
}

TEST_CASE("the thinnest region of a plate decides") {
  const Study study = parse_text(square_study(kPlate + "\nregions.square = { thickness = 0.02 }"));
  CHECK(problem_limits(study, study.domain).hmin == doctest::Approx(2e-4));
  CHECK(layer_settings(study, study.domain).width == doctest::Approx(0.02 / std::sqrt(10.)));
}

TEST_CASE("what the study says stands above the defaults of plates") {
  const Study study = plate_study(
      "target = { nodes = 100 }\nlimits = { hmin = false, stretch = 7, gradation = false }\n"
      "layer = { curves = [\"bottom\"], width = 0.5, metric = false }");
  const AdaptSettings settings = adapt_settings(study, study.domain);
  CHECK(settings.limits.hmin == 0);
  CHECK(settings.limits.stretch == 7);
  CHECK(settings.limits.gradation == 0);
  CHECK(names_of_tags(study.domain, settings.layers.tags) == std::vector<std::string>{"bottom"});
  CHECK(settings.layers.width == 0.5);
  CHECK_FALSE(settings.layer_metric);
  const Study off = plate_study("target = { nodes = 100 }\nlayer = false");
  CHECK(layer_settings(off, off.domain).tags.empty());
}

TEST_CASE("mistakes in the adapt table have line column and the full key") {
  CHECK(failure("targt = { nodes = 10 }") ==
        "s.toml:17:1: unknown key \"adapt.targt\"; did you mean \"target\"?");
  CHECK(has(failure("target = { node = 10 }"), "did you mean \"nodes\"?"));
  CHECK(
      has(failure("target = { nodes = 10, error = 0.1 }"), "s.toml:17:10: adapt.target: expected"));
  CHECK(has(failure("target = {}"), "expected one of"));
  CHECK(has(failure("target = { nodes = 0 }"), "adapt.target.nodes: must be positive"));
  CHECK(has(failure("norm = \"L0.5\""), "s.toml:17:8: adapt.norm: found \"L0.5\", expected"));
  CHECK(has(failure("norm = \"2\""), "expected \"energy\" or"));
  CHECK(has(failure("norm = \"L2x\""), "expected \"energy\" or"));
  CHECK(has(failure("combination = \"sum\""), "expected one of: sum-of-squares, intersection"));
  CHECK(has(failure("curvature_floor = 1"), "must be smaller than 1"));
  CHECK(has(failure("limits = { hmin = 2, hmax = 1 }"), "larger than hmax"));
  CHECK(has(failure("limits = { stretch = 0.5 }"), "must be at least 1"));
  CHECK(has(failure("limits = { gradation = 1 }"), "must be larger than 1"));
  CHECK(has(failure("limits = { gradation = true }"), "or false for no limit"));
  CHECK(has(failure("layer = { curve = [\"left\"] }"), "did you mean \"curves\"?"));
  CHECK(has(failure("layer = true"), "s.toml:17:9: adapt.layer: expected false, or a table"));
  CHECK(has(failure("layer = { growth = -1 }"), "must not be negative"));
  CHECK(has(failure("plateau = 2"), "adapt.plateau"));
  CHECK(has(failure("budget = {}"), "expected nodes"));
  CHECK(has(failure("reference = { node = 3 }"), "did you mean \"nodes\"?"));
}

TEST_CASE("a goal says all that its kind needs and nothing else") {
  CHECK(has(failure("goal = { at = [0, 0] }"), "the key \"adapt.goal.kind\" is missing"));
  CHECK(has(failure("goal = { kind = \"patchmean\" }"), "did you mean \"patch-mean\"?"));
  CHECK(has(failure("goal = { kind = \"patch-mean\", at = [0, 0] }"),
            "\"adapt.goal.radius\" is missing"));
  CHECK(has(failure("goal = { kind = \"flux\", region = \"square\", curve = \"left\" }"),
            "unknown key \"adapt.goal.region\""));
  CHECK(has(failure("goal = { kind = \"flux\", curve = \"left\" }\nnorm = \"L2\""),
            "a goal has a metric of its own"));
  CHECK(failure("goal = { kind = \"flux\", curve = \"left\", steer = false }\nnorm = \"L2\"") ==
        "");
  const Study misspelt =
      scalar_study("target = { nodes = 10 }\ngoal = { kind = \"flux\", curve = \"lef\" }");
  CHECK(has(setup_failure(misspelt),
            "s.toml:18:8: adapt.goal.curve: no curve is called \"lef\"; did you mean \"left\"?"));
  const Study region = scalar_study(
      "target = { nodes = 10 }\ngoal = { kind = \"region-mean\", region = \"sqare\" }");
  CHECK(has(setup_failure(region), "did you mean \"square\"?"));
}

TEST_CASE("contradictions between adapt and the rest are refused") {
  const std::string metric = "[metric]\nprescribed = [{ h1 = 1, h2 = 1 }]\n[adapt]\n";
  CHECK(has(parse_failure(square_study(kHeld, metric + "target = { nodes = 10 }")),
            "adapt.target: a prescribed [metric] says itself"));
  std::string without_problem = square_study("", metric + "reference = true");
  without_problem.erase(without_problem.find("[problem]"), 9);
  CHECK(has(parse_failure(without_problem), "adapt.reference: is about the error of a [problem]"));
  CHECK(has(parse_failure(square_study("reaction = 1\nexact = \"product-layer\"\n" + kHeld,
                                       "[adapt]\nreference = true")),
            "the exact solution is known"));
  CHECK(has(parse_failure(square_study(
                "velocity = [1, 0]\n" + kHeld,
                "[adapt]\ngoal = { kind = \"patch-mean\", at = [0.5, 0.5], radius = 0.1 }")),
            "without velocity only"));
}

TEST_CASE("what only the domain can tell is refused before the first cycle") {
  CHECK(has(setup_failure(scalar_study("cycles = 2")), "cycles need adapt.target"));
  CHECK(has(setup_failure(plate_study("cycles = 2")), "anisofront solve s.toml"));
  const std::string layer = "target = { nodes = 10 }\nlayer = { ";
  CHECK(has(setup_failure(scalar_study(layer + "curves = [\"left\"] }")),
            "s.toml:18:9: adapt.layer: expected curves"));
  CHECK(has(setup_failure(scalar_study(layer + "width = 0.1 }")), "expected curves"));
  CHECK(has(setup_failure(scalar_study(layer + "curves = [\"lft\"], width = 0.1 }")),
            "did you mean \"left\"?"));
  const Study outside = parse_text(square_study(
      kHeld,
      "[adapt]\ntarget = { nodes = 10 }\n[output]\nvalues = [{ name = \"p\", at = [2, 0] }]"));
  CHECK(has(setup_failure(outside), "\"p\" at (x, y) = (2, 0) lies outside the domain"));
}

TEST_CASE("cycles run on every kind of element and order") {
  const std::string adapt =
      "[adapt]\ncycles = 2\ntarget = { nodes = 60 }\n[output]\n"
      "values = [{ name = \"mid\", at = [0.5, 0.5] }]";
  const std::string sine = "exact = \"sine-product\"\n" + kHeld;
  const std::string clamped =
      "kind = \"mindlin\"\nthickness = 0.1\nyoung = 10920\npoisson_ratio = 0.3\nload = 1\n"
      "boundary.bottom = \"clamped\"\nboundary.right = \"clamped\"\nboundary.top = \"clamped\"\n"
      "boundary.left = \"clamped\"";
  // sin(pi/2)^2 = 1; the clamped plate with D = 1: FE.md 3.3, t = 0.1.
  struct Row {
    std::string problem, elements;
    double mid, tolerance;
  };
  for (const Row& row :
       {Row{sine, "quadrilateral", 1, 0.05}, Row{"order = 2\n" + sine, "mixed", 1, 2e-3},
        Row{clamped, "triangle", 1.504625668e-3, 5e-3},
        Row{clamped, "quadrilateral", 1.504625668e-3, 5e-3},
        Row{"element = \"mitc4\"\n" + clamped, "quadrilateral", 1.504625668e-3, 0.15},
        Row{"element = \"arnold-falk\"\n" + clamped, "triangle", 1.504625668e-3, 0.1}}) {
    CAPTURE(row.problem);
    CAPTURE(row.elements);
    const VariantHistory history =
        cycles_of(row.problem, adapt, "initial_size = 0.25\nelements = \"" + row.elements + "\"");
    REQUIRE(history.cycles.size() == 3);
    const CycleRecord& last = history.cycles.back();
    CHECK(last.background.vertices > 40);
    CHECK(last.background.vertices < 90);
    CHECK((last.background.triangles == 0) == (row.elements == "quadrilateral"));
    REQUIRE_FALSE(last.values.empty());
    CHECK(last.values[0].name == "mid");
    CHECK(std::abs(last.values[0].value / row.mid - 1) < row.tolerance);
    CHECK(last.error.estimate.value() < 0.4);
  }
}

TEST_CASE("a prescribed metric drives a problem whose errors are recorded") {
  const VariantHistory history =
      cycles_of("exact = \"sine-product\"\n" + kHeld,
                "[metric]\nprescribed = [{ h1 = 0.1, h2 = 0.1 }]\n[adapt]\ncycles = 1",
                "initial_size = 0.25");
  REQUIRE(history.cycles.size() == 2);
  const CycleRecord& last = history.cycles.back();
  REQUIRE(last.exact);
  CHECK(last.exact->percent_unit > 99);
  CHECK(last.dofs == last.background.vertices);
  CHECK(last.error.relative_energy.value() > 0.05);
  CHECK(last.error.relative_energy.value() < 0.2);
}

TEST_CASE("reference errors stand where no exact solution is known") {
  const VariantHistory history = cycles_of(
      "source = 1\n" + kHeld, "[adapt]\ncycles = 2\ntarget = { nodes = 100 }\nreference = true",
      "initial_size = 0.25");
  for (const CycleRecord& cycle : history.cycles) {
    CHECK(cycle.error.relative_energy.value() > 0.02);
    CHECK(cycle.error.effectivity.value() > 0.8);
    CHECK(cycle.error.effectivity.value() < 1.2);
  }
}

TEST_CASE("stages are kept when the study asks for them") {
  const auto stages = [](const std::string& adapt) {
    const LoopInput input = loop_input(scalar_study("target = { nodes = 50 }\n" + adapt));
    return input.analyse(input.initial, 0).stages.size();
  };
  CHECK(stages("") == 0);
  CHECK(stages("stages = true") >= 4);
}

TEST_SUITE_END();
