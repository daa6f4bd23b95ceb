#include <cstring>
#include <memory>

#include <cholmod.h>

#include "mesher/geometry/error.hpp"
#include "solver/system/factors.hpp"
#include "solver/system/single_thread.hpp"
#include "solver/system/symbolic.hpp"

namespace anisofront {
namespace {

/// METIS is tried when the factor by AMD has more operations per nonzero (CHOLMOD's own rule).
constexpr double kManyOperations = 500;

/// CHOLMOD's settings, factor and the workspaces of its solves.
struct Cholmod {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;

  Cholmod() {
    cholmod_l_start(&common);
    common.print = 0;
    common.try_catch = true;  // no message for a matrix that is not positive definite
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() {
    for (cholmod_dense** dense : {&solution, &work_y, &work_e})
      cholmod_l_free_dense(dense, &common);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_finish(&common);
  }
};

using Indices = std::vector<std::int64_t>;

SuiteSparse_long* long_indices(std::int64_t* indices) {
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  return reinterpret_cast<SuiteSparse_long*>(indices);
}

/// A view of arrays that CHOLMOD reads only.
cholmod_sparse symmetric_view(Indices& begin, Indices& rows, double* values, int stored) {
  cholmod_sparse view{};
  view.nrow = view.ncol = begin.size() - 1;
  view.nzmax = rows.size();
  view.p = begin.data();
  view.i = rows.data();
  view.x = values;
  view.stype = stored;
  view.itype = CHOLMOD_LONG;
  view.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

/// The lower triangle of S A S in CHOLMOD's integers.
struct LowerTriangle {
  Indices begin{0}, rows;
  std::vector<double> values;

  LowerTriangle(const SparseMatrix& matrix, const Eigen::VectorXd& scale) {
    const auto size = static_cast<std::size_t>((matrix.nonZeros() + matrix.cols()) / 2);
    begin.reserve(matrix.cols() + 1);
    rows.reserve(size);
    values.reserve(size);
    for (Index column = 0; column < matrix.cols(); ++column) {
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
        if (entry.row() < column) continue;
        rows.push_back(entry.row());
        values.push_back(scale[entry.row()] * entry.value() * scale[column]);
      }
      begin.push_back(static_cast<std::int64_t>(rows.size()));
    }
  }
  cholmod_sparse view() { return symmetric_view(begin, rows, values.data(), -1); }
};

/// The graph of runs as CHOLMOD's orderings take it: its lower triangle.
cholmod_sparse upper_part(const CompressedPattern& pattern, Indices& begin, Indices& rows) {
  begin = {0};
  for (std::size_t r = 0; r < pattern.runs(); ++r) {
    for (std::int64_t k = pattern.begin[r]; k < pattern.begin[r + 1]; ++k)
      if (pattern.neighbours[k] <= static_cast<std::int64_t>(r))
        rows.push_back(pattern.neighbours[k]);
    begin.push_back(static_cast<std::int64_t>(rows.size()));
  }
  return symmetric_view(begin, rows, nullptr, 1);
}

enum class Ordering { amd, metis };

Indices ordering_of(const CompressedPattern& pattern, Ordering ordering, cholmod_common& common) {
  Indices begin, rows;
  cholmod_sparse graph = upper_part(pattern, begin, rows);
  Indices order(pattern.runs());
  if (ordering == Ordering::amd)
    cholmod_l_amd(&graph, nullptr, 0, long_indices(order.data()), &common);
  else
    cholmod_l_metis(&graph, nullptr, 0, false, long_indices(order.data()), &common);
  return unknown_order(pattern, order);
}

void require_room(const cholmod_common& common, double unknowns) {
  if (common.status != CHOLMOD_OUT_OF_MEMORY && common.status != CHOLMOD_TOO_LARGE) return;
  throw BudgetError("there is not enough memory for the linear system of " +
                    std::to_string(static_cast<long long>(unknowns)) + " unknowns");
}

/// Symbolic factor in the given order; operations to come are left in common.fl.
cholmod_factor* analyse(cholmod_sparse& view, Indices order, cholmod_common& common) {
  cholmod_factor* factor =
      cholmod_l_analyze_p(&view, long_indices(order.data()), nullptr, 0, &common);
  require_room(common, static_cast<double>(view.nrow));
  return factor;
}

/// AMD, or METIS where AMD leaves much to do and METIS less.
void choose_factor(const SparseMatrix& matrix, cholmod_sparse& view, Cholmod& cholmod) {
  cholmod_common& common = cholmod.common;
  const CompressedPattern pattern = compressed_pattern(matrix);
  cholmod.factor = analyse(view, ordering_of(pattern, Ordering::amd, common), common);
  const double operations = common.fl, nonzeros = common.lnz;
  if (operations < kManyOperations * nonzeros) return;
  cholmod_factor* other = analyse(view, ordering_of(pattern, Ordering::metis, common), common);
  if (common.fl < operations)
    std::swap(cholmod.factor, other);
  else
    common.lnz = nonzeros;
  cholmod_l_free_factor(&other, &common);
}

/// Of the factor with its largest update, and of the copies of the matrix.
double estimated_bytes(const cholmod_factor& factor, const cholmod_sparse& view) {
  return 8. * static_cast<double>(factor.xsize + factor.ssize + factor.maxcsize + 6 * factor.n) +
         2 * 16. * static_cast<double>(view.nzmax);
}

std::int64_t unknown_at(const cholmod_factor& factor, std::size_t column) {
  return static_cast<const std::int64_t*>(factor.Perm)[column];
}

/// Refuses a matrix whose smallest pivot is rounding.
void require_pivots(const cholmod_factor& factor) {
  const auto* super = static_cast<const std::int64_t*>(factor.super);
  const auto* first_row = static_cast<const std::int64_t*>(factor.pi);
  const auto* first_value = static_cast<const std::int64_t*>(factor.px);
  const auto* values = static_cast<const double*>(factor.x);
  double least = HUGE_VAL, largest = 0;
  std::int64_t weakest = 0;
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const std::int64_t height = first_row[s + 1] - first_row[s];
    for (std::int64_t k = 0; k < super[s + 1] - super[s]; ++k) {
      const double diagonal = values[first_value[s] + k * (height + 1)];
      largest = std::max(largest, diagonal * diagonal);
      if (diagonal * diagonal >= least) continue;
      least = diagonal * diagonal;
      weakest = super[s] + k;
    }
  }
  if (!(least > kPivotTolerance * largest)) refuse_pivot(least, unknown_at(factor, weakest));
}

void factorise(cholmod_sparse& view, Cholmod& cholmod) {
  const SingleThread guard;
  cholmod_l_factorize(&view, cholmod.factor, &cholmod.common);
  require_room(cholmod.common, static_cast<double>(view.nrow));
  if (cholmod.factor->minor < cholmod.factor->n)
    refuse_pivot(0, unknown_at(*cholmod.factor, cholmod.factor->minor));
  require_pivots(*cholmod.factor);
}

void solve(Cholmod& cholmod, Eigen::VectorXd& r) {
  const SingleThread guard;
  cholmod_dense b{};
  b.nrow = b.nzmax = b.d = cholmod.factor->n;
  b.ncol = 1;
  b.x = r.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_l_solve2(CHOLMOD_A, cholmod.factor, &b, nullptr, &cholmod.solution, nullptr,
                   &cholmod.work_y, &cholmod.work_e, &cholmod.common);
  require_room(cholmod.common, static_cast<double>(r.size()));
  std::memcpy(r.data(), cholmod.solution->x, sizeof(double) * static_cast<std::size_t>(r.size()));
}

}  // namespace

Factors supernodal_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                           const MemoryLimit& limit) {
  LowerTriangle lower(matrix, scale);
  cholmod_sparse view = lower.view();
  const auto cholmod = std::make_shared<Cholmod>();
  choose_factor(matrix, view, *cholmod);
  require_memory(estimated_bytes(*cholmod->factor, view), matrix.cols(), limit);
  factorise(view, *cholmod);
  return {"supernodal Cholesky (CHOLMOD)", cholmod->common.lnz,
          [cholmod](Eigen::VectorXd& r, double) { solve(*cholmod, r); }};
}

}  // namespace anisofront
