#include "solver/plate/nearest_vertex.hpp"

#include <limits>
#include <string>

#include "mesher/geometry/curve_piece.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Points count as inside up to this share of the diagonal of the box.
constexpr double kTolerance = 1e-6;

}  // namespace

Index nearest_vertex(const FeMesh& mesh, Point p, const char* what) {
  detail::Box box;
  Index nearest = kNoIndex;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& edge : mesh.edges.vertices)
    for (const Index v : edge) {
      const Point x = mesh.mesh.points[v];
      const double squared = squared_norm(x - p);
      box.add(x);
      if (squared > least || (squared == least && v > nearest)) continue;
      least = squared;
      nearest = v;
    }
  if (box.distance(p) > kTolerance * box.diagonal())
    throw InputError(std::string(what) + " at " + describe(p) +
                     " lies outside the mesh, which reaches from " + describe(box.low) + " to " +
                     describe(box.high));
  return nearest;
}

}  // namespace anisofront
