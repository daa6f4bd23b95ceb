#include <limits>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/plate/mitc7.hpp"
#include "solver/plate/tied_element.hpp"
#include "tests/solver/plate/sample_elements.hpp"
#include "tests/solver/plate/six_point_mitc9.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

std::vector<Candidate> all_candidates() {
  auto all = straight_candidates();
  const auto bent = bent_candidates();
  all.insert(all.end(), bent.begin(), bent.end());
  return all;
}

int zero_eigenvalues(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
  return static_cast<int>((values.array().abs() < 1e-12 * values.maxCoeff()).count());
}

PlateProblem unit_load() {
  PlateProblem problem;
  problem.load = 1.;
  return problem;
}

double sum_of_deflection_loads(const ElementSystem& system) {
  double sum = 0;
  for (int i = 0; i < 3 * 8 && i < system.rhs.size() - 2; i += 3) sum += system.rhs[i];
  return sum;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("layouts match the local matrices") {
    for (const Candidate& c : straight_candidates()) {
      CAPTURE(c.name);
      const DofMap dofs{plate_layout(c.kind), 0, 0};
      const auto system = system_of(c.kind, c.element, unit_load());
      const int expected = dofs.outer(c.element.shape) + dofs.inner(c.element.shape);
      CHECK(system.matrix.rows() == expected);
      CHECK(system.matrix.cols() == expected);
      CHECK(system.rhs.size() == expected);
    }
    CHECK(vertex_components(PlateElement::mitc).w == 0);
    CHECK(edge_components(PlateElement::mitc).rotation == 1);
    CHECK(edge_components(PlateElement::mitc4).w == -1);
    CHECK(edge_components(PlateElement::mitc4).rotation == -1);
    CHECK(vertex_components(PlateElement::arnold_falk).w == -1);
    CHECK(vertex_components(PlateElement::arnold_falk).rotation == 0);
    CHECK(edge_components(PlateElement::arnold_falk).w == 0);
    CHECK(edge_components(PlateElement::arnold_falk).rotation == -1);
  }

  TEST_CASE("the stiffness is exactly symmetric and has no mechanism but the rigid motions") {
    PlateProblem problem;
    problem.material = unit_bending(0.1);
    for (const Candidate& c : all_candidates()) {
      CAPTURE(c.name);
      CAPTURE(c.element.bent);
      const Eigen::MatrixXd matrix = system_of(c.kind, c.element, problem).matrix;
      CHECK(matrix == matrix.transpose());
      // A single element of Arnold and Falk can also twist: theta = (-y, x) about the centroid has
      // mean zero and no curvature. Neighbours cannot twist about two centroids.
      CHECK(zero_eigenvalues(matrix) == (c.kind == PlateElement::arnold_falk ? 4 : 3));
    }
  }

  TEST_CASE("the six-point control has no mechanism either") {
    PlateProblem problem;
    problem.material = unit_bending(0.1);
    ElementSystem system;
    six_point_kernel(problem)(skew_quad(), system);
    CHECK(zero_eigenvalues(system.matrix) == 3);
  }

  TEST_CASE("the energy is half the square of the unknowns in the stiffness") {
    PlateProblem problem;
    problem.material = unit_bending(0.05);
    for (const Candidate& c : all_candidates()) {
      CAPTURE(c.name);
      const LocalValues u = random_values(c.kind, c.element, 5);
      const auto system = system_of(c.kind, c.element, problem);
      const double expected = 0.5 * u.dot(system.matrix * u);
      const PlateEnergy energy = element_energy(c.kind, problem.material, c.element, u);
      CHECK(energy.total() == doctest::Approx(expected).epsilon(1e-12));
      CHECK(energy.bending > 0);
      CHECK(energy.shear > 0);
    }
  }

  TEST_CASE("the energy is the integral of the energy density of the states") {
    // Straight triangles and parallelograms, where the quadrature of the stiffness is exact.
    const Element lozenge = quad_element({{{0, 0}, {1.2, 0.2}, {1.5, 1.1}, {0.3, 0.9}}});
    const std::vector<Candidate> exact{{"MITC7", PlateElement::mitc, obtuse_triangle()},
                                       {"MITC9", PlateElement::mitc, lozenge},
                                       {"MITC4", PlateElement::mitc4, lozenge},
                                       {"AF", PlateElement::arnold_falk, obtuse_triangle()}};
    const PlateMaterial material = unit_bending(0.05);
    for (const Candidate& c : exact) {
      CAPTURE(c.name);
      const LocalValues u = random_values(c.kind, c.element, 6);
      const PlateEnergy energy = element_energy(c.kind, material, c.element, u);
      const PlateEnergy expected = integrated_energy(c, material, u);
      CHECK(energy.bending == doctest::Approx(expected.bending).epsilon(1e-12));
      CHECK(energy.shear == doctest::Approx(expected.shear).epsilon(1e-12));
    }
  }

  TEST_CASE("the quadrature on bent elements and on skew quadrilaterals is good to a percent") {
    const PlateMaterial material = unit_bending(0.05);
    for (const Candidate& c : all_candidates()) {
      if (c.element.bent && c.kind != PlateElement::mitc) continue;  // seen as straight
      CAPTURE(c.name);
      CAPTURE(c.element.bent);
      const LocalValues u = random_values(c.kind, c.element, 7);
      const PlateEnergy energy = element_energy(c.kind, material, c.element, u);
      const PlateEnergy expected = integrated_energy(c, material, u);
      CHECK(energy.bending == doctest::Approx(expected.bending).epsilon(0.01));
      CHECK(energy.shear == doctest::Approx(expected.shear).epsilon(0.01));
    }
  }

  TEST_CASE("the sum of reference integrals on a straight triangle equals the quadrature") {
    for (const double aspect : {1., 64.}) {
      const Element element = stretched(obtuse_triangle(), aspect);
      const FormsOf<Mitc7> fast = forms_of<Mitc7>(element);
      const FormsOf<Mitc7> slow = integrated_forms(TiedTables<Mitc7>::instance(), element);
      const auto same = [](const auto& a, const auto& b) {
        return (a - b).norm() < 1e-12 * b.norm();
      };
      CHECK(same(fast.gradients.xx, slow.gradients.xx));
      CHECK(same(fast.gradients.xy, slow.gradients.xy));
      CHECK(same(fast.gradients.yy, slow.gradients.yy));
      CHECK(same(fast.shear.ww, slow.shear.ww));
      CHECK(same(fast.shear.wx, slow.shear.wx));
      CHECK(same(fast.shear.wy, slow.shear.wy));
      CHECK(same(fast.shear.rotation.xx, slow.shear.rotation.xx));
      CHECK(same(fast.shear.rotation.xy, slow.shear.rotation.xy));
      CHECK(same(fast.shear.rotation.yy, slow.shear.rotation.yy));
    }
  }

  TEST_CASE("turning an element with its rotations keeps the energy") {
    const PlateMaterial material = unit_bending(0.05);
    for (const Candidate& c : all_candidates()) {
      CAPTURE(c.name);
      const double angle = 37 * std::numbers::pi / 180;
      const LocalValues u = random_values(c.kind, c.element, 8);
      LocalValues v = u;
      const auto turn = [&](int first) {
        const Vector t = turned(Vector{u[first], u[first + 1]}, angle);
        v[first] = t.x;
        v[first + 1] = t.y;
      };
      if (c.kind == PlateElement::arnold_falk)
        for (const int first : {0, 2, 4, 9}) turn(first);
      else
        for (int first = 1; first < u.size() - 1; first += 3) turn(first);
      if (c.kind == PlateElement::mitc) turn(static_cast<int>(u.size()) - 2);
      const Element there = moved(c.element, [&](Point p) {
        return turned(p, angle) + Vector{3, -2};
      });
      const PlateEnergy before = element_energy(c.kind, material, c.element, u);
      const PlateEnergy after = element_energy(c.kind, material, there, v);
      CHECK(after.bending == doctest::Approx(before.bending).epsilon(1e-11));
      CHECK(after.shear == doctest::Approx(before.shear).epsilon(1e-11));
    }
  }

  TEST_CASE("lengths times s make the energy s cubed times as large") {
    PlateMaterial material = unit_bending(0.05);
    PlateMaterial large = material;
    large.thickness *= 1000;
    for (const Candidate& c : all_candidates()) {
      CAPTURE(c.name);
      const LocalValues u = random_values(c.kind, c.element, 9);
      LocalValues v = u;
      const bool af = c.kind == PlateElement::arnold_falk;
      for (int i = af ? 6 : 0; i < (af ? 9 : u.size() - (c.kind == PlateElement::mitc ? 2 : 0));
           i += af ? 1 : 3)
        v[i] *= 1000;
      const Element big = moved(c.element, [](Point p) { return 1000 * p; });
      CHECK(element_energy(c.kind, large, big, v).total() ==
            doctest::Approx(1e9 * element_energy(c.kind, material, c.element, u).total())
                .epsilon(1e-12));
    }
  }

  TEST_CASE("a uniform load is shared as the integrals of the shape functions") {
    const Element right = triangle_element({{{0, 0}, {2, 0}, {0, 2}}});  // area 2
    const Element square = quad_element({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
    const auto load = [](PlateElement kind, const Element& e, int i) {
      return system_of(kind, e, unit_load()).rhs[i];
    };
    for (int k = 0; k < 3; ++k) {
      CHECK(std::abs(load(PlateElement::mitc, right, 3 * k)) < 1e-15);
      CHECK(load(PlateElement::mitc, right, 9 + 3 * k) == doctest::Approx(2. / 3));
      CHECK(load(PlateElement::arnold_falk, right, 6 + k) == doctest::Approx(2. / 3));
    }
    for (int k = 0; k < 4; ++k) {
      CHECK(load(PlateElement::mitc, square, 3 * k) == doctest::Approx(-1. / 3));
      CHECK(load(PlateElement::mitc, square, 12 + 3 * k) == doctest::Approx(4. / 3));
      CHECK(load(PlateElement::mitc4, square, 3 * k) == doctest::Approx(1));
    }
  }

  TEST_CASE(
      "a load that grows with x is shared by hand-computed integrals and rotations get none") {
    PlateProblem problem;
    problem.load = [](Point p) { return p.x; };
    const auto rhs =
        system_of(PlateElement::mitc, triangle_element({{{0, 0}, {1, 0}, {0, 1}}}), problem).rhs;
    const double expected[6] = {-1. / 120, 1. / 60, -1. / 120, 1. / 15, 1. / 15, 1. / 30};
    for (int i = 0; i < 6; ++i) CHECK(rhs[3 * i] == doctest::Approx(expected[i]).epsilon(1e-13));
    for (int i = 0; i < 20; ++i)
      if (i % 3 != 0 || i >= 18) CHECK(rhs[i] == 0);
  }

  TEST_CASE("a load that is no polynomial has the right resultant") {
    PlateProblem problem;
    problem.load = [](Point p) { return std::exp(p.x); };
    const auto on_triangle =
        system_of(PlateElement::mitc, triangle_element({{{0, 0}, {1, 0}, {0, 1}}}), problem);
    CHECK(sum_of_deflection_loads(on_triangle) ==
          doctest::Approx(std::numbers::e - 2).epsilon(1e-7));
    const auto on_square =
        system_of(PlateElement::mitc, quad_element({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}), problem);
    CHECK(sum_of_deflection_loads(on_square) == doctest::Approx(std::numbers::e - 1).epsilon(1e-9));
  }

  TEST_CASE("the load acts on the area inside bent edges") {
    // A parabola over a chord c with sag s adds 2 c s / 3.
    const Element bow = triangle_element({{{0, 0}, {1, 0}, {0, 1}}}, {0}, 0.1);
    CHECK(sum_of_deflection_loads(system_of(PlateElement::mitc, bow, unit_load())) ==
          doctest::Approx(0.5 + 0.2 / 3).epsilon(1e-13));
    const Element barrel = quad_element({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {0, 2}, 0.1);
    CHECK(sum_of_deflection_loads(system_of(PlateElement::mitc, barrel, unit_load())) ==
          doctest::Approx(1 + 0.4 / 3).epsilon(1e-13));
  }

  TEST_CASE("materials and loads are those of the region") {
    PlateProblem problem;
    problem.material = unit_bending(0.1);
    problem.regions.emplace_back(7, problem.material);
    problem.regions.back().second.young *= 2;
    problem.load.set(7, 5.);
    Element element = obtuse_triangle();
    const auto outside = system_of(PlateElement::mitc, element, problem);
    element.region = 7;
    const auto inside = system_of(PlateElement::mitc, element, problem);
    CHECK((inside.matrix - 2 * outside.matrix).norm() < 1e-12 * inside.matrix.norm());
    CHECK(outside.rhs.norm() == 0);
    CHECK(sum_of_deflection_loads(inside) ==
          doctest::Approx(5 * 0.5 *
                          twice_area(element.nodes[0], element.nodes[1], element.nodes[2])));
  }

  TEST_CASE("an element of the wrong shape is refused with its place") {
    Element square = quad_element({{{0.25, 3}, {1, 3}, {1, 4}, {0.25, 4}}});
    square.number = 12;
    CHECK_THROWS_WITH_AS(
        system_of(PlateElement::arnold_falk, square, unit_load()),
        "element 13 near (0.25, 3) is a quadrilateral, but the plate element arnold_falk is for "
        "triangles only; choose mitc, which is for both",
        UsageError);
    CHECK_THROWS_AS(system_of(PlateElement::mitc4, obtuse_triangle(), unit_load()), UsageError);
    const LocalValues values = LocalValues::Zero(20);
    CHECK_THROWS_AS(plate_state(PlateElement::mitc4, {}, obtuse_triangle(), values, {0, 0}),
                    UsageError);
    CHECK_THROWS_AS(element_energy(PlateElement::mitc4, {}, obtuse_triangle(), values), UsageError);
  }

  TEST_CASE("an element that is inside out is refused with its place") {
    Element clockwise = triangle_element({{{0, 0}, {0, 1}, {1, 0}}});
    clockwise.number = 3;
    CHECK_THROWS_AS(system_of(PlateElement::mitc, clockwise, unit_load()), InputError);
    const Element dart = quad_element({{{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}}});
    CHECK_THROWS_AS(system_of(PlateElement::mitc, dart, unit_load()), InputError);
  }

  TEST_CASE("a load that is not finite is refused with the place") {
    PlateProblem problem;
    problem.load = [](Point p) { return p.x > 0.9 ? std::numeric_limits<double>::infinity() : 1.; };
    CHECK_THROWS_AS(system_of(PlateElement::mitc, obtuse_triangle(), problem), InputError);
  }
}
