// What every plate element must reproduce exactly.
#include <doctest/doctest.h>

#include "tests/solver/plate/sample_elements.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr double kNu = 0.3;

PlateMaterial thin() { return unit_bending(1e-3); }  // S = 3.5e6

/// Over the probes of an element.
struct Extremes {
  double moment = 0, shear = 0;
};

Extremes largest_resultants(const Candidate& c, const PlateMaterial& material,
                            const LocalValues& values) {
  Extremes largest;
  for (const ReferencePoint& at : probes(c.element.shape)) {
    const PlateState s = plate_state(c.kind, material, c.element, values, at);
    largest.moment = std::max(
        {largest.moment, std::abs(s.moments.xx), std::abs(s.moments.yy), std::abs(s.moments.xy)});
    largest.shear = std::max(largest.shear, norm(s.shear));
  }
  return largest;
}

void check_rigid(const Candidate& c) {
  CAPTURE(c.name);
  CAPTURE(c.element.bent);
  const LocalValues values = interpolated(
      c.kind, c.element, [](Point p) { return 0.7 - 1.3 * p.x + 0.4 * p.y; },
      [](Point) {
        return Vector{-1.3, 0.4};
      });
  const PlateMaterial material = unit_bending(0.1);  // D = 1, S = 350
  const auto [moment, shear] = largest_resultants(c, material, values);
  CHECK(moment < 1e-13);
  CHECK(shear < 1e-11);
  const PlateEnergy energy = element_energy(c.kind, material, c.element, values);
  CHECK(std::abs(energy.bending) < 1e-12);
  CHECK(std::abs(energy.shear) < 1e-11);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a rigid motion costs no energy and causes no stress on straight elements") {
    for (const Candidate& c : straight_candidates()) check_rigid(c);
  }

  TEST_CASE("a rigid motion costs no energy and causes no stress on bent elements") {
    // The baselines see bent elements as straight.
    for (const Candidate& c : bent_candidates()) check_rigid(c);
  }

  TEST_CASE("a rigid motion keeps its deflection and rotation inside bent MITC elements") {
    for (const Candidate& c : bent_candidates()) {
      if (c.kind != PlateElement::mitc) continue;
      const auto plane = [](Point p) { return 0.7 - 1.3 * p.x + 0.4 * p.y; };
      const LocalValues values = interpolated(c.kind, c.element, plane, [](Point) {
        return Vector{-1.3, 0.4};
      });
      for (const ReferencePoint& at : probes(c.element.shape)) {
        const PlateState s = plate_state(c.kind, thin(), c.element, values, at);
        CHECK(s.w == doctest::Approx(plane(s.x)).epsilon(1e-13));
        CHECK(s.rotation.x == doctest::Approx(-1.3).epsilon(1e-13));
        CHECK(s.rotation.y == doctest::Approx(0.4).epsilon(1e-13));
      }
    }
  }

  TEST_CASE("constant curvature gives the exact moments and no shear at any aspect") {
    // w = x^2 / 2 - 0.7 x y + 0.8 y^2, curvatures 1, 1.6 and -0.7.
    const auto w = [](Point p) { return 0.5 * p.x * p.x - 0.7 * p.x * p.y + 0.8 * p.y * p.y; };
    const auto theta = [](Point p) { return Vector{p.x - 0.7 * p.y, 1.6 * p.y - 0.7 * p.x}; };
    for (Candidate c : straight_candidates())
      for (const double aspect : {1., 8., 64.}) {
        CAPTURE(c.name);
        CAPTURE(aspect);
        const Candidate long_one{c.name, c.kind, stretched(c.element, aspect)};
        const LocalValues values = interpolated(c.kind, long_one.element, w, theta);
        for (const ReferencePoint& at : probes(c.element.shape)) {
          const PlateState s = plate_state(c.kind, thin(), long_one.element, values, at);
          CHECK(s.moments.xx == doctest::Approx(-(1 + kNu * 1.6)).epsilon(1e-10));
          CHECK(s.moments.yy == doctest::Approx(-(1.6 + kNu)).epsilon(1e-10));
          CHECK(s.moments.xy == doctest::Approx(0.7 * (1 - kNu)).epsilon(1e-10));
          CHECK(norm(s.shear) / 3.5e6 < 1e-12 * aspect);
        }
      }
  }

  TEST_CASE("constant shear strain gives the exact shear force and no moment") {
    // gamma = (0.5, -2), S = 350
    const auto w = [](Point p) { return 1.5 * p.x - p.y; };
    const auto theta = [](Point) { return Vector{1, 1}; };
    for (const auto& candidates : {straight_candidates(), bent_candidates()})
      for (const Candidate& c : candidates) {
        CAPTURE(c.name);
        const LocalValues values = interpolated(c.kind, c.element, w, theta);
        for (const ReferencePoint& at : probes(c.element.shape)) {
          const PlateState s = plate_state(c.kind, unit_bending(0.1), c.element, values, at);
          CHECK(s.shear.x == doctest::Approx(175).epsilon(1e-12));
          CHECK(s.shear.y == doctest::Approx(-700).epsilon(1e-12));
          CHECK(std::abs(s.moments.xx) + std::abs(s.moments.yy) + std::abs(s.moments.xy) < 1e-12);
        }
      }
  }

  TEST_CASE("MITC7 and MITC9 have the same deflection and rotations on a common edge") {
    for (const double bend : {0., 0.1}) {
      const std::vector<int> bent = bend > 0 ? std::vector<int>{1} : std::vector<int>{};
      // Edge 1 of the triangle from (1, 0) to (0, 1) is edge 3 of the quadrilateral, run backwards.
      const Element left = triangle_element({{{0, 0}, {1, 0}, {0, 1}}}, bent, bend);
      Element right = quad_element({{{1, 0}, {1.6, 0.3}, {1.2, 1.7}, {0, 1}}});
      right = with_edges(right, bend > 0 ? std::vector<int>{3} : std::vector<int>{}, -bend);
      REQUIRE(norm(left.nodes[4] - right.nodes[7]) < 1e-15);

      LocalValues a = random_values(PlateElement::mitc, left, 1);
      LocalValues b = random_values(PlateElement::mitc, right, 2);
      for (int c = 0; c < 3; ++c) {
        b[c] = a[3 + c];        // (1, 0)
        b[9 + c] = a[6 + c];    // (0, 1)
        b[21 + c] = a[12 + c];  // the edge
      }
      for (const double t : {0.1, 0.5, 0.83}) {
        const PlateState p = plate_state(PlateElement::mitc, thin(), left, a, {1 - t, t});
        const PlateState q = plate_state(PlateElement::mitc, thin(), right, b, {-1, 2 * t - 1});
        CHECK(norm(p.x - q.x) < 1e-14);
        CHECK(p.w == doctest::Approx(q.w).epsilon(1e-13));
        CHECK(norm(p.rotation - q.rotation) < 1e-13);
      }
    }
  }
}
