#pragma once

#include <functional>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "solver/space/dof_map.hpp"

namespace anisofront {

/// Square, both triangles stored, rows sorted within each column.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

struct LinearSystem {
  SparseMatrix matrix;
  Eigen::VectorXd rhs;
};

/// Matrix and load of one element in the local order of ElementDofs, inner unknowns last.
struct ElementSystem {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxElementDofs,
                kMaxElementDofs>
      matrix;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxElementDofs, 1> rhs;

  void set_zero(int unknowns) {
    matrix.setZero(unknowns, unknowns);
    rhs.setZero(unknowns);
  }
};

/// Fills the system of one element; called from several threads at once.
using ElementKernel = std::function<void(const Element&, ElementSystem&)>;

/// Sums the element systems, inner unknowns eliminated. The result does not depend on the number of
/// threads. `threads` 0: all cores. What a kernel throws is thrown on, that of the smallest element
/// first. Throws MeshingError naming an element whose inner block is singular.
LinearSystem assemble(const FeMesh& mesh, const DofMap& dofs, const ElementKernel& kernel,
                      int threads = 0);

/// Inner unknowns of all elements that belong to the global `solution`: those of element 0, of
/// element 1, ... (the kernel is evaluated again).
std::vector<double> inner_values(const FeMesh& mesh, const DofMap& dofs,
                                 const ElementKernel& kernel, const Eigen::VectorXd& solution,
                                 int threads = 0);

/// All local values of an element (global, then inner unknowns) in the order of ElementDofs.
using LocalValues = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxElementDofs, 1>;
LocalValues local_values(const FeMesh& mesh, const DofMap& dofs, const Element& element,
                         const std::vector<double>& values, const std::vector<double>& inner);

/// Adds to an entry that the pattern holds (both unknowns belong to one element).
void add_entry(LinearSystem& system, Index row, Index column, double value);

}  // namespace anisofront
