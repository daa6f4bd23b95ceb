// Results do not depend on the axes or on the units (issue 4: to 1e-10).
#include <cmath>

#include <doctest/doctest.h>

#include "solver/plate/solve_plate.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// A plate with all kinds of supports and loads in a frame that is turned by `angle`, with lengths
/// times `length` and forces times `force`.
struct Posed {
  double angle, length, force;
  Mesh mesh;
  PlateProblem problem;

  Posed(double turn, double lengths, double forces) : angle(turn), length(lengths), force(forces) {
    mesh = mapped(perturbed(mixed_square(6, 6), 6, 6, 0.25, 4),
                  [this](Point p) { return length * turned(p, angle); });
    problem.material = unit_bending(0.05);
    problem.material.thickness *= length;
    problem.material.young *= force / (length * length);
    problem.load = [this](Point p) {
      const Point local = original(p);
      return (1 + local.x * local.x - local.y) * force / (length * length);
    };
    problem.supports = {{kBottom, SupportKind::hard_support, {}},
                        {kRight, SupportKind::soft_clamped, 0.01 * length},
                        {kLeft, SupportKind::symmetry, {}}};
    problem.supports[0].deflection = [this](Point p) { return 0.01 * length * original(p).x; };
    problem.edge_loads = {{kTop, 0.3 * force / length, 0.1 * force, -0.2 * force}};
    problem.point_loads = {{length * turned({0.3, 0.4}, angle), 0.5 * force}};
  }

  Point original(Point p) const { return turned((1 / length) * p, -angle); }
};

/// Largest difference of the states and reactions, in the first frame, relative to the largest
/// value of each kind.
struct Difference {
  double w = 0, rotation = 0, moments = 0, shear = 0, reactions = 0, energy = 0;
};

void add(double value, double expected, double& difference, double& scale) {
  difference = std::max(difference, std::abs(value - expected));
  scale = std::max(scale, std::abs(expected));
}

/// M in the frame turned by -angle.
Moments turned_back(const Moments& m, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * m.xx + 2 * c * s * m.xy + s * s * m.yy,
          s * s * m.xx - 2 * c * s * m.xy + c * c * m.yy,
          (c * c - s * s) * m.xy + c * s * (m.yy - m.xx)};
}

Difference compare(const Posed& first, const Posed& second) {
  const FeMesh fe = straight_fe_mesh(first.mesh), other = straight_fe_mesh(second.mesh);
  const PlateSolution a = solve_plate(fe, first.problem), b = solve_plate(other, second.problem);
  const auto states = vertex_states(fe, first.problem, a);
  const auto others = vertex_states(other, second.problem, b);
  Difference d, scale;
  const double length = second.length, force = second.force, angle = second.angle;
  for (std::size_t v = 0; v < states.size(); ++v) {
    const PlateState &p = states[v], &q = others[v];
    const Vector rotation = turned(q.rotation, -angle), shear = turned(q.shear, -angle);
    const Moments m = turned_back(q.moments, angle);
    add(q.w / length, p.w, d.w, scale.w);
    add(rotation.x, p.rotation.x, d.rotation, scale.rotation);
    add(rotation.y, p.rotation.y, d.rotation, scale.rotation);
    add(m.xx / force, p.moments.xx, d.moments, scale.moments);
    add(m.yy / force, p.moments.yy, d.moments, scale.moments);
    add(m.xy / force, p.moments.xy, d.moments, scale.moments);
    add(shear.x * length / force, p.shear.x, d.shear, scale.shear);
    add(shear.y * length / force, p.shear.y, d.shear, scale.shear);
  }
  for (std::size_t r = 0; r < a.reactions.size(); ++r) {
    const PlateReaction &p = a.reactions[r], &q = b.reactions[r];
    const Vector moment = turned(q.moment, -angle);
    add(q.force / force, p.force, d.reactions, scale.reactions);
    add(moment.x / (force * length), p.moment.x, d.reactions, scale.reactions);
    add(moment.y / (force * length), p.moment.y, d.reactions, scale.reactions);
  }
  add(b.energy.total() / (force * length), a.energy.total(), d.energy, scale.energy);
  return {d.w / scale.w,         d.rotation / scale.rotation,   d.moments / scale.moments,
          d.shear / scale.shear, d.reactions / scale.reactions, d.energy / scale.energy};
}

void check_same(const Posed& first, const Posed& second) {
  const Difference d = compare(first, second);
  CHECK(d.w < 1e-10);
  CHECK(d.rotation < 1e-10);
  CHECK(d.moments < 1e-10);
  CHECK(d.shear < 1e-10);
  CHECK(d.reactions < 1e-10);
  CHECK(d.energy < 1e-10);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a plate turned by 37 degrees gives the same results") {
    check_same({0, 1, 1}, {kSmallAngle, 1, 1});
  }
  TEST_CASE("lengths and forces in other units give the same results") {
    check_same({0, 1, 1}, {0, 1e3, 1});
    check_same({0, 1, 1}, {0, 1, 1e3});
    check_same({0, 1, 1}, {kSmallAngle, 1e-3, 1e6});
  }
}
