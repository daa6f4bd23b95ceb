// Profiles from the study file to the results folder.
#include <doctest/doctest.h>

#include "drivers/problem/loop_input.hpp"
#include "drivers/run/run_study.hpp"
#include "tests/drivers/program_call.hpp"
#include "tests/drivers/result_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

const std::string kLines = R"([output]
lines = [
  { name = "cut", from = [0.5, 0], to = [0.5, 1], points = 9, grading = 2, reference = { u = "s*(1-s)/8" } },
  { name = "rim", curve = "top", points = 5, reference = "rim.csv" },
]
)";

const std::string kPlate =
    "kind = \"mindlin\"\nthickness = 0.1\nyoung = 1e3\npoisson_ratio = 0.3\nload = 1\n"
    "boundary = { bottom = \"clamped\", right = \"clamped\", top = \"clamped\", left = "
    "\"clamped\" }\n";

/// A study beside its reference table, run and solved into folders of its own.
struct Runs {
  TemporaryFolder folder;
  std::ostringstream out, err;

  explicit Runs(const std::string& text) {
    folder.write("s.toml", text);
    folder.write("rim.csv", "s,u\n0,0\n1,0\n");
  }
  fs::path results() const { return folder.path() / "r"; }
  fs::path lines() const { return results() / "main/lines"; }

  int run(
      EarlierResults earlier = EarlierResults::ignore,
      const std::function<bool()>& cancelled = [] { return false; }) {
    const InterruptGuard guard;  // forgets the signals of other tests
    Console console{out, err};
    RunOptions options;
    options.directory = results();
    options.earlier = earlier;
    options.command = "anisofront run s.toml";
    options.cancelled = cancelled;
    return run_study(read_study_file(folder.path() / "s.toml"), options, console);
  }
  /// The record of a run that ended after its last cycle and before the end.
  void make_unfinished() const {
    const fs::path path = results() / "main/record.json";
    Json record = read_json(path);
    record["finished"] = false;
    write_text_file(path, record.dump());
  }
};

std::string small(int cycles) {
  return small_problem("cycles = " + std::to_string(cycles) + "\ntarget = { nodes = 60 }", kLines);
}

/// The profile of the only line, or the first, of a ready study on its last mesh.
Profile last_profile(const std::string& name, const std::vector<std::string>& settings) {
  const StudyFile file =
      read_study_file(ANISOFRONT_DATA "/studies/" + name + ".toml", parse_overrides(settings));
  LoopInput input = loop_input(file.variants.front().study);
  input.measure_errors = {};
  Profile last;
  input.finished = [&](const CycleRecord&, const Mesh&, const Analysis& analysis) {
    last = analysis.profiles.at(0);
  };
  adapt_loop(input);
  return last;
}

std::vector<double> column(const NumberTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  REQUIRE(found != table.columns.end());
  std::vector<double> values;
  for (const std::vector<double>& row : table.rows)
    values.push_back(row[static_cast<std::size_t>(found - table.columns.begin())]);
  return values;
}

/// The largest difference from the reference as a share of its largest value.
double deviation(const Profile& profile, const std::string& name) {
  const std::vector<double> found = column(profile.values, name),
                            reference = column(profile.reference.value(), name);
  REQUIRE(found.size() == reference.size());
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    difference = std::max(difference, std::abs(found[i] - reference[i]));
    largest = std::max(largest, std::abs(reference[i]));
  }
  return difference / largest;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a run leaves the profiles of every cycle and their references") {
  Runs runs(small(2));
  CHECK(runs.run() == 0);
  CHECK(files_below(runs.lines()) ==
        std::set<std::string>{"cycle-0-cut.csv", "cycle-0-rim.csv", "cycle-1-cut.csv",
                              "cycle-1-rim.csv", "cycle-2-cut.csv", "cycle-2-rim.csv",
                              "reference-cut.csv", "reference-rim.csv"});
  const std::string cut = read_text_file(runs.lines() / "cycle-2-cut.csv");
  CHECK(cut.starts_with("s,x,y,u,u_x,u_y,u_n,u_s\n0,0.5,0,"));
  CHECK(std::count(cut.begin(), cut.end(), '\n') == 10);
  const std::string reference = read_text_file(runs.lines() / "reference-cut.csv");
  CHECK(reference.starts_with("s,u\n0,0\n0.015625,"));  // (1/8)^2
  CHECK(has(reference, "\n0.25,0.0234375\n"));
  CHECK(read_text_file(runs.lines() / "reference-rim.csv") == "s,u\n0,0\n1,0\n");
}

TEST_CASE("a run and a solve on the same mesh give the same profiles") {
  const std::string scalar = "kind = \"poisson\"\nsource = \"x\"\nboundary.left = { value = 0 }\n";
  for (const std::string& problem : {scalar, scalar + "order = 2\n", kPlate}) {
    CAPTURE(problem);
    const TemporaryFolder folder;
    const auto study =
        folder
            .write(
                "s.toml",
                square_study(
                    problem,
                    "[adapt]\ncycles = 1\ntarget = { nodes = 50 }\n[output]\nvalues = [{ name = "
                    "\"v\", at = [0.9, 0.1] }]\nlines = [\n{ name = \"cut\", from = [0, 0.5], to = "
                    "[1, 0.5], points = 21 },\n{ name = \"rim\", curve = \"top\", points = 9, "
                    "grading = 3, towards = \"both\" }]\n"))
            .string();
    const fs::path run = folder.path() / "run", solve = folder.path() / "solve";
    REQUIRE(call({"run", study, "-q", "-o", run.string()}).code == 0);
    REQUIRE(call({"solve", study, "-q", "-o", solve.string()}).code == 0);
    for (const char* name : {"cut", "rim"})
      CHECK(read_text_file(run / "main/lines" / (std::string("cycle-0-") + name + ".csv")) ==
            read_text_file(solve / "lines" / (std::string(name) + ".csv")));
  }
}

TEST_CASE("a metric that is prescribed for a problem has profiles too") {
  Runs runs(small_problem("cycles = 1", kLines + "[metric]\nprescribed = [{ h1 = \"0.2\", h2 = "
                                                 "\"h1\" }]\n"));
  CHECK(runs.run() == 0);
  CHECK(fs::exists(runs.lines() / "cycle-1-cut.csv"));
}

TEST_CASE("profiles that are missing or damaged come back when a run goes on") {
  Runs whole(small(3)), broken(small(3));
  CHECK(whole.run() == 0);
  CHECK(broken.run() == 0);
  CHECK(differences(whole.results() / "main", broken.results() / "main") == "");
  broken.make_unfinished();
  fs::remove(broken.results() / "main/cycle-3.msh");
  fs::remove(broken.lines() / "cycle-0-rim.csv");
  fs::remove(broken.lines() / "reference-cut.csv");
  write_text_file(broken.lines() / "cycle-1-cut.csv", "s,u\n");
  fs::remove(broken.lines() / "cycle-3-rim.csv");
  const auto untouched = fs::last_write_time(broken.results() / "main/cycle-2.msh");
  CHECK(broken.run(EarlierResults::resume) == 0);
  CHECK(has(broken.out.str(), "goes on after cycle 2"));
  CHECK(fs::last_write_time(broken.results() / "main/cycle-2.msh") == untouched);
  CHECK(differences(whole.results() / "main", broken.results() / "main") == "");
}

TEST_CASE("another reference or other lines are other settings") {
  Runs runs(small(1));
  CHECK(runs.run() == 0);
  const auto time = [&] { return fs::last_write_time(runs.results() / "main/cycle-1.msh"); };
  const auto first = time();
  CHECK(runs.run(EarlierResults::keep_finished) == 0);
  CHECK(time() == first);
  runs.folder.write("rim.csv", "s,u\n0,0\n1,0.5\n");
  CHECK(runs.run(EarlierResults::keep_finished) == 0);
  CHECK(time() != first);
  CHECK(read_text_file(runs.lines() / "reference-rim.csv") == "s,u\n0,0\n1,0.5\n");
}

TEST_CASE("lines of an earlier run with others do not stay") {
  Runs runs(small(2));
  CHECK(runs.run() == 0);
  runs.folder.write("s.toml", small_problem("cycles = 1\ntarget = { nodes = 60 }",
                                            "[output]\nlines = [{ name = \"new\", curve = "
                                            "\"left\", points = 3 }]\n"));
  CHECK(runs.run() == 0);
  CHECK(files_below(runs.lines()) == std::set<std::string>{"cycle-0-new.csv", "cycle-1-new.csv"});
}

TEST_CASE("the resolved study finds its references from everywhere") {
  Runs runs(small(1));
  CHECK(runs.run() == 0);
  const Study resolved = read_study_file(runs.results() / "study.toml").variants.front().study;
  CHECK(resolved.output.lines.at(1).reference->file == runs.folder.path() / "rim.csv");
}

TEST_CASE("a reference that cannot be read stops a run before anything is written") {
  Runs runs(small(1));
  fs::remove(runs.folder.path() / "rim.csv");
  CHECK_THROWS_AS(runs.run(), UsageError);
  runs.folder.write("rim.csv", "s,u\n0,zero\n");
  CHECK_THROWS_WITH_AS(
      runs.run(),
      doctest::Contains("rim.csv: line 2: found \"zero\" for u, expected a finite number"),
      UsageError);
  CHECK_FALSE(fs::exists(runs.results()));
}

TEST_CASE("a run is described beside its results") {
  Runs runs(small(1));
  CHECK(runs.run() == 0);
  const Json json = read_json(runs.results() / "run.json");
  CHECK(json["command"] == "anisofront run s.toml");
  CHECK(json["exit_code"] == 0);
  CHECK(json["threads"] == 1);
  CHECK(json["seconds"].get<double>() > 0);
  CHECK(json["seconds"].get<double>() < 600);
  CHECK(json["version"] == read_json(runs.results() / "history.json")["version"]);
}

TEST_CASE("an interrupted run says so and keeps the profiles of its cycles") {
  Runs runs(small(3));
  const auto mesh = runs.results() / "main/cycle-1.msh";
  CHECK(runs.run(EarlierResults::ignore, [&] { return fs::exists(mesh); }) == 130);
  CHECK(read_json(runs.results() / "run.json")["exit_code"] == 130);
  const Json variant = read_json(runs.results() / "history.json")["variants"][0];
  CHECK(variant["stopped_by"] == "interrupted");
  for (const Json& cycle : variant["cycles"])
    CHECK(fs::exists(runs.lines() / ("cycle-" + cycle["cycle"].dump() + "-cut.csv")));
}

TEST_CASE("what stopped a run is in its history and decides the exit code") {
  const auto stopped = [](const std::string& adapt, int code) {
    Runs runs(small_problem("cycles = 3\n" + adapt));
    CHECK(runs.run() == code);
    CHECK(read_json(runs.results() / "run.json")["exit_code"] == code);
    return read_json(runs.results() / "history.json")["variants"][0]["stopped_by"];
  };
  CHECK(stopped("target = { nodes = 60 }", 0) == "cycles");
  CHECK(stopped("target = { error = 0.9 }", 0) == "target");
  CHECK(stopped("target = { error = 1e-6 }", 1) == "cycles");
  CHECK(stopped("target = { nodes = 60 }\nbudget = { nodes = 50 }", 5) == "budget");
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("golden");

TEST_CASE("the layer of a known solution is met point by point") {
  const Profile layer = last_profile(
      "reaction-diffusion-layer",
      {"problem.constants.eps=0.01", "problem.order=2", "vary.mesh=coarse", "adapt.cycles=4"});
  CHECK(deviation(layer, "u") < 0.005);
  CHECK(deviation(layer, "u_x") < 0.03);
}

// Shear force at a quarter of the edge: FE.md 3.3, three hp discretisations.
TEST_CASE("the formula of the layer of a soft support is met point by point") {
  for (const auto& [t, shear] : {std::pair<std::string, double>{"0.01", -6.382960487},
                                 std::pair<std::string, double>{"0.001", -63.27489484}}) {
    CAPTURE(t);
    const Profile layer = last_profile(
        "plate-boundary-layer", {"problem.constants.t=" + t, "vary.mesh=fine", "adapt.cycles=4"});
    CHECK(deviation(layer, "M_xy") < 0.08);  // 0.005 on 6000 vertices
    CHECK(deviation(layer, "Q_x") < 0.02);
    CHECK(column(layer.values, "Q_x")[0] == doctest::Approx(shear).epsilon(0.01));
    CHECK(column(*layer.reference, "Q_x")[0] == doctest::Approx(shear).epsilon(2e-4));
  }
}

// Side 10 and t = 0.2, scaled from side 1 and t = 0.02.
TEST_CASE("the formula of the layer holds for the plate on the metric of Example 2") {
  const Profile layer =
      last_profile("paper-example-2-plate",
                   {"adapt.mode=anisotropic", "mesh.elements=triangle", "adapt.cycles=3"});
  CHECK(deviation(layer, "M_xy") < 0.08);
  CHECK(deviation(layer, "Q_x") < 0.02);
}

TEST_SUITE_END();
