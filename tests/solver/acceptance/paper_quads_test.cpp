// Row 20: quadrilaterals as the paper makes them, three of each triangle of an anisotropic mesh, in
// the layer of a softly supported plate: the Bathe-Brezzi MITC9 is safe on them where two controls
// are not.
#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "solver/plate/plate_supports.hpp"
#include "tests/solver/acceptance/layer_mesh.hpp"
#include "tests/solver/acceptance/reference_plate.hpp"
#include "tests/solver/acceptance/square_plates.hpp"
#include "tests/solver/plate/six_point_mitc9.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

constexpr double kThickness = .001;
constexpr SquareReference kExact = kSquareReferences[2];
static_assert(kExact.plate == SquarePlate::soft && kExact.thickness == kThickness);

PlateProblem soft_plate() { return quarter_plate(SquarePlate::soft, kThickness); }

Mesh quads_of_layer_triangles() {
  LayerSizes sizes;
  sizes.least = 0.5 * plate_layer(kThickness);
  sizes.growth = 0.8;
  sizes.most = 0.055;
  sizes.stretch = 300;
  return test::three_quads_of(adapted_quarter(sizes, Elements::triangle));
}

/// The plate solved by the six-point MITC9, a kernel of the tests that solve_plate() does not have.
struct SixPointPlate {
  SixPointPlate(const FeMesh& mesh, const PlateProblem& problem)
      : fe(mesh), material(problem.material), dofs(make_dof_map(mesh, test::kSixPointLayout)) {
    const ElementKernel kernel = test::six_point_kernel(problem);
    LinearSystem system = assemble(mesh, dofs, kernel);
    // Its unknowns at vertices and edges are those of mitc.
    const PlateConditions conditions = plate_conditions(mesh, dofs, PlateElement::mitc, problem);
    rotate_to_frames(conditions.frames, system);
    impose(conditions.constraints, system);
    Eigen::VectorXd solution = solve_linear(system).solution;
    rotate_back(conditions.frames, solution);
    values.assign(solution.data(), solution.data() + solution.size());
    inner = inner_values(mesh, dofs, kernel, solution);
  }

  PlateState state(const Element& element, ReferencePoint at) const {
    return state_of<test::SixPointMitc9>(element, material,
                                         local_values(fe, dofs, element, values, inner), at);
  }

  const FeMesh& fe;
  PlateMaterial material;
  DofMap dofs;
  std::vector<double> values, inner;
};

double six_point_error(const Mesh& mesh, const ReferencePlate& reference) {
  const FeMesh fe = straight_fe_mesh(mesh);
  const PlateProblem problem = soft_plate();
  const SixPointPlate plate(fe, problem);
  return relative_energy_error(
      fe, problem,
      [&](const Element& element, ReferencePoint at) { return plate.state(element, at); },
      reference);
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE(
      "MITC9 is right in layers on quadrilaterals cut from triangles and two controls are not") {
    const auto lines = layer_lines(48, 0.5, plate_layer(kThickness));
    const ReferencePlate reference(soft_plate(), lines, lines);
    REQUIRE(relative_error(4 * reference.solution().energy.total(), kExact.energy) <= 5e-7);
    const Mesh mesh = quads_of_layer_triangles();

    const SolvedPlate mitc(mesh, soft_plate());
    CHECK(mitc.solution.dofs.count() <= 45000);
    CHECK(relative_error(4 * mitc.solution.energy.total(), kExact.energy) <= 1e-4);
    CHECK(relative_energy_error(mitc, reference) <= 1e-2);

    const SolvedPlate mitc4(mesh, soft_plate(), PlateElement::mitc4);
    CHECK(relative_energy_error(mitc4, reference) >= 4e-2);

    CHECK(six_point_error(mesh, reference) >= 1.5e-2);
    // On rectangles that control has nothing to hide.
    const auto coarse = layer_lines(16, 0.5, plate_layer(kThickness));
    CHECK(six_point_error(quads_on(coarse, coarse), reference) <= 3e-3);
  }
}
