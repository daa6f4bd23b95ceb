#include "solver/assemble.hpp"

#include <algorithm>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "solver/p1_element.hpp"
#include "solver/quadrature.hpp"

namespace anisofront {
namespace {

constexpr int kSourceDegree = 6;

void require_p1_problem(const Mesh& mesh, const ScalarProblem& problem) {
  if (!mesh.quads.empty() || mesh.triangles.empty())
    throw InputError("the scalar solver works on triangles: found " +
                     std::to_string(mesh.triangles.size()) + " triangles and " +
                     std::to_string(mesh.quads.size()) + " quadrilaterals");
  if (!(problem.diffusion > 0))
    throw InputError("diffusion is " + std::to_string(problem.diffusion) + ", expected > 0");
  if (!(problem.reaction >= 0))
    throw InputError("reaction is " + std::to_string(problem.reaction) + ", expected >= 0");
}

double source_at(const ScalarProblem& problem, Point p) {
  const double f = problem.source(p);
  if (!std::isfinite(f))
    throw InputError("the source is not finite at (" + std::to_string(p.x) + ", " +
                     std::to_string(p.y) + ")");
  return f;
}

/// Reference to A(row, column); the entry exists.
double& entry(SparseMatrix& matrix, Index row, Index column) {
  const Index* first = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
  const Index* last = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  return matrix.valuePtr()[std::lower_bound(first, last, row) - matrix.innerIndexPtr()];
}

void add_matrix(const P1Element& element, const Triangle& t, const ScalarProblem& problem,
                SparseMatrix& matrix) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double mass = element.area * (i == j ? 2. : 1.) / 12;
      const double stiffness = element.area * dot(element.gradients[i], element.gradients[j]);
      entry(matrix, t[i], t[j]) += problem.diffusion * stiffness + problem.reaction * mass;
    }
}

void add_source(const std::array<Point, 3>& corners, double area, const Triangle& t,
                const ScalarProblem& problem, Eigen::VectorXd& rhs) {
  for (const auto& [l, weight] : triangle_quadrature(kSourceDegree)) {
    const double f = source_at(problem, point_at(corners, l));
    for (int i = 0; i < 3; ++i) rhs[t[i]] += area * weight * f * l[i];
  }
}

}  // namespace

SparseMatrix vertex_matrix(const Mesh& mesh) {
  const auto n = static_cast<Index>(mesh.points.size());
  const VertexNeighbours around = vertex_neighbours(mesh);
  SparseMatrix matrix(n, n);
  matrix.resizeNonZeros(around.first[n] + n);
  for (Index v = 0; v <= n; ++v) matrix.outerIndexPtr()[v] = around.first[v] + v;
  for (Index v = 0; v < n; ++v) {
    Index* rows = matrix.innerIndexPtr() + matrix.outerIndexPtr()[v];
    Index* end = std::copy(around.vertices.data() + around.first[v],
                           around.vertices.data() + around.first[v + 1], rows);
    *end = v;
    std::sort(rows, end + 1);
  }
  std::fill_n(matrix.valuePtr(), matrix.nonZeros(), 0.);
  return matrix;
}

LinearSystem assemble(const Mesh& mesh, const ScalarProblem& problem) {
  require_p1_problem(mesh, problem);
  LinearSystem system{vertex_matrix(mesh), Eigen::VectorXd::Zero(mesh.points.size())};
  for (const Triangle& t : mesh.triangles) {
    const auto corners = corners_of(mesh, t);
    const P1Element element(corners);
    add_matrix(element, t, problem, system.matrix);
    if (problem.source) add_source(corners, element.area, t, problem, system.rhs);
  }
  return system;
}

}  // namespace anisofront
