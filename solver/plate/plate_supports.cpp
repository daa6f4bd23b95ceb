#include "solver/plate/plate_supports.hpp"

namespace anisofront {
namespace {

/// Along an axis the unknown itself is held, else the first of a pair turned to the direction.
void hold_direction(Vector direction, Index rotation, PlateConditions& conditions) {
  if (direction.y == 0) return conditions.constraints.push_back({rotation, 0});
  if (direction.x == 0) return conditions.constraints.push_back({rotation + 1, 0});
  conditions.frames.push_back({rotation, direction});
  conditions.constraints.push_back({rotation, 0});
}

}  // namespace

PlateConditions plate_conditions(const std::vector<SupportNode>& nodes, const DofMap& dofs,
                                 PlateElement element) {
  PlateConditions conditions;
  for (const SupportNode& node : nodes) {
    const NodeUnknowns unknowns = unknowns_of(node, dofs, element);
    if (!node.deflections.empty())
      conditions.constraints.push_back({unknowns.deflection(), node.deflections.front().value});
    if (node.directions.size() == 1)
      hold_direction(node.directions.front(), unknowns.rotation(), conditions);
    if (node.directions.size() == 2)
      for (const Index k : {0, 1}) conditions.constraints.push_back({unknowns.rotation() + k, 0});
  }
  return conditions;
}

PlateConditions plate_conditions(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                                 const PlateProblem& problem) {
  return plate_conditions(support_nodes(mesh, element, problem).nodes, dofs, element);
}

}  // namespace anisofront
