#include <csignal>
#include <cstdlib>
#include <thread>

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "drivers/problem/loop_input.hpp"
#include "drivers/run/run_study.hpp"
#include "drivers/run/variant_run.hpp"
#include "tests/drivers/program_call.hpp"
#include "tests/drivers/result_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

const std::string kProblem = small_problem("cycles = 4\ntarget = { nodes = 60 }\nstages = true",
                                           "[output]\nformats = [\"msh\", \"vtu\"]\n");

/// Runs of one study into one folder, the terminal out of sight.
struct Runs {
  TemporaryFolder folder;
  StudyFile study;
  std::ostringstream out, err;
  Console console{out, err};

  explicit Runs(const std::string& text) : study(read_study_file(folder.write("s.toml", text))) {}

  fs::path variant() const { return folder.path() / "main"; }

  /// The only variant, as far as `change` lets it come.
  Outcome run(
      const std::function<void(LoopInput&)>& change = {},
      const std::function<bool()>& cancelled = [] { return false; }) {
    const Variant& only = study.variants.front();
    const std::string key = variant_key(study, only);
    VariantJob job{&only, variant(), read_earlier_run(variant(), key), loop_input(only.study)};
    job.earlier.record.key = key;
    if (change) change(*job.input);
    RunProgress progress(console);
    progress.plan(only.name, variant_plan(only.study, *job.input, job.earlier.cycles));
    return run_variant(std::move(job), cancelled, console, progress);
  }

  int run_all(EarlierResults earlier, int threads = 1) {
    RunOptions options;
    options.directory = folder.path() / "r";
    options.earlier = earlier;
    options.threads = threads;
    options.cancelled = [] { return false; };
    return run_study(study, options, console);
  }
};

/// A mesher that fails when it has made `meshes` meshes.
MakeMesh failing_after(int meshes) {
  return [meshes](const Domain& domain, const Mesh& mesh, const MetricField& field,
                  const GenerateOptions& options, const Monitor& monitor) mutable {
    if (meshes-- == 0) throw MeshingError("no mesh");
    return generate(domain, mesh, field, options, monitor);
  };
}

/// The only variant without a break.
struct Uninterrupted : Runs {
  explicit Uninterrupted(const std::string& text) : Runs(text) { run(); }
};

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a run that failed in any cycle goes on to the bytes of one without a break") {
  const Uninterrupted whole(kProblem);
  for (const int meshes : {0, 1, 3}) {
    Runs broken(kProblem);
    const Outcome failed =
        broken.run([&](LoopInput& input) { input.make_mesh = failing_after(meshes); });
    CHECK(failed.failure == ErrorKind::failed);
    CHECK(failed.history.cycles.size() == static_cast<std::size_t>(meshes + 1));
    CHECK_FALSE(fs::exists(broken.variant() / cycle_mesh_name(meshes + 1)));
    int made = 0;
    const Outcome resumed = broken.run([&](LoopInput& input) {
      input.make_mesh = [&made](const Domain& domain, const Mesh& mesh, const MetricField& field,
                                const GenerateOptions& options, const Monitor& monitor) {
        ++made;
        return generate(domain, mesh, field, options, monitor);
      };
    });
    CHECK(made == 4 - meshes);
    CHECK_FALSE(resumed.failure);
    CHECK(resumed.history.stop_reason == "finished after 4 cycles");
    CHECK(differences(whole.variant(), broken.variant()) == "");
  }
}

TEST_CASE("a cancelled run goes on to the bytes of one without a break") {
  const std::string text =
      small_problem("cycles = 3\nmode = \"isotropic\"\ntarget = { nodes = 60 }",
                    "[output]\nvalues = [{ name = \"w\", at = [0.3, 0.4] }]");
  const std::string quads =
      std::string(text).replace(text.find("initial_size"), 0, "elements = \"quadrilateral\"\n");
  for (const std::string& study : {text, quads}) {
    const Uninterrupted whole(study);
    Runs broken(study);
    const Outcome cancelled =
        broken.run({}, [&] { return fs::exists(broken.variant() / "cycle-1.msh"); });
    CHECK(cancelled.failure == ErrorKind::interrupted);
    CHECK_FALSE(fs::exists(broken.variant() / "cycle-2.msh"));
    CHECK_FALSE(broken.run().failure);
    CHECK(differences(whole.variant(), broken.variant()) == "");
  }
}

TEST_CASE("errors against a reference are measured when all cycles were done before") {
  const std::string text =
      small_problem("cycles = 1\ntarget = { nodes = 40 }\nreference = { nodes = 400 }");
  const Uninterrupted whole(text);
  Runs broken(text);
  const Outcome failed = broken.run([](LoopInput& input) {
    input.measure_errors = [](std::span<const Mesh>) -> std::vector<double> {
      throw MeshingError("no reference");
    };
  });
  CHECK(failed.failure == ErrorKind::failed);
  const Outcome resumed = broken.run();
  REQUIRE(resumed.history.cycles.size() == 2);
  CHECK(resumed.history.cycles[1].error.relative_energy.value() > 0);
  CHECK(differences(whole.variant(), broken.variant()) == "");
}

TEST_CASE("a damaged mesh costs one cycle and the results stay the same") {
  const Uninterrupted whole(kProblem);
  Runs damaged(kProblem);
  damaged.run();
  const fs::path mesh = damaged.variant() / "cycle-3.msh";
  fs::resize_file(mesh, fs::file_size(mesh) - 7);
  CHECK(differences(whole.variant(), damaged.variant()) == "cycle-3.msh\n");
  const auto untouched = fs::last_write_time(damaged.variant() / "cycle-2.msh");
  CHECK_FALSE(damaged.run().failure);
  CHECK(fs::last_write_time(damaged.variant() / "cycle-2.msh") == untouched);
  CHECK(differences(whole.variant(), damaged.variant()) == "");
}

TEST_CASE("warnings of the mesher stay with the cycle they belong to") {
  const auto warning = [](LoopInput& input) {
    input.make_mesh = [](const Domain& domain, const Mesh& mesh, const MetricField& field,
                         const GenerateOptions& options, const Monitor& monitor) {
      monitor.warning("careful");
      return generate(domain, mesh, field, options, monitor);
    };
  };
  Runs broken(kProblem);
  broken.run([&](LoopInput& input) {
    warning(input);
    const MakeMesh make = input.make_mesh;
    input.make_mesh = [make, made = 0](const Domain& domain, const Mesh& mesh,
                                       const MetricField& field, const GenerateOptions& options,
                                       const Monitor& monitor) mutable {
      if (++made == 3) throw MeshingError("no mesh");
      return make(domain, mesh, field, options, monitor);
    };
  });
  const Outcome resumed = broken.run(warning);
  REQUIRE(resumed.history.cycles.size() == 5);
  CHECK(resumed.history.cycles[0].warnings.empty());
  for (std::size_t k = 1; k < 5; ++k)
    CHECK(resumed.history.cycles[k].warnings == std::vector<std::string>{"careful"});
}

TEST_CASE("a finished variant is not run again with the same settings") {
  const TemporaryFolder folder;
  const std::string vary = "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n";
  const auto study = folder.write("s.toml", std::string(kTinyStudy) + vary).string();
  const auto dir = (folder.path() / "r").string();
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", study, "-o", dir});
    return call(more);
  };
  const auto time = [&](const char* variant) {
    return fs::last_write_time(fs::path(dir) / variant / "cycle-1.msh");
  };
  CHECK(run({}).code == 0);
  const std::string history = read_text_file(dir + "/history.json");
  const auto best = time("best"), paper = time("paper");
  const Result again = run({});
  CHECK(again.code == 0);
  CHECK(has(again.out, "best: finished by an earlier run with the same settings"));
  CHECK(read_text_file(dir + "/history.json") == history);  // the times too
  CHECK(time("best") == best);
  CHECK(has(run({"--resume"}).out, "paper: finished by an earlier run"));
  // Only the variant with other settings is run anew.
  folder.write("s.toml", std::string(kTinyStudy) + vary + "\"adapt.cycles\" = [2]\n");
  CHECK(run({}).code == 0);
  CHECK(time("best") == best);  // best-2 and paper-2 have folders of their own
  folder.write("s.toml", std::string(kTinyStudy) + "interpolation = 1\n");
  CHECK(run({}).code == 3);
  CHECK(time("paper") == paper);
  folder.write("s.toml", std::string(kTinyStudy) + vary);
  const Result other = run({"--set", "adapt.cycles=1"});
  CHECK(has(other.out, "best: the results in the folder have other settings; runs anew"));
  CHECK(time("best") != best);
  CHECK_FALSE(fs::exists(fs::path(dir) / "best/cycle-2.msh"));
  const auto shorter = time("best");
  CHECK_FALSE(has(run({"--set", "adapt.cycles=1", "--fresh"}).out, "finished by an earlier run"));
  CHECK(time("best") != shorter);
  CHECK(run({"--fresh", "--resume"}).code == 3);
}

TEST_CASE("an unfinished variant starts anew unless it is to be resumed") {
  Runs runs(kProblem);
  const fs::path folder = runs.folder.path() / "r/main";
  runs.run([](LoopInput& input) { input.make_mesh = failing_after(2); });
  fs::create_directories(folder.parent_path());
  fs::rename(runs.variant(), folder);
  const auto time = [&] { return fs::last_write_time(folder / "cycle-1.msh"); };
  const auto before = time();
  CHECK(runs.run_all(EarlierResults::resume) == 0);
  CHECK(has(runs.out.str(), "main: goes on after cycle 2"));
  CHECK(time() == before);
  // The record of a run that ended after cycle 2 again.
  Json record = read_json(folder / "record.json");
  record["finished"] = false;
  write_text_file(folder / "record.json", record.dump());
  CHECK(runs.run_all(EarlierResults::keep_finished) == 0);
  CHECK(has(runs.out.str(), "runs anew (--resume goes on after cycle 4)"));
  CHECK(time() != before);
}

TEST_CASE("any number of variants side by side leaves the same bytes") {
  const std::string text =
      small_problem("cycles = 2\ntarget = { nodes = 50 }",
                    "[vary]\n\"adapt.mode\" = [\"isotropic\", \"anisotropic\"]\n"
                    "\"mesh.elements\" = [\"triangle\", \"quadrilateral\"]\n");
  Runs one(text), four(text);
  CHECK(one.run_all(EarlierResults::ignore, 1) == 0);
  CHECK(four.run_all(EarlierResults::ignore, 4) == 0);
  CHECK(files_below(one.folder.path() / "r").size() > 20);
  CHECK(differences(one.folder.path() / "r", four.folder.path() / "r") == "");
}

TEST_CASE("a run that was killed goes on to the bytes of one without a break") {
  const char* name = "a run that was killed goes on to the bytes of one without a break";
  const char* variable = "ANISOFRONT_TEST_VICTIM";
  // This program again, in a process of its own, is the one that is killed.
  if (const char* victim = std::getenv(variable)) {
    call({"run", std::string(victim) + "/s.toml", "-q", "-o", std::string(victim) + "/r"});
    return;
  }
  const std::string text = small_problem("cycles = 12\ntarget = { nodes = 400 }");
  Runs whole(text), killed(text);
  CHECK(whole.run_all(EarlierResults::ignore) == 0);
  const fs::path folder = killed.folder.path() / "r/main";
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    setenv(variable, killed.folder.path().c_str(), 1);
    const std::string filter = std::string("--test-case=") + name;
    execl("/proc/self/exe", "tests", filter.c_str(), "--minimal", nullptr);
    _exit(127);
  }
  while (!fs::exists(folder / "cycle-3.msh") && waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK_FALSE(fs::exists(killed.folder.path() / "r/history.json"));
  const auto time = fs::last_write_time(folder / "cycle-1.msh");
  CHECK(killed.run_all(EarlierResults::resume) == 0);
  CHECK(has(killed.out.str(), "goes on after cycle"));
  CHECK(fs::last_write_time(folder / "cycle-1.msh") == time);
  CHECK(differences(whole.folder.path() / "r", killed.folder.path() / "r") == "");
}

TEST_SUITE_END();
