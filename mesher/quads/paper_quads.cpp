#include "mesher/quads/paper_quads.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "mesher/geometry/stopwatch.hpp"
#include "mesher/quads/mixed_quality.hpp"
#include "mesher/quads/mixed_topology.hpp"
#include "mesher/quads/pairing.hpp"
#include "mesher/quads/paper_conversion.hpp"

namespace anisofront {
namespace {

/// With vertices that may come as near as 0.1 to the front, twice as many triangles are made.
FrontOptions front_options(FrontOptions options) {
  constexpr double kLeastCloseness = 0.6;
  options.closeness = std::max(options.closeness, kLeastCloseness);
  return options;
}

Pairing pairing_of(QuadStart start) {
  return start == QuadStart::systematic ? Pairing::systematic : Pairing::beta_order;
}

}  // namespace

LevelMesh paper_quads(const QuadrangulateInput& input, const Monitor& monitor) {
  LevelMesh level;
  QuadrangulateInput coarse = input;
  coarse.front = front_options(input.front);
  Boundary boundary = coarse_triangulation(coarse, {1, 1, QuadStart::equilateral}, false,
                                           level.statistics, monitor);
  Stopwatch watch;
  level.point_vertices = std::move(boundary.point_vertices);
  MixedMesh mixed =
      pair_triangles(boundary.mesh, level.point_vertices, pairing_of(input.options.start));
  level.statistics.pairing += watch.lap();
  level.statistics.leftovers = triangle_count(mixed);
  level.statistics.triangles = 2 * static_cast<Index>(mixed.faces.size()) - triangle_count(mixed);
  smooth_mixed(input.background, mixed);
  eliminate_triangles(input.background, mixed);
  search_mixed(input.background, mixed);
  input.background.set_size_factor(1);
  level.mesh = divide_mixed(input.domain, input.background, mixed, true);
  smooth_mixed(input.background, level.mesh);
  search_mixed(input.background, level.mesh);
  level.statistics.levels = 1;
  level.statistics.cleaning += watch.lap();
  return level;
}

void warn_about_bad_quads(const MixedMesh& mesh, const Monitor& monitor) {
  constexpr double kBad = 0.05;
  int count = 0;
  double worst = kBad;
  Point place{0, 0};
  for (const MixedFace& face : mesh.faces) {
    const double quality = shape_quality(mesh, face);
    if (quality >= kBad) continue;
    ++count;
    if (quality >= worst) continue;
    worst = quality;
    place = mesh.vertices[face.vertices[0]].p;
  }
  if (count == 0) return;
  monitor.warning("badly shaped quadrilaterals (beta below 0.05): " + std::to_string(count) +
                  ", the worst with " + std::to_string(worst) + " near (" +
                  std::to_string(place.x) + ", " + std::to_string(place.y) +
                  "); ask for sizes that change less there, or use the method best");
}

}  // namespace anisofront
