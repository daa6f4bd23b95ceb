/// The solver for compare_solver.sh: meshes of about the wanted number of unknowns, and timed
/// solutions on them. Times are wall seconds with all cores.
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <set>

#include "mesher/io/mesh_io.hpp"
#include "solver/plate/solve_plate.hpp"
#include "solver/scalar/solve_scalar.hpp"
#include "tests/bench/cases.hpp"

using namespace anisofront;

namespace {

constexpr const char* kUsage =
    "bench_solver mesh CASE KIND UNKNOWNS FILE   writes a mesh on which KIND (P1, P2, plate) has\n"
    "                                            about UNKNOWNS unknowns; cases: see bench_cases\n"
    "bench_solver P1|P2 FILE [METHOD]            -Laplace u = 1, u = 0 on the boundary; METHOD:\n"
    "                                            automatic, supernodal, multigrid\n"
    "bench_solver plate FILE [METHOD]            clamped MITC7 plate, thickness 1/1000\n"
    "The last two print unknowns, seconds of assembly, of the linear solver and of all, the "
    "energy,\n"
    "steps of refinement, steps of conjugate gradients, the residual and the method.\n";

[[noreturn]] void refuse(const std::string& what) { throw UsageError(what + "\n" + kUsage); }

double number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  if (std::from_chars(text.data(), end, value).ptr != end || !(value > 0))
    refuse(text + " is not a number greater than zero");
  return value;
}

/// Unknowns by triangles on large meshes, where there are half as many vertices and one and a half
/// times as many edges.
double unknowns_per_triangle(const std::string& kind) {
  if (kind == "P1") return 0.5;
  if (kind == "P2") return 2;
  if (kind == "plate") return 6;
  refuse("no kind " + kind);
}

void write_mesh(const std::string& name, double triangles, const std::string& file) {
  const BenchInput input = make_bench_input(bench_case(name), triangles);
  write_medit(file, generate(input.domain, input.mesh, input.field, bench_options()).mesh);
}

std::set<Index> boundary_tags(const Mesh& mesh) {
  std::set<Index> tags;
  for (const CurveEdge& edge : mesh.edges) tags.insert(edge.tag);
  return tags;
}

LinearOptions linear_options(const std::string& method) {
  LinearOptions options;
  if (method == "supernodal")
    options.method = LinearMethod::supernodal;
  else if (method == "multigrid")
    options.method = LinearMethod::multigrid;
  else if (method != "automatic")
    refuse("no method " + method);
  return options;
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The edges of the mesh are numbered within the assembly.
template <class Solution>
void print(double start, double numbered, double energy, const Solution& solution) {
  const double all = wall_seconds() - start;
  const LinearReport& linear = solution.linear;
  std::printf("%d\t%.3f\t%.3f\t%.3f\t%.3f\t%.12g\t%d\t%d\t%.1e\t%s\n", linear.unknowns,
              numbered - start + solution.assembly_seconds, linear.factor_seconds,
              linear.solve_seconds, all, energy, linear.refinements, linear.iterations,
              linear.residual, linear.method.c_str());
}

void solve_poisson(int order, const Mesh& mesh, const std::string& method) {
  ScalarProblem problem;
  problem.source = 1.;
  for (const Index tag : boundary_tags(mesh)) problem.dirichlet.push_back({tag, 0.});
  ScalarOptions options;
  options.order = order;
  options.linear = linear_options(method);
  const double start = wall_seconds();
  const FeMesh fe_mesh = straight_fe_mesh(mesh);
  const double numbered = wall_seconds();
  const ScalarSolution solution = solve_scalar(fe_mesh, problem, options);
  print(start, numbered, solution.squared_energy, solution);
}

void solve_clamped_plate(const Mesh& mesh, const std::string& method) {
  PlateProblem problem;
  problem.material.thickness = 1e-3;
  problem.material.young = 1 / problem.material.bending_stiffness();  // D = 1
  problem.load = 1.;
  for (const Index tag : boundary_tags(mesh))
    problem.supports.push_back({tag, SupportKind::clamped, 0.});
  PlateOptions options;
  options.linear = linear_options(method);
  const double start = wall_seconds();
  const FeMesh fe_mesh = straight_fe_mesh(mesh);
  const double numbered = wall_seconds();
  const PlateSolution solution = solve_plate(fe_mesh, problem, options);
  print(start, numbered, solution.energy.total(), solution);
}

void solve(const std::string& kind, const std::string& file, const std::string& method) {
  const Mesh mesh = read_mesh_file(file).mesh;
  if (kind == "plate") return solve_clamped_plate(mesh, method);
  unknowns_per_triangle(kind);
  solve_poisson(kind == "P1" ? 1 : 2, mesh, method);
}

void run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 5 && arguments[0] == "mesh")
    return write_mesh(arguments[1], number(arguments[3]) / unknowns_per_triangle(arguments[2]),
                      arguments[4]);
  if (arguments.size() != 2 && arguments.size() != 3) refuse("wrong number of arguments");
  solve(arguments[0], arguments[1], arguments.size() == 3 ? arguments[2] : "automatic");
}

}  // namespace

int main(int count, char** words) {
  try {
    run({words + 1, words + count});
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_solver: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_solver: %s\n", error.what());
    return 1;
  }
}
