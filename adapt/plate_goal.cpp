#include <algorithm>
#include <cmath>

#include "adapt/element_loop.hpp"
#include "adapt/goal_mean.hpp"
#include "adapt/goal_trace.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/plate/nearest_vertex.hpp"
#include "solver/plate/plate_text.hpp"
#include "solver/scalar/scalar_basis.hpp"

namespace anisofront {
namespace {

bool holds_deflection(SupportKind kind) {
  return kind != SupportKind::free && kind != SupportKind::symmetry;
}

void require_held(const Mesh& mesh, const PlateProblem& problem, Index tag) {
  const std::string what = "goal: the force on " + describe_tag(mesh, 1, tag);
  if (std::none_of(mesh.edges.begin(), mesh.edges.end(),
                   [tag](const CurveEdge& edge) { return edge.tag == tag; }))
    throw InputError(what + ": no edge of the mesh carries it; check the name of the curve");
  if (std::none_of(problem.supports.begin(), problem.supports.end(),
                   [tag](const PlateSupport& support) {
                     return support.tag == tag && holds_deflection(support.kind);
                   }))
    throw InputError(what +
                     ": the deflection is not held there, expected a curve with a support, whose "
                     "force is a result");
}

double force_on(const Mesh& mesh, const PlateProblem& problem, const PlateSolution& solution,
                Index tag) {
  require_held(mesh, problem, tag);
  for (const PlateReaction& reaction : solution.reactions)
    if (reaction.tag == tag) return reaction.force;
  throw InputError(
      "goal: the force on " + describe_tag(mesh, 1, tag) +
      ": the solution has no reaction there, expected one of the same problem and mesh");
}

/// A vertex counts to each support that holds it in equal parts (PlateReaction).
ReactionShares reaction_shares(const FeMesh& mesh, const PlateProblem& problem, Index tag) {
  ReactionShares shares;
  for (const SupportNode& node : support_nodes(mesh, PlateElement::mitc, problem).nodes) {
    const auto own = std::count_if(node.deflections.begin(), node.deflections.end(),
                                   [tag](const HeldDeflection& held) { return held.tag == tag; });
    const auto all = static_cast<std::ptrdiff_t>(node.deflections.size());
    if (own > 0 && own < all)
      shares.emplace_back(node.at, static_cast<double>(own) / static_cast<double>(all));
  }
  return shares;
}

bool counts_tying(const FeMesh& mesh, const PlateProblem& problem, PlateElement element,
                  const Goal& goal) {
  if (element == PlateElement::arnold_falk) return false;
  return goal.kind != Goal::Kind::curve_flux || reaction_shares(mesh, problem, goal.tag).empty();
}

/// grad w_h - theta_h - Q_h / (k G t). Deflections of all elements are of second order at most.
class ElementMismatch {
 public:
  ElementMismatch(const FeMesh& mesh, const PlateProblem& problem, const PlateSolution& solution,
                  const Element& element)
      : element_(element),
        kind_(solution.element),
        material_(problem.material_in(element.region)),
        values_(local_values(mesh, solution.dofs, element, solution.values, solution.inner)) {
    const auto nodes = second_order_nodes(element.shape);
    for (std::size_t j = 0; j < nodes.size(); ++j) deflections_[j] = state(nodes[j]).w;
  }

  /// Times sqrt(k G t).
  Vector at(ReferencePoint at) const {
    const ScalarBasis basis = scalar_basis(element_.shape, 2, at);
    Vector slope;
    for (int j = 0; j < basis.count; ++j) slope = slope + deflections_[j] * basis.gradient[j];
    const PlateState here = state(at);
    const double stiffness = material_.shear_stiffness();
    return std::sqrt(stiffness) *
           (map_at(element_, at).gradient(slope) - here.rotation - (1 / stiffness) * here.shear);
  }

 private:
  PlateState state(ReferencePoint at) const {
    return plate_state(kind_, material_, element_, values_, at);
  }

  const Element& element_;
  PlateElement kind_;
  const PlateMaterial& material_;
  LocalValues values_;
  std::array<double, 9> deflections_{};
};

Point vertex_at(const FeMesh& mesh, Point p) {
  return mesh.mesh.points[nearest_vertex(mesh, p, "the point support")];
}

}  // namespace

PlateProblem dual_problem(const FeMesh& mesh, const PlateProblem& problem, const Goal& goal) {
  PlateProblem dual = problem;
  dual.edge_loads.clear();
  dual.point_loads.clear();
  const bool is_flux = goal.kind == Goal::Kind::curve_flux;
  if (is_flux) require_held(mesh.mesh, problem, goal.tag);
  dual.load = is_flux ? RegionCoefficient(0.) : mean_source(mesh, goal);
  const ReactionShares shares =
      is_flux ? reaction_shares(mesh, problem, goal.tag) : ReactionShares{};
  for (PlateSupport& support : dual.supports)
    support.deflection = dual_trace(shares, is_flux && support.tag == goal.tag ? -1 : 0);
  for (PlatePointSupport& point : dual.point_supports)
    point.deflection = dual_trace(shares, 0)(vertex_at(mesh, point.at));
  return dual;
}

double goal_value(const FeMesh& mesh, const PlateProblem& problem, const PlateSolution& solution,
                  const Goal& goal) {
  if (goal.kind == Goal::Kind::curve_flux) return force_on(mesh.mesh, problem, solution, goal.tag);
  return mean_of(mesh, goal_mean(mesh, goal), [&](const Element& element, ReferencePoint at) {
    return plate_state(mesh, problem, solution, element, at).w;
  });
}

std::vector<double> tying_mismatch(const FeMesh& mesh, const PlateProblem& problem,
                                   const PlateSolution& solution, const FluxSamples& samples,
                                   const Goal& goal) {
  if (!counts_tying(mesh, problem, solution.element, goal)) return {};
  std::vector<double> mismatch(2 * samples.points.size());
  for_each_index(mesh.element_count(), [&](Index e) {
    const Element element = element_at(mesh, e);
    const ElementMismatch own(mesh, problem, solution, element);
    for (auto s = static_cast<std::size_t>(samples.first[e]);
         s < static_cast<std::size_t>(samples.first[e + 1]); ++s) {
      const Vector gamma = own.at(samples.at[s]);
      mismatch[2 * s] = gamma.x;
      mismatch[2 * s + 1] = gamma.y;
    }
  });
  return mismatch;
}

}  // namespace anisofront
