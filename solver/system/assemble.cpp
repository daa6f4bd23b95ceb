#include "solver/system/assemble.hpp"

#include <algorithm>
#include <exception>
#include <mutex>

#include <omp.h>

#include "solver/system/condense.hpp"
#include "solver/system/node_graph.hpp"

namespace anisofront {
namespace {

/// Elements whose matrices are held at a time: enough to keep the threads busy, few enough to stay
/// in the cache.
constexpr Index kBatch = 512;
/// Threads own blocks of so many nodes in turn when they add element matrices.
constexpr int kOwnedBits = 6;

int threads_for(int wanted) { return wanted > 0 ? wanted : omp_get_max_threads(); }

/// Exceptions must not leave a parallel loop: the one of the smallest element is kept.
class FirstError {
 public:
  template <class Function>
  void guard(Index element, const Function& function) {
    try {
      function();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (element_ != kNoIndex && element_ < element) return;
      element_ = element;
      error_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  Index element_ = kNoIndex;
  std::exception_ptr error_;
};

/// The condensed matrix of one element, with the place of its unknowns.
struct Contribution {
  ElementSystem system;
  ElementNodes nodes;
  ElementDofs dofs;
};

/// Adds the blocks of a contribution to the columns of the global matrix.
class Scatter {
 public:
  Scatter(const NodeGraph& graph, const DofMap& dofs, LinearSystem& system)
      : graph_(graph),
        dofs_(dofs),
        outer_(system.matrix.outerIndexPtr()),
        values_(system.matrix.valuePtr()),
        rhs_(system.rhs.data()) {}

  /// Only the columns of the nodes that `thread` of `threads` owns.
  void add(const Contribution& c, int thread, int threads) const {
    int column = 0;
    for (int b = 0; b < c.nodes.count; ++b) {
      const Index node = c.nodes.numbers[b];
      const int width = unknowns(node);
      if ((node >> kOwnedBits) % threads == thread) add_columns(c, node, column, width);
      column += width;
    }
  }

 private:
  int unknowns(Index node) const {
    return node < dofs_.vertices ? dofs_.layout.per_vertex : dofs_.layout.per_edge;
  }

  /// Row of the first unknown of `neighbour` within the columns of `node`.
  Index row_in_columns(Index node, Index neighbour) const {
    const auto begin = graph_.neighbours.begin() + graph_.first[node];
    const auto end = graph_.neighbours.begin() + graph_.first[node + 1];
    const auto position = static_cast<Index>(std::lower_bound(begin, end, neighbour) - begin);
    const Index vertices = std::min(position, graph_.vertex_count[node]);
    return vertices * dofs_.layout.per_vertex + (position - vertices) * dofs_.layout.per_edge;
  }

  void add_columns(const Contribution& c, Index node, int column, int width) const {
    int row = 0;
    for (int a = 0; a < c.nodes.count; ++a) {
      const int height = unknowns(c.nodes.numbers[a]);
      const Index place = row_in_columns(node, c.nodes.numbers[a]);
      for (int j = column; j < column + width; ++j) {
        double* target = values_ + outer_[c.dofs.numbers[j]] + place;
        const double* source = &c.system.matrix(row, j);
        for (int i = 0; i < height; ++i) target[i] += source[i];
      }
      row += height;
    }
    for (int j = column; j < column + width; ++j) rhs_[c.dofs.numbers[j]] += c.system.rhs[j];
  }

  const NodeGraph& graph_;
  const DofMap& dofs_;
  const Index* outer_;
  double* values_;
  double* rhs_;
};

void contribute(const FeMesh& mesh, const DofMap& dofs, const ElementKernel& kernel, Index e,
                Contribution& result) {
  const Element element = element_at(mesh, e);
  kernel(element, result.system);
  condense(element, dofs.outer(element.shape), result.system);
  result.nodes = element_nodes(dofs, element);
  result.dofs = element_dofs(dofs, element);
}

}  // namespace

LinearSystem assemble(const FeMesh& mesh, const DofMap& dofs, const ElementKernel& kernel,
                      int threads) {
  const int team = threads_for(threads);
  const NodeGraph graph = node_graph(mesh, dofs, team);
  LinearSystem system{zero_matrix(graph, dofs), Eigen::VectorXd::Zero(dofs.count())};
  const Scatter scatter(graph, dofs, system);
  const Index batch = kBatch * team;
  std::vector<Contribution> contributions(batch);
  FirstError error;
#pragma omp parallel num_threads(team)
  for (Index begin = 0; begin < mesh.element_count(); begin += batch) {
    const Index end = std::min(begin + batch, mesh.element_count());
#pragma omp for schedule(static)
    for (Index e = begin; e < end; ++e)
      error.guard(e, [&] { contribute(mesh, dofs, kernel, e, contributions[e - begin]); });
    for (Index e = begin; e < end; ++e)
      scatter.add(contributions[e - begin], omp_get_thread_num(), omp_get_num_threads());
#pragma omp barrier
  }
  error.rethrow();
  return system;
}

std::vector<double> inner_values(const FeMesh& mesh, const DofMap& dofs,
                                 const ElementKernel& kernel, const Eigen::VectorXd& solution,
                                 int threads) {
  const auto triangles = static_cast<Index>(mesh.mesh.triangles.size());
  const auto first_inner = [&](Index e) {
    return std::min(e, triangles) * dofs.layout.in_triangle +
           std::max(e - triangles, 0) * dofs.layout.in_quad;
  };
  std::vector<double> inner(first_inner(mesh.element_count()));
  if (inner.empty()) return inner;
  FirstError error;
#pragma omp parallel for schedule(static) num_threads(threads_for(threads))
  for (Index e = 0; e < mesh.element_count(); ++e)
    error.guard(e, [&] {
      Contribution c;
      contribute(mesh, dofs, kernel, e, c);
      LocalValues values(c.system.rhs.size());
      for (int k = 0; k < c.dofs.count; ++k) values[k] = solution[c.dofs.numbers[k]];
      expand(c.dofs.count, c.system, values);
      std::copy(values.begin() + c.dofs.count, values.end(), inner.begin() + first_inner(e));
    });
  error.rethrow();
  return inner;
}

LocalValues local_values(const FeMesh& mesh, const DofMap& dofs, const Element& element,
                         const std::vector<double>& values, const std::vector<double>& inner) {
  const ElementDofs outer = element_dofs(dofs, element);
  const int inside = dofs.inner(element.shape);
  LocalValues local(outer.count + inside);
  for (int k = 0; k < outer.count; ++k) local[k] = values[outer.numbers[k]];
  const auto triangles = static_cast<Index>(mesh.mesh.triangles.size());
  const Index first = std::min(element.number, triangles) * dofs.layout.in_triangle +
                      std::max(element.number - triangles, 0) * dofs.layout.in_quad;
  for (int k = 0; k < inside; ++k) local[outer.count + k] = inner[first + k];
  return local;
}

void add_entry(LinearSystem& system, Index row, Index column, double value) {
  system.matrix.coeffRef(row, column) += value;
}

}  // namespace anisofront
