// Row 5 of the acceptance table: plates in a state of constant moments without shear forces, solved
// as boundary value problems, come out exact on thin, stretched and distorted elements.
#include <algorithm>
#include <cmath>
#include <utility>

#include <doctest/doctest.h>

#include "solver/space/reference_quadrature.hpp"
#include "tests/solver/acceptance/solved_plate.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

constexpr double kThickness = 1e-3;

/// w = (0.6 x^2 - 0.9 x y + 0.8 y^2) / 2 + 0.1 x - 0.2 y + 0.3.
constexpr double kXx = 0.6, kXy = -0.45, kYy = 0.8;
double deflection(Point p) {
  return 0.5 * (kXx * p.x * p.x + 2 * kXy * p.x * p.y + kYy * p.y * p.y) + 0.1 * p.x - 0.2 * p.y +
         0.3;
}

/// The moments of theta = grad w with D = 1, nu = 0.3.
constexpr Moments kMoments{-(kXx + 0.3 * kYy), -(kYy + 0.3 * kXx), -0.7 * kXy};

/// Couples that hold the plate in that state; n is the outward normal, s = (-n_y, n_x).
PlateEdgeLoad couples(Index tag, Vector n) {
  const Vector on_normal{kMoments.xx * n.x + kMoments.xy * n.y,
                         kMoments.xy * n.x + kMoments.yy * n.y};
  PlateEdgeLoad load;
  load.tag = tag;
  load.moment = dot(n, on_normal);
  load.twist = dot({-n.y, n.x}, on_normal);
  return load;
}

PlateProblem with_couples() {
  PlateProblem problem;
  problem.material = unit_plate(kThickness);
  problem.edge_loads = {couples(test::kLeft, {-1, 0}), couples(test::kRight, {1, 0}),
                        couples(test::kBottom, {0, -1}), couples(test::kTop, {0, 1})};
  return problem;
}

/// Free but for three corners of [0, 1] x [0, height].
PlateProblem on_three_pins(double height) {
  PlateProblem problem = with_couples();
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, height}})
    problem.point_supports.push_back({p, deflection(p), false});
  return problem;
}

/// The deflection given on all sides.
PlateProblem on_settled_sides() {
  PlateProblem problem = with_couples();
  for (const Index side : {test::kLeft, test::kRight, test::kBottom, test::kTop})
    problem.supports.push_back({side, SupportKind::soft_support, Coefficient(deflection)});
  return problem;
}

struct Worst {
  double curvature = 0;  ///< |M - exact| / D
  double shear = 0;      ///< |Q| / (k G t)
};

Worst worst_of(const SolvedPlate& plate) {
  Worst worst;
  for (Index e = 0; e < plate.fe.element_count(); ++e) {
    const Element element = element_at(plate.fe, e);
    for (const WeightedPoint& point : reference_quadrature(element.shape, 5)) {
      const PlateState state =
          plate_state(plate.fe, plate.problem, plate.solution, element, point.at);
      worst.curvature = std::max({worst.curvature, std::abs(state.moments.xx - kMoments.xx),
                                  std::abs(state.moments.yy - kMoments.yy),
                                  std::abs(state.moments.xy - kMoments.xy)});
      worst.shear =
          std::max(worst.shear, norm(state.shear) / plate.problem.material.shear_stiffness());
    }
  }
  return worst;
}

/// 4 x 4 distorted cells on [0, 1] x [0, 1/aspect].
enum class Cells { triangles, quads, mixed };
Mesh stretched(Cells cells, double aspect) {
  Mesh mesh = cells == Cells::triangles ? test::square_mesh(4)
              : cells == Cells::quads   ? test::square_quads(4, 4)
                                        : test::mixed_square(4, 4);
  mesh = test::perturbed(std::move(mesh), 4, 4, 0.3, 20061122);
  return test::mapped(std::move(mesh), [aspect](Point p) { return Point{p.x, p.y / aspect}; });
}

void check_exact(const SolvedPlate& plate) {
  const Worst worst = worst_of(plate);
  CHECK(worst.curvature <= 1e-6);
  CHECK(worst.shear <= 1e-10);
  for (const PlateState& state : vertex_states(plate.fe, plate.problem, plate.solution))
    CHECK(std::abs(state.w - deflection(state.x)) <= 1e-6);
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("constant moments come out exact on thin stretched distorted elements") {
    for (const Cells cells : {Cells::triangles, Cells::quads, Cells::mixed})
      for (const double aspect : {1., 8., 64.}) {
        CAPTURE(static_cast<int>(cells));
        CAPTURE(aspect);
        check_exact(SolvedPlate(stretched(cells, aspect), on_settled_sides()));
      }
  }

  // Without the sides' support round-off is larger: at aspect 64 it exceeds the bounds.
  TEST_CASE("constant moments come out exact in a plate on three pins") {
    for (const Cells cells : {Cells::triangles, Cells::quads, Cells::mixed})
      for (const double aspect : {1., 8.}) {
        CAPTURE(static_cast<int>(cells));
        CAPTURE(aspect);
        check_exact(SolvedPlate(stretched(cells, aspect), on_three_pins(1 / aspect)));
      }
  }
}
