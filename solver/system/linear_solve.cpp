#include "solver/system/linear_solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/system/extended_residual.hpp"
#include "solver/system/factors.hpp"
#include "solver/system/multigrid.hpp"
#include "solver/system/scaling.hpp"

namespace anisofront {
namespace {

/// Systems with fewer unknowns are solved faster without supernodes. All these were measured with
/// P1, P2 and MITC7.
constexpr Index kSupernodalFrom = 8'000;
/// Scalar systems from here on go to multigrid, which is given up for the direct method when it
/// needs more than so many steps for seven digits: that would take longer.
constexpr Index kMultigridFrom = 50'000;
constexpr int kFastSteps = 60;
/// Where the direct method is no choice.
constexpr int kMaxSteps = 500;
/// Refinement stops at this relative residual: digits below are of no use to anyone.
constexpr double kResidualGoal = 1e-12;
/// ... and at this relative error of the solution.
constexpr double kErrorGoal = 1e-11;
/// A correction by an iterative method brings the residual down by kReduction, the last ones no
/// further than to the share kFinalResidual of the right-hand side: what a guess has gained already
/// need not be gained again.
constexpr double kReduction = 1e-7;
constexpr double kFinalResidual = 1e-14;
/// Above this residual, the user is warned.
constexpr double kBadResidual = 1e-8;
/// A step must bring the residual down by this factor.
constexpr double kLeastProgress = 0.5;

class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void require_finite(const Eigen::VectorXd& values, const char* what, const char* advice) {
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw MeshingError(std::string(what) + " is not finite at unknown " + std::to_string(i) +
                         " (counted from 0)" + advice);
}

void require_guess(const Eigen::VectorXd& guess, Eigen::Index unknowns) {
  if (guess.size() != unknowns)
    throw InputError("the initial guess has " + std::to_string(guess.size()) +
                     " values, expected one for each of the " + std::to_string(unknowns) +
                     " unknowns");
  if (!guess.allFinite()) throw InputError("the initial guess has values that are not finite");
}

/// A x = b with all that the methods need.
struct Task {
  const SparseMatrix& matrix;
  const SparseMatrix& rows;  ///< the transpose
  const Eigen::VectorXd& rhs;
  const LinearOptions& options;
  const Eigen::VectorXd* guess;  ///< null: none
  Eigen::VectorXd scale;
  double rhs_norm = 0;  ///< of S b
};

/// The solution so far with its residual.
struct Iterate {
  ExtendedVector x;
  Eigen::VectorXd residual;  ///< S (b - A x)
  double relative = 1;       ///< |S (b - A x)| / |S b|
  double step = 1;           ///< last correction by the solution, both times S^-1
};

void measure_residual(const Task& task, Iterate& at) {
  at.residual = task.scale.cwiseProduct(extended_residual(task.rows, task.rhs, at.x));
  at.relative = task.rhs_norm > 0 ? at.residual.norm() / task.rhs_norm : 0;
}

/// Zero or, for iterative methods, the guess (if there is a load: zero is the solution otherwise).
Iterate start_of(const Task& task, bool is_direct) {
  Iterate start{ExtendedVector(task.rhs.size()), task.scale.cwiseProduct(task.rhs)};
  if (!task.guess || is_direct || task.rhs_norm == 0) return start;
  start.x.high = *task.guess;
  measure_residual(task, start);
  return start;
}

/// Below the goal of residuals it is the error that is to fall: the smoothest errors have the
/// smallest residuals.
double reduction_from(double relative) {
  return relative > kResidualGoal ? std::max(kReduction, kFinalResidual / relative) : kReduction;
}

Iterate corrected(const Task& task, const Factors& factors, const Iterate& from) {
  Iterate next = from;
  factors.solve(next.residual, reduction_from(from.relative));
  const double step = next.residual.norm();
  next.x.add(task.scale.cwiseProduct(next.residual));
  measure_residual(task, next);
  next.step = step > 0 ? step / next.x.high.cwiseQuotient(task.scale).norm() : 0;
  return next;
}

/// Iterative refinement; x is kept in twice the working precision, as a solution rounded to the
/// working one has a residual of machine precision times the condition. A small residual is not
/// enough: `error` is the relative error to expect, at first from the condition, then from the
/// corrections, which shrink by the size of the first.
Iterate refined(const Task& task, const Factors& factors, Iterate best, LinearReport& report) {
  double error = report.condition * std::numeric_limits<double>::epsilon(), first_step = 0;
  while ((best.relative > kResidualGoal || error > kErrorGoal) &&
         report.refinements < task.options.max_refinements) {
    Iterate next = corrected(task, factors, best);
    if (first_step == 0) first_step = next.step;
    error = next.step * first_step;
    const bool goes_on = next.relative < kLeastProgress * best.relative;
    if (next.relative < best.relative) {
      best = std::move(next);
      ++report.refinements;
    }
    if (!goes_on) break;
  }
  return best;
}

/// Norm of S A S times the growth in one inverse iteration from the solution, in which the lowest
/// modes prevail: a lower bound of the condition, close for smooth loads (0: no load).
double condition_estimate(const Task& task, const Factors& factors, const Eigen::VectorXd& x) {
  Eigen::VectorXd mode = x.cwiseQuotient(task.scale);
  const double before = mode.norm();
  if (before == 0) return 0;
  factors.solve(mode, 0);
  return scaled_norm(task.matrix, task.scale) * mode.norm() / before;
}

Factors direct_factors(const Task& task, LinearMethod method) {
  const MemoryLimit limit = memory_limit(task.options.memory_limit);
  switch (method) {
    case LinearMethod::general:
      return general_factors(task.matrix, task.scale, limit);
    case LinearMethod::supernodal:
      return supernodal_factors(task.matrix, task.scale, limit);
    default:
      return simplicial_factors(task.matrix, task.scale, limit);
  }
}

LinearResult solve_with(const Task& task, LinearMethod method, int max_steps = kMaxSteps) {
  LinearResult result;
  LinearReport& report = result.report;
  report.unknowns = static_cast<Index>(task.matrix.cols());
  report.nonzeros = static_cast<double>(task.matrix.nonZeros());
  Clock clock;
  const bool is_direct = method != LinearMethod::multigrid;
  const Factors factors =
      is_direct ? direct_factors(task, method)
                : multigrid_solver(task.matrix, task.scale, max_steps, report.iterations);
  report.factor_seconds = clock.lap();
  report.method = factors.method;
  if (is_direct) report.factor_nonzeros = factors.nonzeros;
  Iterate solution = corrected(task, factors, start_of(task, is_direct));
  if (is_direct) report.condition = condition_estimate(task, factors, solution.x.high);
  solution = refined(task, factors, std::move(solution), report);
  result.solution = solution.x.high;
  report.residual = solution.relative;
  require_finite(result.solution, "the solution of the linear system",
                 " although the matrix could be factorised; check coefficients and loads");
  report.solve_seconds = clock.lap();
  return result;
}

/// Multigrid where it wins, and as the way out where factors would not fit into the memory.
LinearResult solve_scalar_system(const Task& task) {
  const bool is_large = task.rhs.size() >= kMultigridFrom;
  if (is_large) {
    try {
      return solve_with(task, LinearMethod::multigrid, kFastSteps);
    } catch (const MeshingError&) {  // the direct method decides
    }
  }
  try {
    return solve_with(task, is_large ? LinearMethod::supernodal : LinearMethod::simplicial);
  } catch (const BudgetError&) {
    return solve_with(task, LinearMethod::multigrid);
  }
}

LinearResult solve_task(const Task& task) {
  if (!task.options.symmetric) return solve_with(task, LinearMethod::general);
  if (task.options.method != LinearMethod::automatic) return solve_with(task, task.options.method);
  if (task.options.scalar) return solve_scalar_system(task);
  const bool is_large = task.rhs.size() >= kSupernodalFrom;
  return solve_with(task, is_large ? LinearMethod::supernodal : LinearMethod::simplicial);
}

}  // namespace

LinearResult solve_linear(const LinearSystem& system, const LinearOptions& options,
                          const Monitor& monitor, const Eigen::VectorXd* guess) {
  require_finite(system.rhs, "the right-hand side of the linear system",
                 "; check loads, sources and boundary values");
  if (guess) require_guess(*guess, system.rhs.size());
  monitor.report("linear system", 0);
  const SparseMatrix transpose = options.symmetric ? SparseMatrix() : system.matrix.transpose();
  Task task{system.matrix, options.symmetric ? system.matrix : transpose,
            system.rhs,    options,
            guess,         symmetric_scaling(system.matrix)};
  task.rhs_norm = task.scale.cwiseProduct(system.rhs).norm();
  LinearResult result = solve_task(task);
  if (result.report.residual > kBadResidual)
    monitor.warning("the linear system is so ill-conditioned that its solution has a residual of " +
                    describe(result.report.residual) + " after refinement (wanted: 1e-8 or less)");
  monitor.report("linear system", 1);
  return result;
}

}  // namespace anisofront
