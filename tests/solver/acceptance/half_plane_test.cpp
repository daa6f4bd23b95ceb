// Row 13: the half plane x > 0 under cos 2 pi y in closed form, the layer at its edge included.
#include "tests/solver/acceptance/half_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "solver/space/reference_quadrature.hpp"
#include "tests/solver/acceptance/side_states.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

/// A, B, C from references.json (a = 2 pi, t = 0.01).
constexpr HalfPlane kSoft{SupportKind::soft_support, .01, -6.416340847713947e-4,
                          -1.9873288636912904e-3, -2.566761932194154e-7};
constexpr HalfPlane kFree{SupportKind::free, .01, 1.1108031219265999e-4, -3.7535691535222455e-4,
                          1.3476783174224851e-7};
constexpr HalfPlane kHard{SupportKind::hard_support, .01, -6.416238909177712e-4,
                          -2.0157209020749685e-3, 0};
constexpr HalfPlane kClamped{SupportKind::clamped, .01, -6.409017648670264e-4,
                             -4.026994686024872e-3, 1.4345218627064478e-8};
constexpr HalfPlane kSoftClamped{SupportKind::soft_clamped, .01, -6.409017971557022e-4,
                                 -4.0269047552337e-3, 0};

enum class Cells { triangles, quads };

/// Fine enough to resolve the layer; `finer` halves the sizes.
SolvedPlate solved(const HalfPlane& exact, Cells cells, bool finer = false) {
  const double scale = finer ? 0.5 : 1;
  LayerSizes sizes;
  sizes.least = 0.3 * scale * plate_layer(exact.thickness);
  sizes.growth = 0.3 * scale;
  sizes.most = 0.1 * scale;
  const auto x = size_lines(sizes, 3), y = equal_lines(finer ? 24 : 12, 0.25);
  return SolvedPlate(cells == Cells::triangles ? triangles_on(x, y) : quads_on(x, y),
                     half_plane_strip(exact.support, exact.thickness));
}

/// Largest errors, relative to the largest exact values.
struct Errors {
  double w, rotation, moment, shear;
};

Errors errors_of(const SolvedPlate& plate, const HalfPlane& exact) {
  Errors error{}, largest{};
  for (Index e = 0; e < plate.fe.element_count(); ++e) {
    const Element element = element_at(plate.fe, e);
    for (const WeightedPoint& point : reference_quadrature(element.shape, 3)) {
      const PlateState s = plate_state(plate.fe, plate.problem, plate.solution, element, point.at),
                       x = exact.at(s.x);
      const auto take = [](double& worst, double value) { worst = std::max(worst, value); };
      take(error.w, std::abs(s.w - x.w));
      take(error.rotation, norm(s.rotation - x.rotation));
      take(error.moment, norm(Vector{s.moments.xx - x.moments.xx, s.moments.yy - x.moments.yy}) +
                             std::abs(s.moments.xy - x.moments.xy));
      take(error.shear, norm(s.shear - x.shear));
      take(largest.w, std::abs(x.w));
      take(largest.rotation, norm(x.rotation));
      take(largest.moment, norm(Vector{x.moments.xx, x.moments.yy}));
      take(largest.shear, norm(x.shear));
    }
  }
  return {error.w / largest.w, error.rotation / largest.rotation, error.moment / largest.moment,
          error.shear / largest.shear};
}

/// Length over which the layer of Q_y at y = 1/4 falls by e, from x = 0 and one such length.
double decay_length(const SolvedPlate& plate, const HalfPlane& exact) {
  const SideStates top(plate, test::kTop);
  const double step = exact.thickness / std::sqrt(10.);
  const auto layer = [&](double x) {
    return std::abs(top.at({x, 0.25}).shear.y - exact.outer_shear(x));
  };
  return step / std::log(layer(0) / layer(step));
}

/// Largest error of Q_y on the edge against peak sin 2 pi y, relative to the peak.
double profile_error(const SolvedPlate& plate, double peak) {
  double error = 0;
  for (const PlateState& state : SideStates(plate, test::kLeft).sampled(3))
    error = std::max(error, std::abs(state.shear.y / peak - std::sin(HalfPlane::a * state.x.y)));
  return error;
}

/// t / sqrt(10 + a^2 t^2).
double exact_decay(const HalfPlane& exact) {
  const double at = HalfPlane::a * exact.thickness;
  return exact.thickness / std::sqrt(10 + at * at);
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("the closed form fulfils the conditions of its edge") {
    for (const HalfPlane& h : {kSoft, kFree, kHard, kClamped, kSoftClamped}) {
      const PlateState even = h.at({0, 0}), odd = h.at({0, 0.25});
      const bool is_free = h.support == SupportKind::free;
      CHECK(std::abs(is_free ? even.shear.x : even.w) <= 1e-12);
      const bool is_clamped =
          h.support == SupportKind::clamped || h.support == SupportKind::soft_clamped;
      CHECK(std::abs(is_clamped ? even.rotation.x : even.moments.xx) <= 1e-12);
      const bool is_hard =
          h.support == SupportKind::clamped || h.support == SupportKind::hard_support;
      CHECK(std::abs(is_hard ? odd.rotation.y : odd.moments.xy) <= 1e-12);
    }
  }

  TEST_CASE("the layer at a soft and at a free edge of a half plane has its height and width") {
    const auto check_layer = [](const HalfPlane& exact, double peak) {
      CHECK(exact.at({0, 0.25}).shear.y == doctest::Approx(peak).epsilon(1e-6));
      const SolvedPlate quads = solved(exact, Cells::quads);
      CHECK(profile_error(quads, peak) <= 5e-3);
      CHECK(relative_error(decay_length(quads, exact), exact_decay(exact)) <= 1e-2);
      const SolvedPlate triangles = solved(exact, Cells::triangles, true);
      CHECK(profile_error(triangles, peak) <= 1e-2);
      CHECK(relative_error(decay_length(triangles, exact), exact_decay(exact)) <= 1.5e-2);
    };
    check_layer(kSoft, 2.8392038);
    check_layer(kFree, -1.6214189);
  }

  TEST_CASE("all supports of a half plane give the closed form inside and at the edge") {
    for (const HalfPlane& exact : {kSoft, kFree, kHard, kClamped, kSoftClamped}) {
      CAPTURE(static_cast<int>(exact.support));
      const Errors error = errors_of(solved(exact, Cells::quads), exact);
      CHECK(error.w <= 3e-4);
      CHECK(error.rotation <= 4e-4);
      CHECK(error.moment <= 1e-3);
      CHECK(error.shear <= 5e-3);
    }
  }
}
