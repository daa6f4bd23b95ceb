#include "solver/plate/mitc7.hpp"

#include <doctest/doctest.h>

#include "tests/solver/plate/sample_elements.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// The stiffness against the integral of what it is made of, for several values of the unknowns.
void check_energies(const Element& element, double tolerance) {
  const PlateMaterial material = unit_bending(0.05);
  const Candidate triangle{"MITC7", PlateElement::mitc, element};
  for (const std::uint64_t seed : {1, 2, 3}) {
    const LocalValues u = random_values(triangle.kind, element, seed);
    const PlateEnergy energy = element_energy(triangle.kind, material, element, u);
    const PlateEnergy expected = integrated_energy(triangle, material, u);
    CHECK(energy.bending == doctest::Approx(expected.bending).epsilon(tolerance));
    CHECK(energy.shear == doctest::Approx(expected.shear).epsilon(tolerance));
  }
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the quadrature of straight MITC7 is exact however stretched the triangle is") {
    for (const double aspect : {1., 8., 64., 1000.})
      check_energies(stretched(obtuse_triangle(), aspect), 1e-11);
  }

  TEST_CASE("the quadrature of bent MITC7 is good to five digits") {
    for (const std::vector<int>& edges : {std::vector{0}, {2}, {0, 2}})
      check_energies(with_edges(obtuse_triangle(), edges, 0.1), 1e-5);
  }
}
