#pragma once

#include <string>
#include <vector>

#include "mesher/generate.hpp"

namespace anisofront {

/// A metric on a square whose sizes grow in proportion to `scale`, so that one shape of mesh comes
/// in every number of triangles.
struct BenchCase {
  std::string name;
  double side = 1;                                    ///< of the square [0, side]^2
  Metric (*metric)(double scale, Point p) = nullptr;  ///< exact metric at p
  bool isotropic = false;
};

/// uniform; example-2 (isotropic, paper section 5); layer (1:1000, axis-parallel); sine (1:1000
/// along a sine curve). For quadrilaterals besides: example-1, example-2-anisotropic; wall and arc
/// (data/studies/wall-layer.toml and curved-layer.toml). At scale 1 the paper's and the studies'
/// own sizes.
const std::vector<BenchCase>& bench_cases();

/// Throws UsageError, listing the names, when there is no such case.
const BenchCase& bench_case(const std::string& name);

/// What the mesher gets: a mesh of the wanted density with the exact metric at its vertices.
struct BenchInput {
  const BenchCase* bench;
  double scale = 1;
  Domain domain;
  Mesh mesh;
  MetricField field;
};

/// Adapts a coarse mesh to the case at growing densities until it has about `triangles` triangles.
BenchInput make_bench_input(const BenchCase& bench, double triangles);

/// The same with the scale given: a mesh adapted to it in six cycles.
BenchInput bench_input_of_scale(const BenchCase& bench, double scale);

MetricField exact_field(const BenchCase& bench, double scale, const Mesh& mesh);

/// Preset best, without the limit on the number of elements.
GenerateOptions bench_options();

}  // namespace anisofront
