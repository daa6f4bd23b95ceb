// The elements in small systems of equations: accuracy on uniform meshes and no locking.
#include <set>

#include <Eigen/SparseCholesky>
#include <doctest/doctest.h>

#include "solver/system/constraints.hpp"
#include "tests/solver/plate/sample_elements.hpp"
#include "tests/solver/plate/six_point_mitc9.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// A quarter of the unit square from the corner at the origin to the centre.
Mesh quarter_of(const Mesh& unit_square) {
  return mapped(unit_square, [](Point p) { return 0.5 * p; });
}

/// Squares cut along alternating diagonals, as the reference values were computed.
Mesh alternating(Index n) {
  Mesh mesh = square_mesh(n);
  for (Index cell = 0; cell < n * n; ++cell)
    if ((cell % n + cell / n) % 2 == 1) {
      auto& first = mesh.triangles[2 * cell];
      auto& second = mesh.triangles[2 * cell + 1];
      const Index a = first[0], b = first[1], c = first[2], d = second[2];
      first = {a, b, d};
      second = {b, c, d};
    }
  return mesh;
}

/// Layout and components of the element or of the six-point control.
struct Discretisation {
  DofLayout layout;
  PlateComponents vertex, edge;
  ElementKernel kernel;
};

Discretisation discretisation(PlateElement kind, const PlateProblem& problem) {
  return {plate_layout(kind), vertex_components(kind), edge_components(kind),
          plate_kernel(kind, problem)};
}

Discretisation six_points(const PlateProblem& problem) {
  return {kSixPointLayout, {0, 1}, {0, 1}, six_point_kernel(problem)};
}

bool is_clamped(Index tag) { return tag == kBottom || tag == kLeft || tag == kRim; }

/// Clamped at the bottom, on the left and on rims, symmetric about the right and the top.
std::vector<Constraint> supports_of(const FeMesh& fe, const DofMap& dofs, const Discretisation& d) {
  std::set<Index> unknowns;
  const auto hold = [&](Index first, PlateComponents c, Index tag) {
    const bool clamped = is_clamped(tag);
    if (c.w >= 0 && clamped) unknowns.insert(first + c.w);
    if (c.rotation >= 0 && (clamped || tag == kRight)) unknowns.insert(first + c.rotation);
    if (c.rotation >= 0 && (clamped || tag == kTop)) unknowns.insert(first + c.rotation + 1);
  };
  for (std::size_t e = 0; e < fe.mesh.edges.size(); ++e) {
    const CurveEdge& edge = fe.mesh.edges[e];
    for (const Index v : edge.vertices) hold(dofs.at_vertex(v), d.vertex, edge.tag);
    hold(dofs.at_edge(fe.edges.curve_edges[e]), d.edge, edge.tag);
  }
  std::vector<Constraint> constraints;
  for (const Index unknown : unknowns) constraints.push_back({unknown, 0});
  return constraints;
}

/// A x = b scaled by the diagonal, with one step of refinement.
Eigen::VectorXd scaled_solution(const LinearSystem& system) {
  const Eigen::VectorXd scale = system.matrix.diagonal().cwiseSqrt().cwiseInverse();
  const SparseMatrix matrix = scale.asDiagonal() * system.matrix * scale.asDiagonal();
  const Eigen::VectorXd rhs = scale.cwiseProduct(system.rhs);
  const Eigen::SimplicialLDLT<SparseMatrix> factors(matrix);
  Eigen::VectorXd x = factors.solve(rhs);
  x += factors.solve(rhs - matrix * x);
  return scale.cwiseProduct(x);
}

/// Half the work of the load on the global unknowns, D = q = 1 (that on the inner deflection of the
/// control is left out; it is far below the errors looked for).
double energy_of(const FeMesh& fe, const Discretisation& d) {
  const DofMap dofs = make_dof_map(fe, d.layout);
  LinearSystem system = assemble(fe, dofs, d.kernel, 1);
  const Eigen::VectorXd load = system.rhs;
  impose(supports_of(fe, dofs, d), system);
  return 0.5 * load.dot(scaled_solution(system));
}

/// Energy of the whole clamped plate from a quarter of it.
double energy_of_clamped_plate(const Mesh& quarter, const Discretisation& d) {
  return 4 * energy_of(straight_fe_mesh(quarter), d);
}

PlateProblem uniformly_loaded(double thickness) {
  PlateProblem problem;
  problem.material = unit_bending(thickness);
  problem.load = 1.;
  return problem;
}

/// references.json, mindlin_square, CCCC.
constexpr double kThickEnergy = 2.502212267e-4, kThinEnergy = 1.945659298e-4;

double relative_error(const Mesh& quarter, PlateElement kind, double thickness) {
  const PlateProblem problem = uniformly_loaded(thickness);
  const double expected = thickness == 0.1 ? kThickEnergy : kThinEnergy;
  return energy_of_clamped_plate(quarter, discretisation(kind, problem)) / expected - 1;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("energy of the clamped square on 8 x 8 cells of the quarter") {
    // Errors of independent prototypes on these meshes, FE.md, section 1.2.
    struct {
      PlateElement kind;
      Mesh mesh;
      double thick, thin;
    } const cases[] = {{PlateElement::mitc, alternating(8), 7e-5, 3.5e-4},
                       {PlateElement::mitc, square_quads(8, 8), 3.2e-5, 7.2e-6},
                       {PlateElement::mitc4, square_quads(8, 8), 1.3e-2, 1.5e-2},
                       {PlateElement::arnold_falk, alternating(8), 1.4e-2, 2.6e-2}};
    for (const auto& c : cases) {
      CAPTURE(static_cast<int>(c.kind));
      CAPTURE(c.mesh.quads.size());
      const Mesh quarter = quarter_of(c.mesh);
      CHECK(-relative_error(quarter, c.kind, 0.1) == doctest::Approx(c.thick).epsilon(0.04));
      CHECK(-relative_error(quarter, c.kind, 0.001) == doctest::Approx(c.thin).epsilon(0.04));
    }
  }

  TEST_CASE("the energy of a clamped disc converges at fourth order on bent triangles") {
    for (const double thickness : {0.1, 0.001}) {
      CAPTURE(thickness);
      const PlateProblem problem = uniformly_loaded(thickness);
      // pi q^2 a^6 / (384 D) + pi q^2 a^4 / (16 kGt), kGt = 3.5 D / t^2
      const double expected = kPi / 384 + kPi * thickness * thickness / (16 * 3.5);
      const auto error = [&](Index rings) {
        const CurvedDisc disc(rings);
        const auto mitc = discretisation(PlateElement::mitc, problem);
        return std::abs(energy_of(disc.fe, mitc) / expected - 1);
      };
      const double coarse = error(4), middle = error(8), fine = error(16);
      CHECK(fine < 3e-6);
      CHECK(std::log2(coarse / middle) > 3.7);
      CHECK(std::log2(middle / fine) > 3.7);
    }
  }

  TEST_CASE("the recommended elements do not lock on distorted stretched cells") {
    struct {
      Index aspect;
      double triangles, quads;
    } const cases[] = {{1, 0.01, 0.005}, {8, 0.03, 0.005}, {64, 0.15, 0.05}};
    for (const auto& c : cases) {
      CAPTURE(c.aspect);
      const Index n = 4 * c.aspect;
      const Mesh triangles = quarter_of(perturbed(square_mesh(4, n), 4, n, 0.3, 1));
      const Mesh quads = quarter_of(perturbed(square_quads(4, n), 4, n, 0.3, 1));
      CHECK(std::abs(relative_error(triangles, PlateElement::mitc, 0.001)) < c.triangles);
      CHECK(std::abs(relative_error(quads, PlateElement::mitc, 0.001)) < c.quads);
    }
  }

  TEST_CASE("the six-point control locks on distorted stretched cells and on no others") {
    const PlateProblem problem = uniformly_loaded(0.001);
    const auto error = [&](const Mesh& mesh) {
      return energy_of_clamped_plate(quarter_of(mesh), six_points(problem)) / kThinEnergy - 1;
    };
    CHECK(std::abs(error(square_quads(4, 32))) < 1e-3);
    CHECK(std::abs(error(square_quads(4, 256))) < 1e-3);
    CHECK(error(perturbed(square_quads(4, 32), 4, 32, 0.3, 1)) < -0.3);
    CHECK(error(perturbed(square_quads(4, 256), 4, 256, 0.3, 1)) < -0.9);
  }
}
