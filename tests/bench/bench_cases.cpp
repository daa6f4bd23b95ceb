/// Makes the input files of compare.sh and the exact metric on any mesh of a case.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>

#include "mesher/io/medit.hpp"
#include "tests/bench/cases.hpp"

using namespace anisofront;

namespace {

constexpr const char* kUsage =
    "bench_cases make CASE TRIANGLES NAME       writes NAME.mesh, NAME.sol, NAME.mtr (bamg's "
    "metric)"
    " and prints the scale\n"
    "bench_cases metric CASE SCALE MESH SOL     writes the exact metric at the vertices of MESH\n";

double number(const char* text) {
  double value = 0;
  const char* end = text + std::strlen(text);
  if (std::from_chars(text, end, value).ptr != end || !(value > 0))
    throw UsageError(std::string(text) + " is not a number greater than zero");
  return value;
}

/// bamg's metric format: vertices and components, then m11 m12 m22 line by line.
void write_bamg_metric(const std::string& path, const MetricField& field) {
  std::ofstream out(path);
  out.precision(17);
  out << field.size() << " 3\n";
  for (const Metric& m : field) out << m.m11 << ' ' << m.m12 << ' ' << m.m22 << '\n';
  if (!out.flush()) throw InputError(path + ": cannot be written");
}

void make(const BenchCase& bench, double triangles, const std::string& name) {
  const BenchInput input = make_bench_input(bench, triangles);
  write_medit(name + ".mesh", input.mesh);
  write_medit_metric(name + ".sol", input.field);
  write_bamg_metric(name + ".mtr", input.field);
  std::printf("%.17g\n", input.scale);
}

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "make" && argc == 5) {
    make(bench_case(argv[2]), number(argv[3]), argv[4]);
    return 0;
  }
  if (command == "metric" && argc == 6) {
    const Mesh mesh = read_medit(argv[4]);
    write_medit_metric(argv[5], exact_field(bench_case(argv[2]), number(argv[3]), mesh));
    return 0;
  }
  std::fputs(kUsage, stderr);
  return static_cast<int>(ErrorKind::usage);
}

}  // namespace

int main(int argc, char** argv) try { return run(argc, argv); } catch (const Error& error) {
  std::fprintf(stderr, "bench_cases: %s\n", error.what());
  return static_cast<int>(error.kind());
}
