#include "drivers/commands/metric_explanation.hpp"

#include <doctest/doctest.h>

#include "tests/drivers/program_call.hpp"
#include "tests/drivers/result_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const std::string kAdapt = "cycles = 2\ntarget = { nodes = 100 }";

/// What `metric explain` says about a study.
Result explain(const std::string& study, std::vector<std::string> more) {
  const TemporaryFolder folder;
  more.insert(more.begin(), {"metric", "explain", folder.write("s.toml", study).string()});
  return call(more);
}

std::string with_limits(const std::string& limits) {
  return small_problem(kAdapt + "\nlimits = { " + limits + " }");
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the limit that sets the sizes is named") {
  const Result small = explain(with_limits("hmax = 0.01, gradation = false"), {"--at", "0.5,0.5"});
  CHECK(small.code == 0);
  CHECK(has(small.out, "main at (0.5, 0.5), on the mesh of cycle 0"));
  CHECK(has(small.out, "The size 0.01 along"));
  CHECK(has(small.out, "is set by hmax"));
  const Result large =
      explain(with_limits("hmin = 0.2, hmax = 0.3, gradation = false"), {"--at", "0.01,0.5"});
  CHECK(has(large.out, "The size 0.2 along"));
  CHECK(has(large.out, "is set by hmin"));
  const Result free = explain(with_limits("gradation = false"), {"--at", "0.5,0.5"});
  CHECK(has(free.out, "is set by the error"));
}

TEST_CASE("the table shows every stage and which sizes it set") {
  const Result result = explain(with_limits("hmax = 0.01"), {"--at", "0.5,0.5"});
  for (const char* stage : {"density", "scaled", "size limits", "stretch limit", "gradation"})
    CHECK_MESSAGE(has(result.out, std::string("\n") + stage), stage);
  const std::size_t row = result.out.find("\nsize limits");
  const std::string limits = result.out.substr(row + 1, result.out.find('\n', row + 1) - row);
  CHECK(has(limits, " h1 h2 "));
  CHECK(has(limits, " 0.01  "));
}

TEST_CASE("the entry of a prescribed list that sets a size is named") {
  const std::string study = std::string(kTinyStudy);
  const std::string list =
      "metric.prescribed=[{ h1 = \"0.1+x*0\", h2 = \"1\" }, "
      "{ h1 = \"0.2\", h2 = \"2\", e1 = [\"0\", \"1\"] }]";
  const Result result = explain(study, {"--at", "0.5,0.5", "--set", list});
  CHECK(result.code == 0);
  CHECK(has(result.out, "The size 0.1 along (1, 0) is set by prescribed[0]."));
  CHECK(has(result.out, "The size 0.2 across is set by prescribed[1]; before it was 1."));
  CHECK(has(result.out, "The formulas themselves ask for 0.1 and 0.2 there"));
  CHECK(has(result.out, "prescribed[1]: h1 = \"0.2\", h2 = \"2\", e1 = [\"0\", \"1\"]"));
  const Result limited =
      explain(study, {"--at", "0.5,0.5", "--set", list, "--set", "adapt.limits={ hmax = 0.15 }"});
  CHECK(has(limited.out, "The size 0.15 across is set by hmax; before it was 0.2."));
}

TEST_CASE("a point outside the domain is refused and the nearest one proposed") {
  const Result result = explain(small_problem(kAdapt), {"--at", "-0.5,0.25"});
  CHECK(result.code == 3);
  CHECK(has(result.err,
            "--at -0.5,0.25: lies outside the domain; the nearest point of it is "
            "--at 0,0.25"));
  CHECK(explain(small_problem(kAdapt), {"--at", "0,0.25"}).code == 0);
  for (const char* bad : {"1", "1,", "1;2", "1,2,3", "a,b", "inf,0", ""})
    CHECK_MESSAGE(explain(small_problem(kAdapt), {"--at", bad}).code == 3, bad);
}

TEST_CASE("points of curved domains are inside although the mesh cuts corners") {
  const std::string disc = R"(title = "disc"
[domain]
curves.rim = { circle = { centre = [0, 0], radius = 1 } }
regions.disc = { boundary = ["rim"] }
[mesh]
initial_size = 0.5
[problem]
kind = "poisson"
source = 1
boundary.rim = { value = 0 }
[adapt]
target = { nodes = 100 }
)";
  const double s = 0.99995 / std::sqrt(2.);
  const std::string near = std::to_string(s) + "," + std::to_string(s);
  CHECK(explain(disc, {"--at", near}).code == 0);
  CHECK(explain(disc, {"--at", "0.9,0.9"}).code == 3);
}

TEST_CASE("the mesh of an earlier cycle and a variant can be asked for") {
  const TemporaryFolder folder;
  const auto study = folder.write(
      "s.toml",
      small_problem(kAdapt, "[vary]\n\"adapt.mode\" = [\"isotropic\", \"anisotropic\"]\n"));
  const auto dir = folder.path() / "r";
  REQUIRE(call({"run", study.string(), "-q", "-o", dir.string()}).code == 0);
  const std::string mesh = (dir / "anisotropic/cycle-1.msh").string();
  const auto ask = [&](const std::string& variant) {
    return call({"metric", "explain", study.string(), "--at", "0.3,0.4", "--mesh", mesh,
                 "--variant", variant});
  };
  CHECK(has(ask("anisotropic").out, "anisotropic at (0.3, 0.4), on the mesh of cycle 1 ("));
  CHECK(ask("isotropic").code == 0);
  const Result wrong = ask("anisotropc");
  CHECK(wrong.code == 3);
  CHECK(has(wrong.err, "did you mean \"anisotropic\"?"));
  CHECK(has(call({"metric", "explain", study.string(), "--at", "0.3,0.4"}).out,
            "this is isotropic (--variant NAME takes another)"));
}

TEST_SUITE_END();
