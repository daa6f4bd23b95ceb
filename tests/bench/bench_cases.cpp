/// Makes the input files of compare.sh and compare_quads.sh and measures what came out of them.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>

#include "mesher/io/mesh_io.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/peer_files.hpp"
#include "tests/bench/quad_quality.hpp"

using namespace anisofront;

namespace {

constexpr const char* kUsage =
    "bench_cases make CASE TRIANGLES NAME     writes NAME.mesh, NAME.sol, NAME.mtr (bamg's "
    "metric)\n"
    "                                         and prints the scale; TRIANGLES \"paper\": scale 1\n"
    "bench_cases gmsh CASE NAME               writes NAME.geo and NAME.pos (sizes or metric) from\n"
    "                                         NAME.mesh and NAME.sol\n"
    "bench_cases metric CASE SCALE MESH SOL   writes the exact metric at the vertices of MESH\n"
    "bench_cases quads CASE SCALE MESH        prints, against the exact metric: quadrilaterals,\n"
    "                                         triangles left, their number by the ideal one, beta\n"
    "                                         mean and min of the convex ones, number of bad "
    "ones,\n"
    "                                         least and largest angle, percent of edges in\n"
    "                                         [0.5, 1.5] and in [1/sqrt2, sqrt2]\n";

double number(const char* text) {
  double value = 0;
  const char* end = text + std::strlen(text);
  if (std::from_chars(text, end, value).ptr != end || !(value > 0))
    throw UsageError(std::string(text) + " is not a number greater than zero");
  return value;
}

void make(const BenchCase& bench, const std::string& triangles, const std::string& name) {
  const BenchInput input = triangles == "paper"
                               ? bench_input_of_scale(bench, 1)
                               : make_bench_input(bench, number(triangles.c_str()));
  write_medit(name + ".mesh", input.mesh);
  write_medit_metric(name + ".sol", input.field);
  write_bamg_metric(name + ".mtr", input.field);
  std::printf("%.17g\n", input.scale);
}

void make_for_gmsh(const BenchCase& bench, const std::string& name) {
  const Mesh mesh = read_medit(name + ".mesh");
  const auto vertices = static_cast<Index>(mesh.points.size());
  write_gmsh_square(name + ".geo", bench.side);
  write_gmsh_view(name + ".pos", mesh, read_medit_metric(name + ".sol", vertices), bench.isotropic);
}

void print_quads(const BenchCase& bench, double scale, const std::string& file) {
  const QuadQuality q =
      quad_quality(read_mesh_file(file).mesh, [&](Point p) { return bench.metric(scale, p); });
  std::printf("%d\t%d\t%.3f\t%.4f\t%.3f\t%d\t%.1f\t%.1f\t%.3f\t%.3f\n", q.all.quads,
              q.all.triangles, q.all.quads / q.all.complexity, q.beta_mean, q.beta_min, q.bad,
              q.all.angle_min, q.all.angle_max, q.all.percent_half, q.all.percent_unit);
}

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "make" && argc == 5) {
    make(bench_case(argv[2]), argv[3], argv[4]);
    return 0;
  }
  if (command == "gmsh" && argc == 4) {
    make_for_gmsh(bench_case(argv[2]), argv[3]);
    return 0;
  }
  if (command == "metric" && argc == 6) {
    const Mesh mesh = read_medit(argv[4]);
    write_medit_metric(argv[5], exact_field(bench_case(argv[2]), number(argv[3]), mesh));
    return 0;
  }
  if (command == "quads" && argc == 5) {
    print_quads(bench_case(argv[2]), number(argv[3]), argv[4]);
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
