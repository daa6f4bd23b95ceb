/// All-quadrilateral meshing as a whole, in CPU time: <effort>/<case>/<quadrilaterals>.
/// bench_quads --benchmark_filter='fast/.*/100000'
#include <map>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "mesher/geometry/stopwatch.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/quad_quality.hpp"

namespace anisofront {
namespace {

constexpr const char* kCases[] = {"example-2", "example-1", "wall"};
constexpr std::int64_t kSizes[] = {1'000, 10'000, 100'000};
constexpr std::pair<const char*, QuadEffort> kEfforts[] = {{"fast", QuadEffort::fast},
                                                           {"best", QuadEffort::best}};

/// Unit equilateral triangles that cover a unit square.
constexpr double kTrianglesPerQuad = 2.3094010767585034;  // 4 / sqrt 3

/// Inputs are made once for both efforts.
const BenchInput& input_of(const BenchCase& bench, std::int64_t quads) {
  static std::map<std::pair<std::string, std::int64_t>, BenchInput> inputs;
  const auto key = std::pair(bench.name, quads);
  auto found = inputs.find(key);
  if (found == inputs.end()) {
    BenchInput made = make_bench_input(bench, kTrianglesPerQuad * static_cast<double>(quads));
    found = inputs.emplace(key, std::move(made)).first;
  }
  return found->second;
}

GenerateOptions quad_options(QuadEffort effort) {
  GenerateOptions options = bench_options();
  options.elements = Elements::quadrilateral;
  options.quads.effort = effort;
  return options;
}

void report_quality(benchmark::State& state, const BenchInput& input, const Mesh& mesh) {
  const QuadQuality q =
      quad_quality(mesh, [&input](Point p) { return input.bench->metric(input.scale, p); });
  state.counters["quads"] = q.all.quads;
  state.counters["quads/ideal"] = q.all.quads / q.all.complexity;
  state.counters["beta_mean"] = q.beta_mean;
  state.counters["beta_min"] = q.beta_min;
  state.counters["percent_in_band"] = q.all.percent_unit;
}

void run(benchmark::State& state, const BenchCase& bench, QuadEffort effort) {
  const BenchInput& input = input_of(bench, state.range(0));
  const GenerateOptions options = quad_options(effort);
  Mesh mesh;
  double total = 0;
  for (auto _ : state) {
    Stopwatch watch;
    mesh = generate(input.domain, input.mesh, input.field, options).mesh;
    const double seconds = watch.lap();
    state.SetIterationTime(seconds);
    total += seconds;
  }
  const double made =
      static_cast<double>(mesh.quads.size()) * static_cast<double>(state.iterations());
  state.counters["quads/s"] = made / total;
  report_quality(state, input, mesh);
}

void add_benchmark(const BenchCase& bench, const char* name, QuadEffort effort,
                   std::int64_t quads) {
  benchmark::RegisterBenchmark(
      (name + ("/" + bench.name)).c_str(),
      [&bench, effort](benchmark::State& state) { run(state, bench, effort); })
      ->Arg(quads)
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(quads < 100'000 ? 3 : 1);
}

}  // namespace
}  // namespace anisofront

int main(int argc, char** argv) {
  using namespace anisofront;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 3;
  for (const char* name : kCases)
    for (const std::int64_t quads : kSizes)
      for (const auto& [effort_name, effort] : kEfforts)
        add_benchmark(bench_case(name), effort_name, effort, quads);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
