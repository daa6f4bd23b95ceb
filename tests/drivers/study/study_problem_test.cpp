#include "drivers/study/study_problem.hpp"

#include <numbers>

#include "drivers/problem/scalar_setup.hpp"
#include "tests/drivers/problem_studies.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

ScalarProblem problem_of(const Study& study) {
  return scalar_problem(*study.problem, study.domain, known_solution(*study.problem));
}

std::string failure(const std::string& problem) { return parse_failure(square_study(problem)); }

/// The message of the UsageError that the names of the domain bring to light.
std::string setup_failure(const std::string& problem) {
  const Study study = parse_text(square_study(problem));
  return message_of<UsageError>([&] { problem_of(study); });
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("coefficients are numbers or expressions of x y and the names of the study") {
  const ScalarProblem problem = problem_of(parse_text(square_study(R"TOML(
order = 2
constants = { eps = 0.5 }
where = { r = "sqrt(x^2 + y^2)" }
diffusion = "eps^2"
reaction = 3
source = "r + eps"
velocity = [1, "-y"])TOML")));
  CHECK(problem.diffusion.everywhere().is_constant());
  CHECK(problem.diffusion.in(1)({7, 7}) == 0.25);
  CHECK(problem.reaction.in(1)({7, 7}) == 3);
  CHECK(problem.source.in(1)({3, 4}) == 5.5);
  CHECK(problem.velocity_x.in(1)({3, 4}) == 1);
  CHECK(problem.velocity_y.in(1)({3, 4}) == -4);
}

TEST_CASE("regions have coefficients of their own") {
  const ScalarProblem problem = problem_of(parse_text(square_study(R"(
diffusion = 1
regions.square = { diffusion = 10, source = "x", velocity = ["2", 0] })")));
  CHECK(problem.diffusion.everywhere()({0, 0}) == 1);
  CHECK(problem.diffusion.in(1)({0, 0}) == 10);
  CHECK(problem.source.in(1)({6, 0}) == 6);
  CHECK(problem.velocity_x.in(1)({0, 0}) == 2);
  CHECK(problem.has_convection());
}

TEST_CASE("boundary conditions are values fluxes or Robin") {
  const ScalarProblem problem = problem_of(parse_text(square_study(R"(
boundary.bottom = { value = "x" }
boundary.right = { flux = 2 }
boundary.top = { robin = { transfer = 5, flux = "10*x" } }
points = [{ at = [0.5, 0.5], value = 4 }])")));
  REQUIRE(problem.dirichlet.size() == 1);
  CHECK(problem.dirichlet[0].tag == 1);
  CHECK(problem.dirichlet[0].value({3, 0}) == 3);
  REQUIRE(problem.fluxes.size() == 2);
  CHECK(problem.fluxes[0].tag == 2);
  CHECK(problem.fluxes[0].flux({0, 0}) == 2);
  CHECK(problem.fluxes[0].transfer.is_zero());
  CHECK(problem.fluxes[1].transfer({0, 0}) == 5);
  CHECK(problem.fluxes[1].flux({2, 0}) == 20);
  REQUIRE(problem.points.size() == 1);
  CHECK(problem.points[0].at == Point{0.5, 0.5});
  CHECK(problem.points[0].value == 4);
}

TEST_CASE("a known solution gives source and boundary values") {
  const ScalarProblem problem = problem_of(parse_text(square_study(R"(
exact = "line-front"
front = { point = [0.5, 0.5], angle = 90, width = 0.1 }
boundary.top = { value = "exact" })")));
  // u = tanh((y - 1/2) / 0.1), f = -u'' = 2 u (1 - u^2) / 0.01
  const double u = std::tanh(1.);
  REQUIRE(problem.dirichlet.size() == 1);
  CHECK(problem.dirichlet[0].value({0.3, 0.6}) == doctest::Approx(u));
  CHECK(problem.source.in(1)({0.3, 0.6}) == doctest::Approx(200 * u * (1 - u * u)));
}

TEST_CASE("mistakes in a scalar problem name line column and what was expected") {
  CHECK(failure("difusion = 1") ==
        "s.toml:12:1: unknown key \"problem.difusion\"; did you mean \"diffusion\"?");
  CHECK(failure("diffusion = 0") == "s.toml:12:13: problem.diffusion: must be positive, found 0");
  CHECK(has(failure("diffusion = \"1 - 2\""), "problem.diffusion: must be positive, found -1"));
  CHECK(has(failure("reaction = -1"), "problem.reaction: must not be negative, found -1"));
  CHECK(has(failure("order = 3"), "s.toml:12:9: problem.order: found 3, expected 1 (linear) or 2"));
  CHECK(has(failure("kind = \"poison\""), "did you mean \"poisson\"?"));
  CHECK(has(failure("velocity = [1]"), "expected two numbers or expressions"));
  CHECK(has(failure("velocity = [1, true]"), "expected expressions in quotes or numbers"));
  CHECK(has(failure("source = \"x +\""), "s.toml:12:10: problem.source = \"x +\": "));
  CHECK(has(failure("source = \"2*epss\"\nconstants = { eps = 1 }"),
            "unknown name \"epss\" (column 3); did you mean \"eps\"?"));
  CHECK(
      has(failure("points = [{ at = [0, 0] }]"), "the key \"problem.points[0].value\" is missing"));
  CHECK(has(failure("points = [{ at = [0, 0], value = \"x\" }]"), "varies with x or y"));
}

TEST_CASE("a curve has exactly one condition") {
  const std::string both = failure("boundary.left = { value = 0, flux = 1 }");
  CHECK(has(both, "s.toml:12:17: problem.boundary.left: expected exactly one of value"));
  CHECK(has(failure("boundary.left = {}"), "expected exactly one of value"));
  CHECK(has(failure("boundary.left = { value = 0, robin = { transfer = 1 } }"),
            "expected exactly one of value"));
  CHECK(has(failure("boundary.left = { robin = { flux = 1 } }"), "robin.transfer\" is missing"));
  CHECK(has(failure("boundary.left = { robin = { transfer = -1 } }"), "must not be negative"));
}

TEST_CASE("names that the domain does not have are refused with the nearest one") {
  CHECK(setup_failure("boundary.botom = { value = 0 }") ==
        "s.toml:12:18: problem.boundary.botom: no curve is called \"botom\"; did you mean "
        "\"bottom\"?");
  CHECK(has(setup_failure("regions.sqare = { source = 1 }"),
            "no region is called \"sqare\"; did you mean \"square\"?"));
}

TEST_CASE("a known solution must suit the problem") {
  CHECK(has(failure("exact = \"product-layr\""), "did you mean \"product-layer\"?"));
  CHECK(has(failure("exact = \"product-layer\""), "needs reaction > 0"));
  CHECK(has(failure("exact = \"sine-product\"\ndiffusion = \"1 + x\""), "need constant diffusion"));
  CHECK(has(failure("exact = \"sine-product\"\nregions.square = { reaction = 1 }"),
            "leave regions out"));
  CHECK(has(failure("exact = \"exponential-layer\"\nvelocity = [0, 1]"), "velocity (speed, 0)"));
  CHECK(has(failure("boundary.left = { value = \"exact\" }"), "needs exact = \"NAME\""));
}

TEST_CASE("an expression that is not finite is reported with its line and the place") {
  const ScalarProblem problem = problem_of(parse_text(square_study("source = \"1/(x - 2)\"")));
  CHECK(message_of<InputError>([&] {
          problem.source.in(1)({2, 5});
        }) ==
        "s.toml:12:10: problem.source = \"1/(x - 2)\" is inf at (x, y) = (2, 5); it must be finite "
        "everywhere");
}

TEST_SUITE_END();
