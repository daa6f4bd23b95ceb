#include "drivers/study/study_plate.hpp"

#include "drivers/problem/plate_setup.hpp"
#include "tests/drivers/problem_studies.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const std::string kMaterial =
    "kind = \"mindlin\"\nthickness = 0.1\nyoung = 10\npoisson_ratio = 0.25\n";

Study plate(const std::string& keys) { return parse_text(square_study(kMaterial + keys)); }

std::string failure(const std::string& keys) {
  return parse_failure(square_study(kMaterial + keys));
}

PlateProblem problem_of(const std::string& keys, std::vector<std::string>* warnings = nullptr) {
  const Study study = plate(keys);
  Monitor monitor;
  if (warnings) monitor.warn = [=](const std::string& text) { warnings->push_back(text); };
  return plate_problem(*study.plate, study.domain, monitor);
}

SupportKind support(const std::string& word) {
  return problem_of("boundary.top = \"" + word + "\"").supports.at(0).kind;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a plate has the material of the study") {
  const PlateMaterial material = problem_of("shear_factor = 0.9").material;
  CHECK(material.thickness == 0.1);
  CHECK(material.young == 10);
  CHECK(material.poisson == 0.25);
  CHECK(material.shear_factor == 0.9);
  CHECK(problem_of("").material.shear_factor == doctest::Approx(5. / 6));
}

TEST_CASE("material and load may use constants") {
  const Study study = parse_text(square_study(R"(kind = "mindlin"
constants = { t = 0.01, nu = 0.3 }
thickness = "t"
young = "12*(1 - nu^2)/t^3"
poisson_ratio = "nu"
load = "x/t")"));
  const PlateProblem problem = plate_problem(*study.plate, study.domain);
  CHECK(problem.material.bending_stiffness() == doctest::Approx(1));
  CHECK(problem.load.in(1)({2, 0}) == doctest::Approx(200));
}

TEST_CASE("a region replaces what it names and keeps the rest") {
  const PlateProblem problem =
      problem_of("load = 1\nregions.square = { thickness = 0.2, load = \"y\" }");
  const PlateMaterial& material = problem.material_in(1);
  CHECK(material.thickness == 0.2);
  CHECK(material.young == 10);
  CHECK(problem.load.in(1)({0, 3}) == 3);
  CHECK(problem.load.everywhere()({0, 3}) == 1);
}

TEST_CASE("every support has its word") {
  CHECK(support("clamped") == SupportKind::clamped);
  CHECK(support("soft-clamped") == SupportKind::soft_clamped);
  CHECK(support("hard-support") == SupportKind::hard_support);
  CHECK(support("soft-support") == SupportKind::soft_support);
  CHECK(support("free") == SupportKind::free);
  CHECK(support("symmetry") == SupportKind::symmetry);
  CHECK(support("antisymmetry") == SupportKind::antisymmetry);
}

TEST_CASE("every element has its word") {
  CHECK(plate("").plate->element == PlateElement::mitc);
  CHECK(plate("element = \"arnold-falk\"").plate->element == PlateElement::arnold_falk);
  const std::string quads = square_study(kMaterial + "element = \"mitc4\"", "",
                                         "initial_size = 0.25\nelements = \"quadrilateral\"");
  CHECK(parse_text(quads).plate->element == PlateElement::mitc4);
}

TEST_CASE("edges and points carry loads and settlements") {
  const PlateProblem problem = problem_of(R"(
boundary.left = { support = "soft-support", deflection = "0.1*y", moment = 3 }
boundary.right = { shear = "x", twist = 2 }
boundary.top = "free"
boundary.bottom = "free"
points = [{ at = [0.5, 0.5], force = 7 }, { at = [1, 1], deflection = 0.5, rotations = true }])");
  REQUIRE(problem.supports.size() == 4);
  CHECK(problem.supports[0].tag == 4);
  CHECK(problem.supports[0].deflection({0, 2}) == doctest::Approx(0.2));
  CHECK(problem.supports[1].kind == SupportKind::free);
  REQUIRE(problem.edge_loads.size() == 2);
  CHECK(problem.edge_loads[0].moment({0, 0}) == 3);
  CHECK(problem.edge_loads[0].shear.is_zero());
  CHECK(problem.edge_loads[1].tag == 2);
  CHECK(problem.edge_loads[1].shear({4, 0}) == 4);
  CHECK(problem.edge_loads[1].twist({0, 0}) == 2);
  REQUIRE(problem.point_loads.size() == 1);
  CHECK(problem.point_loads[0].force == 7);
  REQUIRE(problem.point_supports.size() == 1);
  CHECK(problem.point_supports[0].deflection == 0.5);
  CHECK(problem.point_supports[0].holds_rotations);
}

TEST_CASE("boundary curves that no condition mentions are free with a warning") {
  std::vector<std::string> warnings;
  CHECK(problem_of("boundary.left = \"clamped\"\nboundary.top = \"free\"", &warnings)
            .supports.size() == 2);
  REQUIRE(warnings.size() == 1);
  CHECK(has(warnings[0], "no condition mentions bottom, right: free edges"));
  warnings.clear();
  problem_of(
      "boundary = { left = \"clamped\", right = \"free\", top = \"free\", bottom = \"free\" }",
      &warnings);
  CHECK(warnings.empty());
}

TEST_CASE("a plate needs its material") {
  const auto missing = [](const std::string& keys) {
    return parse_failure(square_study("kind = \"mindlin\"\n" + keys));
  };
  CHECK(has(missing("young = 1\npoisson_ratio = 0.3"), "the key \"problem.thickness\" is missing"));
  CHECK(has(missing("thickness = 1\npoisson_ratio = 0.3"), "\"problem.young\" is missing"));
  CHECK(has(missing("young = 1\nthickness = 1"), "\"problem.poisson_ratio\" is missing"));
}

TEST_CASE("material that cannot be is refused with its line") {
  const auto with = [](const std::string& thickness, const std::string& young,
                       const std::string& poisson) {
    return parse_failure(square_study("kind = \"mindlin\"\nthickness = " + thickness +
                                      "\nyoung = " + young + "\npoisson_ratio = " + poisson));
  };
  CHECK(with("0", "1", "0.3") == "s.toml:13:13: problem.thickness: must be positive, found 0");
  CHECK(has(with("-1", "1", "0.3"), "thickness: must be positive"));
  CHECK(with("1", "-5", "0.3") == "s.toml:14:9: problem.young: must be positive, found -5");
  CHECK(with("1", "1", "0.5") ==
        "s.toml:15:17: problem.poisson_ratio: must lie between -1 and 0.5, found 0.5");
  CHECK(has(with("1", "1", "-1"), "must lie between -1 and 0.5, found -1"));
  CHECK(with("1", "1", "0.49") == "");
  CHECK(has(with("\"0.1 + x\"", "1", "0.3"), "varies with x or y; expected a number"));
  CHECK(has(failure("shear_factor = 0"), "must be positive"));
  CHECK(has(failure("regions.square = { poisson_ratio = 0.6 }"),
            "problem.regions.square.poisson_ratio: must lie between"));
}

TEST_CASE("supports and loads that contradict each other are refused") {
  const auto refusal = [](const std::string& entry) {
    return failure("boundary.left = { " + entry + " }");
  };
  CHECK(
      refusal("support = \"clamped\", moment = 1") ==
      "s.toml:16:49: problem.boundary.left.moment: contradicts support = \"clamped\", which holds "
      "the normal rotation");
  CHECK(has(refusal("support = \"soft-support\", shear = 1"), "holds the deflection"));
  CHECK(has(refusal("support = \"hard-support\", twist = 1"), "holds the tangential rotation"));
  CHECK(has(refusal("support = \"symmetry\", deflection = 1"), "leaves the deflection free"));
  CHECK(has(refusal("deflection = 1"), "contradicts support = \"free\""));
  CHECK(refusal("support = \"symmetry\", shear = 1, twist = 1") == "");
  CHECK(refusal("support = \"soft-clamped\", twist = 1, deflection = 1") == "");
  CHECK(refusal("support = \"antisymmetry\", moment = 1") == "");
}

TEST_CASE("misspelt words and keys of a plate are refused with the nearest one") {
  CHECK(has(failure("boundary.left = \"clampd\""),
            "s.toml:16:17: problem.boundary.left: found \"clampd\", expected one of: clamped,"));
  CHECK(has(failure("boundary.left = \"clampd\""), "did you mean \"clamped\"?"));
  CHECK(has(failure("boundary.left = 3"), "expected a text in quotes, found the number 3"));
  CHECK(has(failure("boundary.left = { suport = \"free\" }"), "did you mean \"support\"?"));
  CHECK(has(failure("element = \"mitc7\""), "expected one of: mitc, mitc4, arnold-falk"));
  CHECK(has(failure("thicknes = 1"), "did you mean \"thickness\"?"));
  CHECK(message_of<UsageError>([] { problem_of("boundary.lft = \"free\""); }) ==
        "s.toml:16:16: problem.boundary.lft: no curve is called \"lft\"; did you mean \"left\"?");
  CHECK(has(message_of<UsageError>([] { problem_of("regions.squre = { load = 1 }"); }),
            "did you mean \"square\"?"));
}

TEST_CASE("a point is either loaded or held") {
  CHECK(has(failure("points = [{ at = [0, 0] }]"), "expected either force = ... or deflection"));
  CHECK(has(failure("points = [{ at = [0, 0], force = 1, deflection = 0 }]"), "expected either"));
  CHECK(has(failure("points = [{ at = [0, 0], force = 1, rotations = true }]"),
            "goes with deflection"));
  CHECK(has(failure("points = [{ at = [0, 0], deflection = 1, rotations = 1 }]"),
            "expected true or false, found the number 1"));
}

TEST_CASE("baseline elements need the shape they are made for") {
  CHECK(has(failure("element = \"mitc4\""), "mitc4 is for quadrilaterals"));
  CHECK(has(parse_failure(square_study(kMaterial + "element = \"arnold-falk\"", "",
                                       "initial_size = 0.25\nelements = \"mixed\"")),
            "arnold-falk is for triangles"));
}

TEST_SUITE_END();
