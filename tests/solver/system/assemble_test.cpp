#include "solver/system/assemble.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr DofLayout kPlateLike{3, 3, 2, 2};

/// Numbers that differ between elements and entries; the inner block is regular.
void patterned(const Element& element, ElementSystem& system, int unknowns) {
  system.set_zero(unknowns);
  for (int j = 0; j < unknowns; ++j) {
    for (int i = 0; i < unknowns; ++i)
      system.matrix(i, j) = 0.01 * ((element.number * 7 + i * 3 + j * 5) % 11) + (i == j ? 10 : 0);
    system.rhs[j] = element.number + 0.1 * j;
  }
}

ElementKernel patterned_kernel(const DofMap& dofs) {
  return [dofs](const Element& e, ElementSystem& s) {
    patterned(e, s, dofs.outer(e.shape) + dofs.inner(e.shape));
  };
}

/// The sum of all element matrices with the inner unknowns as unknowns of their own.
void add_dense(const FeMesh& fe, const DofMap& dofs, Eigen::MatrixXd& a, Eigen::VectorXd& b) {
  const Index inner = 2;
  a.setZero(dofs.count() + inner * fe.element_count(), dofs.count() + inner * fe.element_count());
  b.setZero(a.rows());
  for (Index e = 0; e < fe.element_count(); ++e) {
    const Element element = element_at(fe, e);
    ElementSystem s;
    patterned_kernel(dofs)(element, s);
    ElementDofs numbers = element_dofs(dofs, element);
    for (Index k = 0; k < inner; ++k)
      numbers.numbers[numbers.count + k] = dofs.count() + inner * e + k;
    for (Index i = 0; i < numbers.count + inner; ++i) {
      b[numbers.numbers[i]] += s.rhs[i];
      for (Index j = 0; j < numbers.count + inner; ++j)
        a(numbers.numbers[i], numbers.numbers[j]) += s.matrix(i, j);
    }
  }
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("assembly agrees with the dense sum of all elements on a mixed mesh") {
    const Mesh mesh = mixed_square(3, 3);
    const FeMesh fe = straight_fe_mesh(mesh);
    const DofMap dofs = make_dof_map(fe, kPlateLike);
    Eigen::MatrixXd a;
    Eigen::VectorXd b;
    add_dense(fe, dofs, a, b);
    const Eigen::VectorXd x = a.lu().solve(b);
    const LinearSystem system = assemble(fe, dofs, patterned_kernel(dofs));
    const Eigen::VectorXd outer = Eigen::MatrixXd(system.matrix).lu().solve(system.rhs);
    CHECK((outer - x.head(dofs.count())).norm() < 1e-10 * x.norm());
    const auto inner = inner_values(fe, dofs, patterned_kernel(dofs), outer);
    REQUIRE(static_cast<Index>(inner.size()) == 2 * fe.element_count());
    for (std::size_t k = 0; k < inner.size(); ++k)
      CHECK(inner[k] == doctest::Approx(x[dofs.count() + static_cast<Index>(k)]).epsilon(1e-9));
  }

  TEST_CASE("the matrix has full blocks between nodes of one element and no others") {
    const Mesh mesh = square_mesh(5);
    const FeMesh fe = straight_fe_mesh(mesh);
    const DofMap dofs = make_dof_map(fe, {1, 0, 0, 0});
    const LinearSystem s = assemble(fe, dofs, patterned_kernel(dofs));
    CHECK(s.matrix.nonZeros() == 36 + 2 * (3 * 25 + 10));  // one per vertex and two per edge
    CHECK(s.matrix.isCompressed());
    for (Index c = 0; c < s.matrix.outerSize(); ++c)
      for (SparseMatrix::InnerIterator a(s.matrix, c), b = a; ++b; a = b) CHECK(a.row() < b.row());
  }

  TEST_CASE("the sum has the same bits for any number of threads") {
    const Mesh mesh = mixed_square(40, 40);
    const FeMesh fe = straight_fe_mesh(mesh);
    const DofMap dofs = make_dof_map(fe, kPlateLike);
    const LinearSystem one = assemble(fe, dofs, patterned_kernel(dofs), 1);
    for (const int threads : {2, 3, 7}) {
      const LinearSystem many = assemble(fe, dofs, patterned_kernel(dofs), threads);
      CHECK(std::equal(one.matrix.valuePtr(), one.matrix.valuePtr() + one.matrix.nonZeros(),
                       many.matrix.valuePtr()));
      CHECK(one.rhs == many.rhs);
    }
  }

  TEST_CASE("of several elements that fail the first is reported") {
    const Mesh mesh = square_mesh(20);
    const FeMesh fe = straight_fe_mesh(mesh);
    const DofMap dofs = make_dof_map(fe, {1, 0, 0, 0});
    const ElementKernel failing = [](const Element& e, ElementSystem& s) {
      s.set_zero(3);
      if (e.number % 100 == 37) throw InputError("element " + std::to_string(e.number));
    };
    CHECK_THROWS_WITH_AS(assemble(fe, dofs, failing, 2), "element 37", InputError);
  }

  TEST_CASE("local values come in the order of the element's unknowns") {
    const Mesh mesh = mixed_square(2, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const DofMap dofs = make_dof_map(fe, {1, 1, 0, 1});
    std::vector<double> values(dofs.count()), inner{100, 101};
    for (Index i = 0; i < dofs.count(); ++i) values[i] = i;
    const Element quad = element_at(fe, fe.element_count() - 1);
    const LocalValues local = local_values(fe, dofs, quad, values, inner);
    REQUIRE(local.size() == 9);
    for (int k = 0; k < 4; ++k) {
      CHECK(local[k] == quad.vertices[k]);
      CHECK(local[4 + k] == dofs.vertices + quad.edges[k]);
    }
    CHECK(local[8] == 101);
  }
}
