#include "solver/system/constraints.hpp"

namespace anisofront {
namespace {

/// The entries (first, j) and (first + 1, j) are turned to components along the axis.
void turn(Vector axis, double& x, double& y) {
  const double along = axis.x * x + axis.y * y, across = axis.x * y - axis.y * x;
  x = along;
  y = across;
}

}  // namespace

void impose(std::span<const Constraint> constraints, LinearSystem& system) {
  std::vector<char> fixed(system.rhs.size(), 0);
  for (const auto& [unknown, value] : constraints) fixed[unknown] = 1;
  // Column `unknown` times the value goes to the right; the columns are still whole.
  for (const auto& [unknown, value] : constraints)
    if (value != 0)
      for (SparseMatrix::InnerIterator a(system.matrix, unknown); a; ++a)
        system.rhs[a.row()] -= a.value() * value;
  for (Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator a(system.matrix, column); a; ++a)
      if (a.row() != a.col() && (fixed[a.row()] || fixed[a.col()])) a.valueRef() = 0;
  for (const auto& [unknown, value] : constraints)
    system.rhs[unknown] = system.matrix.coeff(unknown, unknown) * value;
}

void rotate_to_frames(std::span<const Frame> frames, LinearSystem& system) {
  double* values = system.matrix.valuePtr();
  const Index* outer = system.matrix.outerIndexPtr();
  const Index* rows = system.matrix.innerIndexPtr();
  for (const auto& [first, axis] : frames) {
    // Columns: both have the same rows. Rows: the two stand side by side in each of the columns
    // that the pattern, which is symmetric, names.
    const Index height = outer[first + 1] - outer[first];
    double* x = values + outer[first];
    double* y = values + outer[first + 1];
    for (Index k = 0; k < height; ++k) turn(axis, x[k], y[k]);
    for (Index k = outer[first]; k < outer[first + 1]; ++k) {
      double* entry = &system.matrix.coeffRef(first, rows[k]);
      turn(axis, entry[0], entry[1]);
    }
    turn(axis, system.rhs[first], system.rhs[first + 1]);
  }
}

void rotate_back(std::span<const Frame> frames, Eigen::VectorXd& solution) {
  for (const auto& [first, axis] : frames)
    turn({axis.x, -axis.y}, solution[first], solution[first + 1]);
}

void rotate_to_frames(std::span<const Frame> frames, Eigen::VectorXd& vector) {
  for (const auto& [first, axis] : frames) turn(axis, vector[first], vector[first + 1]);
}

}  // namespace anisofront
