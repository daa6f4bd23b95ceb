#include "solver/system/multigrid.hpp"

#include <cmath>

#include <Eigen/SparseCholesky>

#include "mesher/geometry/error.hpp"
#include "solver/system/aggregation.hpp"
#include "solver/system/gauss_seidel.hpp"

namespace anisofront {
namespace {

/// Levels of at most so many unknowns are solved directly.
constexpr Index kCoarsest = 2000;
/// A level that keeps more than this share of the unknowns is not worth having.
constexpr double kLeastCoarsening = 0.8;
/// Of couplings, see filtered_matrix().
constexpr double kStrength = 0.4;

struct Level {
  explicit Level(SparseRows rows) : matrix(std::move(rows)), smoother(matrix) {}

  SparseRows matrix, prolongation, restriction;
  GaussSeidel smoother;
  Eigen::VectorXd b, x, residual;
};

}  // namespace

struct Multigrid::Hierarchy {
  std::vector<std::unique_ptr<Level>> levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> coarsest;

  void add_levels();
  void cycle(std::size_t at, const Eigen::VectorXd& b, Eigen::VectorXd& x);
};

void Multigrid::Hierarchy::add_levels() {
  while (levels.back()->matrix.rows() > kCoarsest) {
    Level& fine = *levels.back();
    const SparseRows filtered = filtered_matrix(fine.matrix, kStrength);
    const Aggregates aggregates = aggregate(filtered);
    const auto unknowns = static_cast<double>(fine.matrix.rows());
    if (aggregates.count == 0 || aggregates.count > kLeastCoarsening * unknowns) break;
    fine.prolongation = smoothed_prolongation(filtered, aggregates);
    fine.restriction = fine.prolongation.transpose();
    levels.push_back(std::make_unique<Level>(
        product(fine.restriction, product(fine.matrix, fine.prolongation))));
  }
  coarsest.compute(levels.back()->matrix);
  if (coarsest.info() != Eigen::Success)
    throw MeshingError("the matrix is not positive definite (coarsest level of multigrid)");
}

void Multigrid::Hierarchy::cycle(std::size_t at, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  Level& level = *levels[at];
  if (at + 1 == levels.size()) {
    x = coarsest.solve(b);
    return;
  }
  Level& coarse = *levels[at + 1];
  level.smoother.forward_from_zero(b, x);
  subtract_product(level.matrix, x, b, level.residual);
  multiply(level.restriction, level.residual, coarse.b);
  cycle(at + 1, coarse.b, coarse.x);
  add_product(level.prolongation, coarse.x, x);
  level.residual = x;
  level.smoother.backward(b, x, level.residual);
}

Multigrid::Multigrid(const SparseMatrix& matrix) : hierarchy_(std::make_unique<Hierarchy>()) {
  hierarchy_->levels.push_back(std::make_unique<Level>(SparseRows(matrix)));
  hierarchy_->add_levels();
}

Multigrid::~Multigrid() = default;

void Multigrid::cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  hierarchy_->cycle(0, b, x);
}

const SparseRows& Multigrid::finest() const { return hierarchy_->levels.front()->matrix; }

int Multigrid::levels() const { return static_cast<int>(hierarchy_->levels.size()); }

double Multigrid::nonzeros() const {
  Eigen::Index sum = 0;
  for (const auto& level : hierarchy_->levels)
    sum += level->matrix.nonZeros() + 2 * level->prolongation.nonZeros();
  return static_cast<double>(sum);
}

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw MeshingError("conjugate gradients with multigrid: " + what +
                     "; use a direct method (supernodal)");
}

/// Overwrites b by A^-1 b up to a residual of `reduction` times |b|; returns the number of steps.
int conjugate_gradients(const SparseRows& matrix, const Multigrid& multigrid, int max_steps,
                        double reduction, Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), z, p, image;
  Eigen::VectorXd& r = b;
  const double goal = reduction * reduction * inner_product(r, r);
  if (goal == 0) return 0;
  double rho = 0;
  for (int step = 1; step <= max_steps; ++step) {
    multigrid.cycle(r, z);
    const double next = inner_product(r, z);
    if (step == 1)
      p = z;
    else
      p = z + (next / rho) * p;
    rho = next;
    multiply(matrix, p, image);
    const double curvature = inner_product(p, image);
    if (!(rho > 0 && curvature > 0)) refuse("the matrix is not positive definite");
    x += (rho / curvature) * p;
    r -= (rho / curvature) * image;
    if (inner_product(r, r) <= goal) {
      b.swap(x);
      return step;
    }
  }
  refuse("no convergence in " + std::to_string(max_steps) + " steps");
}

}  // namespace

Factors multigrid_solver(const SparseMatrix& matrix, const Eigen::VectorXd& scale, int max_steps,
                         int& steps) {
  const auto multigrid = std::make_shared<Multigrid>(matrix);
  return {"conjugate gradients with smoothed aggregation multigrid", multigrid->nonzeros(),
          [multigrid, &scale, max_steps, &steps](Eigen::VectorXd& r, double reduction) {
            r = r.cwiseQuotient(scale).eval();
            steps += conjugate_gradients(multigrid->finest(), *multigrid, max_steps, reduction, r);
            r = r.cwiseQuotient(scale).eval();
          }};
}

}  // namespace anisofront
