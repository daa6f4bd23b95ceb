#include "solver/plate/plate_reactions.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace anisofront {
namespace {

/// A x - b at an entry of SupportRows::unknowns.
class Residual {
 public:
  Residual(const SupportRows& rows, const Eigen::VectorXd& solution)
      : values_(rows.rows.transpose() * solution - rows.rhs) {}

  double force(std::size_t node) const { return at(3 * node); }

  /// What is left outside the held directions is round-off.
  Vector moment(std::size_t node, const std::vector<Vector>& directions) const {
    const Vector m{at(3 * node + 1), at(3 * node + 2)};
    return directions.size() == 1 ? dot(m, directions.front()) * directions.front() : m;
  }

 private:
  double at(std::size_t i) const { return values_[static_cast<Eigen::Index>(i)]; }

  Eigen::VectorXd values_;
};

std::vector<PlateReaction> without_forces(const PlateProblem& problem) {
  std::vector<PlateReaction> reactions;
  for (const PlateSupport& support : problem.supports)
    if (support.kind != SupportKind::free) reactions.push_back({support.tag, 0, {}, {}, 0});
  if (!problem.point_supports.empty()) reactions.push_back({});
  return reactions;
}

PlateReaction& of_tag(std::vector<PlateReaction>& reactions, Index tag) {
  return *std::find_if(reactions.begin(), reactions.end(),
                       [tag](const PlateReaction& r) { return r.tag == tag; });
}

Eigen::Matrix2d projection(const std::vector<Vector>& directions) {
  if (directions.size() == 2) return Eigen::Matrix2d::Identity();
  const Eigen::Vector2d d(directions.front().x, directions.front().y);
  return d * d.transpose();
}

/// The least couples (by the sum of their squares) that add up to `moment`, each along what its
/// support holds: c_i = P_i l with (sum of P_i) l = moment.
std::vector<Vector> shares(const SupportNode& node, Vector moment) {
  const std::size_t count = node.rotations.size();
  if (node.directions.size() < 2)
    return std::vector<Vector>(count, (1 / static_cast<double>(count)) * moment);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const HeldRotation& held : node.rotations) sum += projection(held.directions);
  const Eigen::Vector2d multiplier = sum.inverse() * Eigen::Vector2d(moment.x, moment.y);
  std::vector<Vector> couples;
  for (const HeldRotation& held : node.rotations) {
    const Eigen::Vector2d couple = projection(held.directions) * multiplier;
    couples.push_back({couple[0], couple[1]});
  }
  return couples;
}

void add_force(const SupportNode& node, double force, std::vector<PlateReaction>& reactions) {
  const double share = force / static_cast<double>(node.deflections.size());
  for (const HeldDeflection& held : node.deflections) {
    PlateReaction& reaction = of_tag(reactions, held.tag);
    reaction.force += share;
    reaction.lever = reaction.lever + share * node.at;
    reaction.largest = std::max(reaction.largest, std::abs(share));
  }
}

void add_couples(const SupportNode& node, Vector moment, std::vector<PlateReaction>& reactions) {
  const std::vector<Vector> couples = shares(node, moment);
  for (std::size_t i = 0; i < couples.size(); ++i) {
    PlateReaction& reaction = of_tag(reactions, node.rotations[i].tag);
    reaction.moment = reaction.moment + couples[i];
  }
}

}  // namespace

SupportRows support_rows(const LinearSystem& system, const std::vector<SupportNode>& nodes,
                         const DofMap& dofs, PlateElement element) {
  SupportRows kept;
  for (const SupportNode& node : nodes) {
    const NodeUnknowns unknowns = unknowns_of(node, dofs, element);
    const bool has_w = unknowns.components.w >= 0, turns = unknowns.components.rotation >= 0;
    kept.unknowns.push_back(has_w ? unknowns.deflection() : kNoIndex);
    for (const Index k : {0, 1})
      kept.unknowns.push_back(turns ? unknowns.rotation() + k : kNoIndex);
  }
  const auto count = static_cast<Index>(kept.unknowns.size());
  kept.rows.resize(system.matrix.rows(), count);
  kept.rhs.setZero(count);
  for (Index i = 0; i < count; ++i) {
    kept.rows.startVec(i);
    if (kept.unknowns[i] == kNoIndex) continue;
    kept.rhs[i] = system.rhs[kept.unknowns[i]];
    for (SparseMatrix::InnerIterator a(system.matrix, kept.unknowns[i]); a; ++a)
      kept.rows.insertBack(a.row(), i) = a.value();
  }
  kept.rows.finalize();
  return kept;
}

SupportForces support_forces(const SupportRows& rows, const std::vector<SupportNode>& nodes,
                             const PlateProblem& problem, const Eigen::VectorXd& solution) {
  const Residual residual(rows, solution);
  SupportForces result{without_forces(problem), 0};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const SupportNode& node = nodes[i];
    if (!node.deflections.empty()) {
      add_force(node, residual.force(i), result.reactions);
      result.work += residual.force(i) * node.deflections.front().value;
    }
    if (!node.directions.empty())
      add_couples(node, residual.moment(i, node.directions), result.reactions);
  }
  return result;
}

}  // namespace anisofront
