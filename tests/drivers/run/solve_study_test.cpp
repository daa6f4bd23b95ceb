#include "drivers/run/solve_study.hpp"

#include <cmath>
#include <numbers>

#include "tests/drivers/problem_studies.hpp"
#include "tests/drivers/program_call.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

/// solution.json of a ready study.
Json solve_ready(const std::string& name, const fs::path& directory,
                 const std::vector<std::string>& settings = {}) {
  std::vector<std::string> words{"solve", ANISOFRONT_DATA "/studies/" + name + ".toml", "-o",
                                 directory.string()};
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  const Result result = call(words);
  CHECK_MESSAGE(result.code == 0, result.err);
  REQUIRE(fs::exists(directory / "solution.json"));
  return read_json(directory / "solution.json");
}

double relative_error(const Json& value, double expected) {
  return std::fabs(value.get<double>() / expected - 1);
}

/// All numbers of a column are the expected one.
double largest_deviation(const Json& column, double expected) {
  double largest = 0;
  for (const Json& value : column)
    largest = std::max(largest, std::fabs(value.get<double>() - expected));
  return largest;
}

double sum_of(const Json& list, const char* key) {
  double sum = 0;
  for (const Json& entry : list) sum += entry[key].get<double>();
  return sum;
}

const std::string kPlate =
    "kind = \"mindlin\"\nthickness = 0.1\nyoung = 1e3\npoisson_ratio = 0.3\nload = 1\n";
const std::string kClamped =
    "boundary = { bottom = \"clamped\", right = \"clamped\", top = \"clamped\", left = "
    "\"clamped\" }\n";

/// Exit code, message and what is left of a study that cannot be solved.
struct Failure {
  int code;
  std::string message;
  bool left_something;
};
Failure failing(const std::string& study) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("s.toml", study), out = folder.path() / "out";
  const Result result = call({"solve", file.string(), "-o", out.string()});
  return {result.code, result.err, fs::exists(out)};
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the clamped disc has the deflection moments and shear of the closed form") {
  const TemporaryFolder folder;
  const Json found = solve_ready("plate-disc-clamped", folder.path() / "d");
  const Json& values = found["values"];
  CHECK(relative_error(values[0]["w"], 0.0163392857142857) < 1e-5);
  CHECK(relative_error(values[0]["M_xx"], 0.08125) < 2e-3);
  CHECK(relative_error(values[0]["M_yy"], 0.08125) < 2e-3);
  // r = 1/2: w = (3/4)^2 / 64 + (3/4) / (4 S), S = k G t / D = 350
  CHECK(relative_error(values[1]["w"], 0.5625 / 64 + 0.75 / 1400) < 1e-4);
  CHECK(std::fabs(values[2]["w"].get<double>()) < 1e-12);
  CHECK(relative_error(found["energy"]["total"], 0.008742229556864453) < 3e-5);
  CHECK(relative_error(found["work"], found["energy"]["total"].get<double>()) < 1e-8);
  CHECK(relative_error(found["load"], std::numbers::pi) < 1e-5);
  REQUIRE(found["reactions"].size() == 1);
  CHECK(found["reactions"][0]["curve"] == "edge");
  CHECK(relative_error(found["reactions"][0]["force"], -std::numbers::pi) < 1e-5);
  const Json& edge = found["lines"][1];
  CHECK(edge["name"] == "edge");
  CHECK(edge["s"].size() == 73);
  CHECK(relative_error(edge["s"].back(), 2 * std::numbers::pi) < 1e-9);
  CHECK(largest_deviation(edge["M_n"], -0.125) < 3e-3);
  CHECK(largest_deviation(edge["M_ns"], 0) < 3e-3);
  CHECK(largest_deviation(edge["Q_n"], -0.5) < 0.03);
  CHECK(found["mesh"]["curved_edges"] == found["mesh"]["boundary_edges"]);
  CHECK(found["warnings"].empty());
}

TEST_CASE("the soft supported square agrees with the reference") {
  const TemporaryFolder folder;
  const Json found = solve_ready("plate-square-soft-support", folder.path() / "s");
  CHECK(relative_error(found["values"][0]["w"], 4.099303807873381e-3) < 2e-3);
  CHECK(relative_error(found["values"][0]["M_xx"], 4.8195442664e-2) < 2e-3);
  CHECK(relative_error(found["energy"]["total"], 8.600094977553172e-4 / 4) < 2e-3);
  CHECK(relative_error(found["load"], 0.25) < 1e-9);
  // 2 U of the quarter is 4.3000e-4: the squared error of a mesh that misses part of the layer.
  CHECK(found["estimate"]["relative_energy"].get<double>() > 5e-3);
  CHECK(found["estimate"]["relative_energy"].get<double>() < 8e-2);
  CHECK(std::fabs(sum_of(found["reactions"], "force") + 0.25) < 1e-6);
}

TEST_CASE("the Poisson equation on the L shape comes near the reference from below") {
  const TemporaryFolder folder;
  constexpr double kReference = 0.21407580268571;
  const Json linear = solve_ready("poisson-l-shape", folder.path() / "1");
  CHECK(linear["squared_energy"].get<double>() < kReference);
  CHECK(relative_error(linear["squared_energy"], kReference) < 1.2e-2);
  // What flows out is what the source brings in, 1 on an area of 3.
  CHECK(linear["fluxes"][0]["flux"].get<double>() == doctest::Approx(-3));
  // The estimate against the error |e|^2 = E - E_h of a Galerkin solution.
  const double error = std::sqrt(1 - linear["squared_energy"].get<double>() / kReference);
  CHECK(linear["estimate"]["relative_energy"].get<double>() > 0.7 * error);
  CHECK(linear["estimate"]["relative_energy"].get<double>() < 1.4 * error);
  CHECK(linear["values"][0]["u"] == 0);
  const Json quadratic = solve_ready("poisson-l-shape", folder.path() / "2", {"problem.order=2"});
  CHECK(quadratic["squared_energy"].get<double>() < kReference);
  CHECK(relative_error(quadratic["squared_energy"], kReference) < 4e-3);
  const double truth = std::sqrt(1 - quadratic["squared_energy"].get<double>() / kReference);
  // On a uniform mesh the corner makes up nearly all of the error and is overestimated.
  CHECK(quadratic["estimate"]["relative_energy"].get<double>() > 0.8 * truth);
  CHECK(quadratic["estimate"]["relative_energy"].get<double>() < 2 * truth);
  CHECK(quadratic["settings"]["order"] == 2);
}

TEST_CASE("the convection layer is near its exact solution") {
  const TemporaryFolder folder;
  const Json found = solve_ready("convection-layer", folder.path() / "c");
  CHECK(std::fabs(found["values"][0]["u"].get<double>() - 0.5) < 0.02);  // X(1/2) = 1/2 - e^-25
  CHECK(found["error"]["l2"].get<double>() < 0.05);
  CHECK(has(read_text_file(folder.path() / "c/solution.vtu"), "Name=\"error\""));
}

TEST_CASE("the steel floor is in equilibrium") {
  const TemporaryFolder folder;
  const Json found = solve_ready("plate-steel-floor", folder.path() / "f");
  const double area = 480e3 - std::numbers::pi * 150 * 150 + 330e3 - std::numbers::pi * 80 * 80;
  CHECK(relative_error(found["load"], 0.005 * area + 2000) < 1e-4);
  CHECK(relative_error(Json(sum_of(found["reactions"], "force")), -found["load"].get<double>()) <
        1e-6);
  CHECK(relative_error(found["work"], found["energy"]["total"].get<double>()) < 1e-6);
  for (const Json& value : found["values"]) {
    CHECK(value["w"].get<double>() > 0);
    CHECK(value["w"].get<double>() < 20);  // mm: less than the thickness
  }
}

TEST_CASE("a solve on quadrilaterals agrees with one on triangles") {
  const TemporaryFolder folder;
  const Json quads = solve_ready("plate-disc-clamped", folder.path() / "q",
                                 {"mesh.elements=quadrilateral", "mesh.initial_size=0.2"});
  CHECK(quads["mesh"]["triangles"] == 0);
  CHECK(relative_error(quads["values"][0]["w"], 0.0163392857142857) < 1e-3);
  const Json poisson = solve_ready("poisson-l-shape", folder.path() / "p",
                                   {"mesh.elements=quadrilateral", "mesh.initial_size=0.1"});
  CHECK(poisson["mesh"]["triangles"] == 0);
  CHECK(relative_error(poisson["squared_energy"], 0.21407580268571) < 2.5e-2);
}

TEST_CASE("a solve leaves fields lines and a summary") {
  const TemporaryFolder folder;
  const auto study = folder.write(
      "s.toml",
      square_study(kPlate + kClamped,
                   "[output]\nformats = [\"svg\"]\nvalues = [{ name = \"mid\", at = [0.5, "
                   "0.5] }]\nlines = [{ name = \"cut\", from = [0, 0.5], to = [1, 0.5], "
                   "points = 5 }]\n"));
  const fs::path out = folder.path() / "out";
  const Result result = call({"solve", study.string(), "-o", out.string()});
  CHECK(result.code == 0);
  for (const char* word : {"square", "vertices", "unknowns", "residual", "energy", "reaction",
                           "mid", "M_xx", "results in"})
    CHECK_MESSAGE(has(result.out, word), word);
  for (const char* file : {"solution.json", "solution.msh", "solution.vtu", "solution.svg"})
    CHECK_MESSAGE(fs::exists(out / file), file);
  const std::string csv = read_text_file(out / "lines/cut.csv");
  CHECK(csv.substr(0, csv.find('\n')) ==
        "s,x,y,w,theta_x,theta_y,M_xx,M_yy,M_xy,Q_x,Q_y,M_n,M_s,M_ns,Q_n,Q_s");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 6);
  const std::string vtu = read_text_file(out / "solution.vtu");
  for (const char* field : {"deflection", "rotation", "moments", "shear"})
    CHECK_MESSAGE(has(vtu, "Name=\"" + std::string(field) + "\""), field);
  const Json found = read_json(out / "solution.json");
  for (const char* key :
       {"schema", "title", "variant", "kind", "settings", "mesh", "unknowns", "linear", "energy",
        "work", "load", "reactions", "estimate", "values", "lines", "warnings", "seconds"})
    CHECK_MESSAGE(found.contains(key), key);
  CHECK(found["schema"] == 1);
  CHECK(found["kind"] == "mindlin");
  CHECK(found["settings"]["element"] == "mitc");
  CHECK(found["linear"]["residual"].get<double>() < 1e-10);
  // Symmetric about x = 1/2; the normal of the cut points down.
  const Json& cut = found["lines"][0];
  CHECK(cut["w"][1].get<double>() == doctest::Approx(cut["w"][3].get<double>()).epsilon(0.02));
  CHECK(cut["M_n"][2] == cut["M_yy"][2]);
  CHECK(cut["Q_n"][1].get<double>() == -cut["Q_y"][1].get<double>());
}

TEST_CASE("the results do not depend on the number of threads") {
  const TemporaryFolder folder;
  const std::vector<std::string> common{"output.formats=[\"mesh\"]"};
  for (const char* study : {"plate-disc-clamped", "convection-layer"}) {
    CAPTURE(study);
    Json found[2];
    for (int i = 0; i < 2; ++i) {
      const fs::path out = folder.path() / (study + std::to_string(i + 1));
      found[i] = solve_ready(study, out, {"solver.threads=" + std::to_string(i + 1)});
      found[i].erase("seconds");
    }
    CHECK(found[0] == found[1]);
    for (const char* file : {"solution.msh", "solution.vtu"})
      CHECK(read_text_file(folder.path() / (std::string(study) + "1") / file) ==
            read_text_file(folder.path() / (std::string(study) + "2") / file));
  }
}

TEST_CASE("variants are solved into folders of their own") {
  const TemporaryFolder folder;
  const auto study = folder.write(
      "s.toml", square_study(kPlate + kClamped, "[vary]\n\"problem.thickness\" = [0.1, 0.2]\n"));
  const fs::path out = folder.path() / "out";
  CHECK(call({"solve", study.string(), "-o", out.string(), "-q"}).code == 0);
  const Json thin = read_json(out / "0.1/solution.json"),
             thick = read_json(out / "0.2/solution.json");
  CHECK(thin["settings"]["problem.thickness"] == 0.1);
  CHECK(thin["energy"]["total"].get<double>() > 4 * thick["energy"]["total"].get<double>());
}

TEST_CASE("mistakes that show before the solve are code 3 and leave nothing behind") {
  const Failure outside = failing(square_study(
      kPlate + kClamped, "[output]\nvalues = [{ name = \"far\", at = [1.5, 0.5] }]\n"));
  CHECK(outside.code == 3);
  CHECK(has(outside.message,
            "s.toml:20:11: output.values[0] \"far\" at (x, y) = (1.5, 0.5) lies "
            "outside the domain, 0.5 away from it"));
  CHECK_FALSE(outside.left_something);
  const Failure line = failing(square_study(
      kPlate + kClamped,
      "[output]\nlines = [{ name = \"a\", from = [0, 0], to = [0, 2], points = 3 }]\n"));
  CHECK(line.code == 3);
  CHECK(has(line.message, "\"a\": its point 3 at (x, y) = (0, 2) lies outside"));
  const Failure curve = failing(
      square_study(kPlate + kClamped, "[output]\nlines = [{ name = \"a\", curve = \"botom\" }]\n"));
  CHECK(curve.code == 3);
  CHECK(has(curve.message, "no curve is called \"botom\"; did you mean \"bottom\"?"));
  const Failure metric = failing(kTinyStudy);
  CHECK(metric.code == 3);
  CHECK(has(metric.message, "there is no [problem] to solve"));
}

TEST_CASE("problems that cannot be solved are code 4 and leave nothing behind") {
  const Failure loose = failing(square_study(kPlate + "boundary.left = \"free\""));
  CHECK(loose.code == 4);
  CHECK(has(loose.message, "rigid body"));
  CHECK_FALSE(loose.left_something);
  const Failure infinite =
      failing(square_study("boundary.left = { value = 0 }\nsource = "
                           "\"1/(x > 0.5 ? 0 : 1)\""));
  CHECK(infinite.code == 4);
  CHECK(has(infinite.message, "problem.source"));
  CHECK(has(infinite.message, "is inf at (x, y) = ("));
  CHECK_FALSE(infinite.left_something);
  const Failure thin = failing(square_study(
      "kind = \"mindlin\"\nthickness = 1e-6\nyoung = 1\npoisson_ratio = 0.3\n" + kClamped));
  CHECK(thin.code == 4);
  const Failure floating = failing(square_study("boundary.left = { flux = 1 }"));
  CHECK(floating.code == 4);
}

TEST_CASE("a system beyond the memory limit is code 5") {
  const Failure large = failing(
      square_study(kPlate + kClamped, "[solver]\nmemory = 1e-9\nmethod = \"supernodal\"\n"));
  CHECK(large.code == 5);
  CHECK_FALSE(large.left_something);
}

TEST_CASE("a variant that fails is named and those before it are kept") {
  const TemporaryFolder folder;
  const auto study = folder.write(
      "s.toml", square_study(kPlate + kClamped, "[vary]\n\"problem.thickness\" = [0.1, 1e-7]\n"));
  const fs::path out = folder.path() / "out";
  const Result result = call({"solve", study.string(), "-o", out.string()});
  CHECK(result.code == 4);
  CHECK(has(result.err, "1e-07: "));
  CHECK(fs::exists(out / "0.1/solution.json"));
  CHECK_FALSE(fs::exists(out / "1e-07"));
}

TEST_SUITE_END();
