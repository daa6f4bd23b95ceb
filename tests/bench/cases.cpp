#include "tests/bench/cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/geometry/curve.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "mesher/metric/intersection.hpp"

namespace anisofront {
namespace {

using std::numbers::pi;

/// Size h1 along the direction, h2 across it.
Metric metric_along(Vector direction, double h1, double h2) {
  const Vector e = (1 / norm(direction)) * direction;
  const double a = 1 / (h1 * h1), b = 1 / (h2 * h2);
  return {a * e.x * e.x + b * e.y * e.y, (a - b) * e.x * e.y, a * e.y * e.y + b * e.x * e.x};
}

Metric uniform(double scale, Point) { return metric_along({1, 0}, 0.02 * scale, 0.02 * scale); }

/// Example 2, isotropic, of the paper.
Metric example_2(double scale, Point p) {
  const double r = std::max(std::min(p.x, p.y), 0.);
  const double h = scale * (0.05 + 0.2 * std::pow(r, 1.25));
  return metric_along({1, 0}, h, h);
}

/// Example 2, anisotropic: a layer along each axis, intersected.
Metric example_2_anisotropic(double scale, Point p) {
  const auto layer = [](double r) { return 0.05 + 0.2 * std::pow(std::max(r, 0.), 1.25); };
  const auto along = [](double r) { return 8 * std::exp(-0.2079 * r); };
  const double h1 = scale * layer(p.x), h2 = scale * layer(p.y);
  return intersect(metric_along({1, 0}, along(p.y) * h2, h2),
                   metric_along({1, 0}, h1, along(p.x) * h1));
}

/// Example 1: a layer along each diagonal, intersected.
Metric example_1(double scale, Point p) {
  const auto layer = [scale](Vector across, double r) {
    const double h = scale * (0.05 + 0.15 * r);
    return metric_along(across, h, 15 * h * std::exp(-0.55 * r));
  };
  return intersect(layer({-1, 1}, std::fabs(p.x - p.y) / std::numbers::sqrt2),
                   layer({1, 1}, std::fabs(p.x + p.y - 10) / std::numbers::sqrt2));
}

/// data/studies/wall-layer.toml: a layer along x = 0.
Metric wall(double scale, Point p) {
  return metric_along({1, 0}, scale * (0.002 + 0.15 * p.x), scale * 0.1);
}

/// data/studies/curved-layer.toml: a layer along an arc.
Metric arc(double scale, Point p) {
  const double r = norm(p - Point{});
  const Vector across = r > 0 ? p - Point{} : Vector{1, 0};
  return metric_along(across, scale * (0.004 + 0.2 * std::fabs(r - 0.6)), scale * 0.08);
}

/// A straight layer along y = 1/2 whose thickness grows linearly on both sides.
Metric layer(double scale, Point p) {
  return metric_along({1, 0}, 0.1 * scale, scale * (1e-4 + 0.198 * std::fabs(p.y - 0.5)));
}

/// Stretch 1000 on a sine curve; the axes follow the curve and the sizes meet 0.2 away from it.
Metric sine(double scale, Point p) {
  constexpr double kAmplitude = 0.05, kWave = 2 * pi, kThin = 4e-6, kThick = 1000 * kThin;
  constexpr double kFar = 0.05, kWidth = 0.2;
  const double slope = kAmplitude * kWave * std::cos(kWave * p.x);
  const double height = std::fabs(p.y - 0.5 - kAmplitude * std::sin(kWave * p.x));
  const double s = std::tanh(height / std::sqrt(1 + slope * slope) / kWidth);
  return metric_along({1, slope}, scale * std::lerp(kThick, kFar, s),
                      scale * std::lerp(kThin, kFar, s));
}

Domain square(double side) {
  const Point corners[4] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  Domain domain;
  for (int i = 0; i < 4; ++i)
    domain.curves.push_back(
        {"side-" + std::to_string(i + 1), i + 1, make_line(corners[i], corners[(i + 1) % 4])});
  add_region(domain, "square", 5, {0, 1, 2, 3}, {});
  return domain;
}

Mesh two_triangles(const Domain& domain, double side) {
  Mesh mesh;
  mesh.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_regions = {5, 5};
  for (Index i = 0; i < 4; ++i) mesh.edges.push_back({{i, (i + 1) % 4}, i + 1, kNoIndex, {}});
  attach_to_domain(mesh, domain);
  return mesh;
}

void remesh(BenchInput& input) {
  input.field = exact_field(*input.bench, input.scale, input.mesh);
  input.mesh = generate(input.domain, std::move(input.mesh), input.field, bench_options()).mesh;
}

}  // namespace

const std::vector<BenchCase>& bench_cases() {
  static const std::vector<BenchCase> cases{{"uniform", 1, uniform, true},
                                            {"example-2", 10, example_2, true},
                                            {"layer", 1, layer},
                                            {"sine", 1, sine},
                                            {"example-1", 10, example_1},
                                            {"example-2-anisotropic", 10, example_2_anisotropic},
                                            {"wall", 1, wall},
                                            {"arc", 1, arc}};
  return cases;
}

const BenchCase& bench_case(const std::string& name) {
  std::string names;
  for (const BenchCase& bench : bench_cases()) {
    if (bench.name == name) return bench;
    names += " " + bench.name;
  }
  throw UsageError("no case \"" + name + "\"; there are:" + names);
}

MetricField exact_field(const BenchCase& bench, double scale, const Mesh& mesh) {
  MetricField field;
  field.reserve(mesh.points.size());
  for (const Point p : mesh.points) field.push_back(bench.metric(scale, p));
  return field;
}

GenerateOptions bench_options() {
  GenerateOptions options = generate_options(Preset::best);
  options.max_elements = std::numeric_limits<Index>::max();
  return options;
}

BenchInput bench_input_of_scale(const BenchCase& bench, double scale) {
  constexpr int kCycles = 6;
  BenchInput input{&bench, scale, square(bench.side), {}, {}};
  input.mesh = two_triangles(input.domain, bench.side);
  for (int cycle = 0; cycle < kCycles; ++cycle) remesh(input);
  input.field = exact_field(bench, scale, input.mesh);
  return input;
}

BenchInput make_bench_input(const BenchCase& bench, double triangles) {
  constexpr double kFirst = 2000, kGrowth = 8, kFirstScale = 8;
  constexpr int kFirstCycles = 6, kCycles = 2;
  BenchInput input{&bench, kFirstScale, square(bench.side), {}, {}};
  input.mesh = two_triangles(input.domain, bench.side);
  for (double wanted = std::min(kFirst, triangles);;
       wanted = std::min(kGrowth * wanted, triangles)) {
    for (int cycle = 0; cycle < (wanted <= kFirst ? kFirstCycles : kCycles); ++cycle) {
      remesh(input);
      input.scale *= std::sqrt(static_cast<double>(input.mesh.triangles.size()) / wanted);
    }
    if (wanted >= triangles) break;
  }
  input.field = exact_field(bench, input.scale, input.mesh);
  return input;
}

}  // namespace anisofront
