/// Every phase of the mesher on its own, in CPU time: <phase>/<case>/<triangles>.
/// bench_mesher --benchmark_filter='front/.*/100000/'
#include <filesystem>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "mesher/background/background_mesh.hpp"
#include "mesher/io/medit.hpp"
#include "mesher/metric/statistics.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/memory.hpp"

namespace anisofront {
namespace {

constexpr const char* kCases[] = {"uniform", "example-2", "layer", "sine"};
constexpr std::int64_t kSizes[] = {10'000, 100'000, 1'000'000};

/// The input of the last case and size asked for: making one takes as long as several runs.
const BenchInput& input_of(const BenchCase& bench, std::int64_t triangles) {
  static std::optional<BenchInput> input;
  static std::int64_t made_for = 0;
  if (!input || input->bench != &bench || made_for != triangles) {
    input.reset();
    input.emplace(make_bench_input(bench, static_cast<double>(triangles)));
    made_for = triangles;
  }
  return *input;
}

GenerateResult generate_from(const BenchInput& input) {
  return generate(input.domain, input.mesh, input.field, bench_options());
}

/// Triangles per second and nanoseconds per triangle.
void report_speed(benchmark::State& state, double triangles, double seconds) {
  const auto runs = static_cast<double>(state.iterations());
  state.counters["triangles"] = triangles;
  state.counters["triangles/s"] = triangles * runs / seconds;
  state.counters["ns/triangle"] = 1e9 * seconds / (triangles * runs);
}

void run_phase(benchmark::State& state, const BenchCase& bench, double PhaseSeconds::*phase) {
  const BenchInput& input = input_of(bench, state.range(0));
  double total = 0, triangles = 0;
  for (auto _ : state) {
    const GenerateResult result = generate_from(input);
    const double seconds = result.seconds.*phase;
    state.SetIterationTime(seconds);
    total += seconds;
    triangles = static_cast<double>(result.mesh.triangles.size());
  }
  report_speed(state, triangles, total);
}

double sum(const PhaseSeconds& s) {
  return s.background + s.boundary + s.front + s.enhance + s.verify;
}

/// Quality against the background metric, lengths as in the paper's tables.
void report_quality(benchmark::State& state, const BenchInput& input, const Mesh& mesh) {
  const MeshStatistics s = mesh_statistics(mesh, background_metric(input.mesh, input.field));
  state.counters["alpha_mean"] = s.quality_mean;
  state.counters["alpha_min"] = s.quality_min;
  state.counters["percent_in_band"] = s.percent_unit;
}

void run_generate(benchmark::State& state, const BenchCase& bench) {
  const BenchInput& input = input_of(bench, state.range(0));
  double total = 0, triangles = 0, bytes = 0;
  std::optional<Mesh> mesh;
  for (auto _ : state) {
    mesh.reset();
    const PeakMemory peak;
    GenerateResult result = generate_from(input);
    bytes = static_cast<double>(peak.bytes());
    const double seconds = sum(result.seconds);
    state.SetIterationTime(seconds);
    total += seconds;
    mesh = std::move(result.mesh);
    triangles = static_cast<double>(mesh->triangles.size());
  }
  report_speed(state, triangles, total);
  state.counters["bytes/triangle"] = bytes / triangles;
  report_quality(state, input, *mesh);
}

/// NAME.mesh and NAME.sol of an input in the temporary folder, removed at the end.
class InputFiles {
 public:
  explicit InputFiles(const BenchInput& input) {
    write_medit(mesh, input.mesh);
    write_medit_metric(metric, input.field);
  }
  ~InputFiles() {
    std::error_code ignored;
    std::filesystem::remove(mesh, ignored);
    std::filesystem::remove(metric, ignored);
  }
  InputFiles(const InputFiles&) = delete;
  InputFiles& operator=(const InputFiles&) = delete;

  const std::filesystem::path mesh = std::filesystem::temp_directory_path() / "bench_mesher.mesh";
  const std::filesystem::path metric = std::filesystem::temp_directory_path() / "bench_mesher.sol";
};

double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void run_read(benchmark::State& state, const BenchCase& bench) {
  const BenchInput& input = input_of(bench, state.range(0));
  const InputFiles files(input);
  const auto vertices = static_cast<Index>(input.mesh.points.size());
  const double start = cpu_seconds();
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_medit(files.mesh));
    benchmark::DoNotOptimize(read_medit_metric(files.metric, vertices));
  }
  report_speed(state, static_cast<double>(input.mesh.triangles.size()), cpu_seconds() - start);
}

void run_write(benchmark::State& state, const BenchCase& bench) {
  const BenchInput& input = input_of(bench, state.range(0));
  const InputFiles files(input);
  const double start = cpu_seconds();
  for (auto _ : state) write_medit(files.mesh, input.mesh);
  report_speed(state, static_cast<double>(input.mesh.triangles.size()), cpu_seconds() - start);
}

struct Phase {
  const char* name;
  double PhaseSeconds::*seconds;
};

constexpr Phase kPhases[] = {{"background", &PhaseSeconds::background},
                             {"boundary", &PhaseSeconds::boundary},
                             {"front", &PhaseSeconds::front},
                             {"enhance", &PhaseSeconds::enhance},
                             {"verify", &PhaseSeconds::verify}};

/// All benchmarks of one case and size follow each other, so that its input is made once.
void add_benchmarks(const BenchCase& bench, std::int64_t triangles) {
  const auto add = [&](const std::string& phase, auto&& run) {
    return benchmark::RegisterBenchmark((phase + "/" + bench.name).c_str(), run)
        ->Arg(triangles)
        ->Unit(benchmark::kMillisecond);
  };
  add("read", [&bench](benchmark::State& state) { run_read(state, bench); });
  for (const Phase& phase : kPhases)
    add(phase.name,
        [&bench, phase](benchmark::State& state) { run_phase(state, bench, phase.seconds); })
        ->UseManualTime()
        ->Iterations(triangles < 1'000'000 ? 5 : 1);
  add("generate", [&bench](benchmark::State& state) { run_generate(state, bench); })
      ->UseManualTime()
      ->Iterations(triangles < 1'000'000 ? 5 : 1);
  add("write", [&bench](benchmark::State& state) { run_write(state, bench); });
}

}  // namespace
}  // namespace anisofront

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 3;
  for (const char* name : anisofront::kCases)
    for (const std::int64_t triangles : anisofront::kSizes)
      anisofront::add_benchmarks(anisofront::bench_case(name), triangles);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
