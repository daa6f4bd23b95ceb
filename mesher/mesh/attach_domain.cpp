// Which curve of a domain, and which part of it, an edge of a coarse mesh stands for.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "mesher/geometry/curve_locator.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {
namespace {

constexpr double kEndReach = 1e-6;  // of the edge length: rounding of coordinates in files

/// An edge laid on a curve.
struct Fit {
  Index curve = kNoIndex;
  double end_distance = 0;     ///< the larger of both vertices
  double middle_distance = 0;  ///< of the midpoint of the chord
  double middle_parameter = 0;
  std::array<double, 2> parameters{};
};

class EdgeFitter {
 public:
  EdgeFitter(const Domain& domain, double tolerance) : domain_(domain), tolerance_(tolerance) {
    for (const DomainCurve& curve : domain.curves)
      locators_.emplace_back(std::vector<NurbsCurve>{curve.curve});
  }

  /// Among the curves that both vertices lie on the one nearest to the middle of the edge; where
  /// there is none the one nearest to the vertices.
  Fit best(const std::vector<Index>& candidates, Point a, Point b) const {
    Fit best;
    for (const Index candidate : candidates) {
      const Fit fit = project(candidate, a, b);
      if (best.curve == kNoIndex || is_better(fit, best)) best = fit;
    }
    return best;
  }

 private:
  bool is_better(const Fit& a, const Fit& b) const {
    const bool a_lies = a.end_distance <= tolerance_, b_lies = b.end_distance <= tolerance_;
    if (a_lies != b_lies) return a_lies;
    return a_lies ? a.middle_distance < b.middle_distance : a.end_distance < b.end_distance;
  }

  Fit project(Index index, Point a, Point b) const {
    const CurveLocator& locator = locators_[static_cast<std::size_t>(index)];
    const CurveProjection at_a = locator.nearest(a), at_b = locator.nearest(b);
    const CurveProjection middle = locator.nearest(lerp(a, b, 0.5));
    Fit fit{index,
            std::max(at_a.distance, at_b.distance),
            middle.distance,
            middle.parameter,
            {at_a.parameter, at_b.parameter}};
    const NurbsCurve& curve = domain_.curves[static_cast<std::size_t>(index)].curve;
    const double reach = kEndReach * norm(b - a);
    snap_to_end(curve, a, reach, fit.middle_parameter, fit.parameters[0]);
    snap_to_end(curve, b, reach, fit.middle_parameter, fit.parameters[1]);
    return fit;
  }

  /// A vertex at an end of the curve has exactly its parameter; at the seam of a closed curve,
  /// where there are two, that on the side of the edge.
  static void snap_to_end(const NurbsCurve& curve, Point vertex, double reach, double middle,
                          double& t) {
    const double begin = curve.begin_parameter(), end = curve.end_parameter();
    const bool at_begin = norm(vertex - curve.points.front()) <= reach;
    const bool at_end = norm(vertex - curve.points.back()) <= reach;
    if (at_begin && (!at_end || middle - begin < end - middle))
      t = begin;
    else if (at_end)
      t = end;
  }

  const Domain& domain_;
  double tolerance_;
  std::vector<CurveLocator> locators_;
};

std::vector<Index> curves_of_tag(const Domain& domain, Index tag) {
  std::vector<Index> curves;
  for (std::size_t c = 0; tag != 0 && c < domain.curves.size(); ++c)
    if (domain.curves[c].tag == tag) curves.push_back(static_cast<Index>(c));
  return curves;
}

std::vector<Index> candidates(const Mesh& mesh, const Domain& domain, Index tag) {
  const std::string name = group_name(mesh, 1, tag);
  const Index named = name.empty() ? kNoIndex : find_curve(domain, name);
  std::vector<Index> curves = curves_of_tag(
      domain, named == kNoIndex ? tag : domain.curves[static_cast<std::size_t>(named)].tag);
  if (curves.empty() && named != kNoIndex) curves.push_back(named);
  if (!curves.empty()) return curves;
  curves.resize(domain.curves.size());
  std::iota(curves.begin(), curves.end(), 0);
  return curves;
}

std::string describe_edge(const Mesh& mesh, const CurveEdge& edge) {
  std::string text = "the edge between the vertices";
  for (const std::size_t k : {0, 1})
    text += (k == 0 ? " " : " and ") + std::to_string(edge.vertices[k] + 1) + " " +
            describe(mesh.points[static_cast<std::size_t>(edge.vertices[k])]);
  const std::string name = group_name(mesh, 1, edge.tag);
  return name.empty() ? text : text + " of group '" + name + "'";
}

void require_on_curve(const Mesh& mesh, const Domain& domain, const CurveEdge& edge, const Fit& fit,
                      double tolerance) {
  if (fit.end_distance <= tolerance) return;
  throw InputError(describe_edge(mesh, edge) + " is " + describe(fit.end_distance) +
                   " away from curve '" + domain.curves[static_cast<std::size_t>(fit.curve)].name +
                   "'; expected at most " + describe(tolerance) +
                   ": name the group after its curve or use a mesh of this domain");
}

/// Parameters tell the two ways round a closed curve apart only when the edge takes the shorter.
void require_short(const Mesh& mesh, const Domain& domain, const CurveEdge& edge, const Fit& fit) {
  const DomainCurve& curve = domain.curves[static_cast<std::size_t>(fit.curve)];
  const auto [low, high] = std::minmax(fit.parameters[0], fit.parameters[1]);
  const bool off_seam = low <= fit.middle_parameter && fit.middle_parameter <= high;
  if (!is_closed(curve.curve) || off_seam != crosses_seam(curve.curve, fit.parameters)) return;
  throw InputError(describe_edge(mesh, edge) + " spans more than half of the closed curve '" +
                   curve.name + "' in parameter; expected a finer mesh");
}

void require_vertices(const Mesh& mesh, std::size_t index) {
  const auto count = static_cast<Index>(mesh.points.size());
  for (const Index v : mesh.edges[index].vertices)
    if (v < 0 || v >= count)
      throw InputError("edge " + std::to_string(index + 1) + ": found vertex " +
                       std::to_string(v + 1) + "; expected a number from 1 to " +
                       std::to_string(count));
}

void add_boundary_edges(Mesh& mesh) {
  for (const std::array<Index, 2>& vertices : boundary_edges(mesh))
    mesh.edges.push_back({vertices, 0, kNoIndex, {}});
}

}  // namespace

bool crosses_seam(const NurbsCurve& curve, const std::array<double, 2>& parameters) {
  const double range = curve.end_parameter() - curve.begin_parameter();
  return is_closed(curve) && std::fabs(parameters[1] - parameters[0]) > 0.5 * range;
}

void attach_to_domain(Mesh& mesh, const Domain& domain, double tolerance) {
  if (domain.curves.empty())
    throw InputError("attaching a mesh: found a domain without curves; expected at least one");
  if (mesh.edges.empty()) add_boundary_edges(mesh);
  const double distance = tolerance * bounding_diagonal(domain);
  const EdgeFitter fitter(domain, distance);
  Index known_tag = 0;
  std::vector<Index> known = candidates(mesh, domain, known_tag);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    CurveEdge& edge = mesh.edges[e];
    require_vertices(mesh, e);
    if (edge.tag != known_tag) known = candidates(mesh, domain, known_tag = edge.tag);
    const Fit fit = fitter.best(known, mesh.points[static_cast<std::size_t>(edge.vertices[0])],
                                mesh.points[static_cast<std::size_t>(edge.vertices[1])]);
    require_on_curve(mesh, domain, edge, fit, distance);
    require_short(mesh, domain, edge, fit);
    edge.curve = fit.curve;
    edge.parameters = fit.parameters;
    if (edge.tag == 0) edge.tag = domain.curves[static_cast<std::size_t>(fit.curve)].tag;
  }
}

}  // namespace anisofront
