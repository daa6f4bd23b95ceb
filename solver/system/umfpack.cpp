#include <algorithm>
#include <array>
#include <memory>

#include <umfpack.h>

#include "mesher/geometry/error.hpp"
#include "solver/system/factors.hpp"
#include "solver/system/single_thread.hpp"

namespace anisofront {
namespace {

using Long = SuiteSparse_long;

/// S A S and its factors in UMFPACK's integers.
struct Umfpack {
  std::vector<Long> begin, rows;
  std::vector<double> values;
  std::array<double, UMFPACK_CONTROL> control{};
  std::array<double, UMFPACK_INFO> info{};
  void* symbolic = nullptr;
  void* numeric = nullptr;

  Umfpack(const SparseMatrix& matrix, const Eigen::VectorXd& scale)
      : begin(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1),
        rows(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros()) {
    values.reserve(rows.size());
    for (Index column = 0; column < matrix.cols(); ++column)
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
        values.push_back(scale[entry.row()] * entry.value() * scale[column]);
    umfpack_dl_defaults(control.data());
    control[UMFPACK_PRL] = 0;
    control[UMFPACK_IRSTEP] = 0;  // refinement is ours
  }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;
  ~Umfpack() {
    umfpack_dl_free_symbolic(&symbolic);
    umfpack_dl_free_numeric(&numeric);
  }
  Long size() const { return static_cast<Long>(begin.size()) - 1; }
};

void require_status(Long status, Long unknowns) {
  if (status == UMFPACK_OK) return;
  if (status == UMFPACK_ERROR_out_of_memory)
    throw BudgetError("there is not enough memory for the linear system of " +
                      std::to_string(unknowns) + " unknowns");
  throw MeshingError("UMFPACK refuses the linear system of " + std::to_string(unknowns) +
                     " unknowns with status " + std::to_string(status));
}

void analyse(Umfpack& u, const MemoryLimit& limit) {
  require_status(umfpack_dl_symbolic(u.size(), u.size(), u.begin.data(), u.rows.data(),
                                     u.values.data(), &u.symbolic, u.control.data(), u.info.data()),
                 u.size());
  require_memory(u.info[UMFPACK_PEAK_MEMORY_ESTIMATE] * u.info[UMFPACK_SIZE_OF_UNIT], u.size(),
                 limit);
}

/// The unknown whose pivot is smallest.
[[noreturn]] void refuse_singular(const Umfpack& u) {
  std::vector<double> pivots(u.size());
  std::vector<Long> order(u.size());
  Long reciprocal = 0;
  umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                         order.data(), pivots.data(), &reciprocal, nullptr, u.numeric);
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto weakest = std::min_element(pivots.begin(), pivots.end(), smaller) - pivots.begin();
  refuse_singular_pivot(pivots[weakest], order[weakest]);
}

void factorise(Umfpack& u) {
  const SingleThread guard;
  const Long status = umfpack_dl_numeric(u.begin.data(), u.rows.data(), u.values.data(), u.symbolic,
                                         &u.numeric, u.control.data(), u.info.data());
  const bool is_singular = status == UMFPACK_WARNING_singular_matrix;
  if (is_singular || (status == UMFPACK_OK && !(u.info[UMFPACK_RCOND] > kPivotTolerance)))
    refuse_singular(u);
  require_status(status, u.size());
}

void solve(Umfpack& u, Eigen::VectorXd& r) {
  const SingleThread guard;
  Eigen::VectorXd x(r.size());
  require_status(umfpack_dl_solve(UMFPACK_A, u.begin.data(), u.rows.data(), u.values.data(),
                                  x.data(), r.data(), u.numeric, u.control.data(), u.info.data()),
                 u.size());
  r.swap(x);
}

}  // namespace

Factors general_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                        const MemoryLimit& limit) {
  const auto u = std::make_shared<Umfpack>(matrix, scale);
  analyse(*u, limit);
  factorise(*u);
  return {"sparse LU (UMFPACK)", u->info[UMFPACK_LNZ] + u->info[UMFPACK_UNZ],
          [u](Eigen::VectorXd& r, double) { solve(*u, r); }};
}

}  // namespace anisofront
