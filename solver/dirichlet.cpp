#include "solver/dirichlet.hpp"

#include <cmath>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

double value_at(const DirichletCondition& condition, Point p) {
  const double value = condition.value(p);
  if (!std::isfinite(value))
    throw InputError("the boundary value on tag " + std::to_string(condition.tag) +
                     " is not finite at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                     ")");
  return value;
}

[[noreturn]] void throw_unused(const Mesh& mesh, Index tag) {
  throw InputError("boundary condition on tag " + std::to_string(tag) + " (\"" +
                   group_name(mesh, 1, tag) +
                   "\"): no edge of the mesh carries it; check the curve names");
}

}  // namespace

std::vector<Constraint> dirichlet_constraints(const Mesh& mesh,
                                              std::span<const DirichletCondition> conditions) {
  std::vector<const DirichletCondition*> of_vertex(mesh.points.size(), nullptr);
  for (const DirichletCondition& condition : conditions) {
    bool used = false;
    for (const CurveEdge& edge : mesh.edges) {
      if (edge.tag != condition.tag) continue;
      used = true;
      for (const Index v : edge.vertices)
        if (!of_vertex[v]) of_vertex[v] = &condition;
    }
    if (!used) throw_unused(mesh, condition.tag);
  }
  std::vector<Constraint> constraints;
  for (Index v = 0; v < static_cast<Index>(of_vertex.size()); ++v)
    if (of_vertex[v]) constraints.push_back({v, value_at(*of_vertex[v], mesh.points[v])});
  return constraints;
}

void impose(std::span<const Constraint> constraints, LinearSystem& system) {
  std::vector<char> fixed(system.rhs.size(), 0);
  for (const auto& [unknown, value] : constraints) {
    fixed[unknown] = 1;
    for (SparseMatrix::InnerIterator a(system.matrix, unknown); a; ++a)
      system.rhs[a.row()] -= a.value() * value;
  }
  for (Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator a(system.matrix, column); a; ++a)
      if (a.row() != a.col() && (fixed[a.row()] || fixed[a.col()])) a.valueRef() = 0;
  for (const auto& [unknown, value] : constraints)
    system.rhs[unknown] = system.matrix.coeff(unknown, unknown) * value;
}

}  // namespace anisofront
