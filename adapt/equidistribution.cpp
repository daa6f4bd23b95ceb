// The relation between contributions and sizes: O. C. Zienkiewicz, J. Z. Zhu, A simple error
// estimator and adaptive procedure, Int. J. Numer. Meth. Engng 24 (1987) 337-357,
// doi:10.1002/nme.1620240206, section 5, with the contribution of an element as what is equal.
#include "adapt/equidistribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Least contribution, as a share of the mean.
constexpr double kLeast = 1e-6;

void require_contributions(const Mesh& mesh, std::span<const double> contributions) {
  if (contributions.size() != mesh.triangles.size() + mesh.quads.size())
    throw InputError("equidistribution: " + std::to_string(contributions.size()) +
                     " contributions for " +
                     std::to_string(mesh.triangles.size() + mesh.quads.size()) + " elements");
  for (std::size_t e = 0; e < contributions.size(); ++e)
    if (!(contributions[e] >= 0 && std::isfinite(contributions[e])))
      throw InputError("equidistribution: the contribution of element " + std::to_string(e) +
                       " is " + describe(contributions[e]) +
                       ", expected a finite number that is not negative");
}

double area_of(const Mesh& mesh, std::span<const Index> vertices) {
  const Point a = mesh.points[vertices[0]];
  double twice = 0;
  for (std::size_t k = 2; k < vertices.size(); ++k)
    twice += cross(mesh.points[vertices[k - 1]] - a, mesh.points[vertices[k]] - a);
  return 0.5 * twice;
}

/// Logarithms of the wanted densities, averaged over the elements around each vertex.
class MeanAtVertices {
 public:
  explicit MeanAtVertices(std::size_t vertices) : sum_(vertices), count_(vertices) {}

  void add(std::span<const Index> vertices, double value) {
    for (const Index v : vertices) {
      sum_[v] += value;
      ++count_[v];
    }
  }
  bool has(std::size_t v) const { return count_[v] > 0; }
  double at(std::size_t v) const { return sum_[v] / count_[v]; }

 private:
  std::vector<double> sum_;
  std::vector<int> count_;
};

MeanAtVertices wanted_densities(const Mesh& mesh, std::span<const double> contributions, int order,
                                double mean) {
  MeanAtVertices wanted(mesh.points.size());
  std::size_t e = 0;
  const auto add = [&](std::span<const Index> vertices) {
    const double share = std::max(contributions[e++] / mean, kLeast);
    wanted.add(vertices, std::log(share) / (order + 1) - std::log(area_of(mesh, vertices)));
  };
  for (const auto& triangle : mesh.triangles) add(triangle);
  for (const auto& quad : mesh.quads) add(quad);
  return wanted;
}

}  // namespace

void equidistribute(const Mesh& mesh, std::span<const double> contributions, int order,
                    double stretch, PrincipalField& field) {
  require_contributions(mesh, contributions);
  const double mean = std::accumulate(contributions.begin(), contributions.end(), 0.) /
                      static_cast<double>(contributions.size());
  if (!(mean > 0)) return;
  const MeanAtVertices wanted = wanted_densities(mesh, contributions, order, mean);
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (!wanted.has(v)) continue;
    PrincipalMetric& m = field[v];
    const double ratio = std::min(std::sqrt(m.l1 / m.l2), stretch),
                 density = std::exp(wanted.at(v));
    m.l1 = density * ratio;
    m.l2 = density / ratio;
  }
}

}  // namespace anisofront
