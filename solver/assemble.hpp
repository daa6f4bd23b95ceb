#pragma once

#include <Eigen/SparseCore>

#include "mesher/mesh/mesh.hpp"
#include "solver/scalar_problem.hpp"

namespace anisofront {

/// Square, symmetric, both triangles stored, rows sorted within each column.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

struct LinearSystem {
  SparseMatrix matrix;
  Eigen::VectorXd rhs;
};

/// Zero matrix with one entry per vertex and per pair of vertices that share an edge.
SparseMatrix vertex_matrix(const Mesh& mesh);

/// P1 system of the problem without its Dirichlet conditions: one unknown per vertex,
/// A_ij = int a grad l_i . grad l_j + c l_i l_j, b_i = int f l_i (quadrature of degree 6, so that
/// layers of f one element wide are still integrated well).
/// Precondition: valid mesh. Throws InputError for meshes with quadrilaterals or without triangles,
/// for a <= 0, c < 0 and for a source that is not finite (naming the point).
LinearSystem assemble(const Mesh& mesh, const ScalarProblem& problem);

}  // namespace anisofront
