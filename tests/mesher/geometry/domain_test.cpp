#include "mesher/geometry/domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

constexpr double kPi = std::numbers::pi;

Index add_curve(Domain& domain, const std::string& name, NurbsCurve curve) {
  const auto index = static_cast<Index>(domain.curves.size());
  domain.curves.push_back({name, index + 1, std::move(curve)});
  return index;
}

/// The sides bottom, right, top, left of [0, width] x [0, height]; two run against the loop.
Domain rectangle_curves(double width, double height) {
  Domain domain;
  add_curve(domain, "bottom", make_line({0, 0}, {width, 0}));
  add_curve(domain, "right", make_line({width, height}, {width, 0}));
  add_curve(domain, "top", make_line({0, height}, {width, height}));
  add_curve(domain, "left", make_line({0, height}, {0, 0}));
  return domain;
}

Domain square_with_hole(Point centre) {
  Domain domain = rectangle_curves(10, 10);
  const Index hole = add_curve(domain, "hole", make_circle(centre, 1));
  add_region(domain, "plate", 1, {0, 1, 2, 3}, {{hole}});
  return domain;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("curves in any order and direction close into one loop") {
    Domain domain = rectangle_curves(3, 2);
    const std::vector<Loop> loops = chain_loops(domain, {2, 0, 3, 1});
    REQUIRE(loops.size() == 1);
    CHECK(loops[0] == Loop{{2, false}, {1, false}, {0, true}, {3, true}});
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(end_point(domain, loops[0][i]) == start_point(domain, loops[0][(i + 1) % 4]));
    CHECK(signed_area(domain, loops[0]) == -6);
  }

  TEST_CASE("closed curves are loops alone and separate loops stay separate") {
    Domain domain = rectangle_curves(3, 2);
    add_curve(domain, "circle", make_circle({1, 1}, 0.5));
    const std::vector<Loop> loops = chain_loops(domain, {4, 3, 2, 1, 0});
    REQUIRE(loops.size() == 2);
    CHECK(loops[0] == Loop{{4, false}});
    CHECK(loops[1].size() == 4);
  }

  TEST_CASE("two curves between the same two points close into a loop") {
    Domain domain;
    add_curve(domain, "arc", make_arc({0, 0}, 1, 0, kPi));
    add_curve(domain, "chord", make_line({1, 0}, {-1, 0}));
    domain.curves[0].curve.points.back() = {-1, 0};
    const std::vector<Loop> loops = chain_loops(domain, {0, 1});
    REQUIRE(loops.size() == 1);
    CHECK(loops[0] == Loop{{0, false}, {1, true}});
    CHECK(signed_area(domain, loops[0]) == doctest::Approx(kPi / 2).epsilon(1e-10));
  }

  TEST_CASE("ends within 1e-12 of the diagonal meet and others do not") {
    Domain near = rectangle_curves(1000, 1000);
    near.curves[1].curve.points[1].y = 1e-10;
    CHECK(chain_loops(near, {0, 1, 2, 3}).size() == 1);
    near.curves[1].curve.points[1].y = 1e-8;
    CHECK_THROWS_AS(chain_loops(near, {0, 1, 2, 3}), InputError);
  }

  TEST_CASE("an open loop is refused with the curve and the place") {
    const Domain domain = rectangle_curves(3, 2);
    CHECK_THROWS_WITH_AS(chain_loops(domain, {0, 2, 3}),
                         doctest::Contains("curve 'bottom' ends at (3, 0)"), InputError);
    CHECK_THROWS_WITH_AS(chain_loops(domain, {2}), doctest::Contains("open loop: curve 'top'"),
                         InputError);
  }

  TEST_CASE("three curve ends at one point are refused with the names of the curves") {
    Domain domain = rectangle_curves(3, 2);
    add_curve(domain, "diagonal", make_line({0, 0}, {3, 2}));
    CHECK_THROWS_WITH_AS(
        chain_loops(domain, {0, 1, 2, 3, 4}),
        doctest::Contains("3 curve ends ('bottom', 'left', 'diagonal') meet at (0, 0)"),
        InputError);
    CHECK_THROWS_WITH_AS(chain_loops(domain, {0, 17}), doctest::Contains("curve index 17"),
                         InputError);
  }

  TEST_CASE("areas of circles ellipses and parabola segments") {
    Domain domain;
    add_curve(domain, "circle", make_circle({100, 50}, 2));
    add_curve(domain, "ellipse", make_ellipse({0, 0}, 5, 0.01, 0.4));
    add_curve(domain, "parabola", {2, {0, 0, 0, 1, 1, 1}, {1, 1, 1}, {{-1, 1}, {0, -1}, {1, 1}}});
    add_curve(domain, "chord", make_line({1, 1}, {-1, 1}));
    CHECK(signed_area(domain, {{0, false}}) == doctest::Approx(4 * kPi).epsilon(1e-12));
    CHECK(signed_area(domain, {{0, true}}) == doctest::Approx(-4 * kPi).epsilon(1e-12));
    CHECK(signed_area(domain, {{1, false}}) == doctest::Approx(0.05 * kPi).epsilon(1e-10));
    CHECK(signed_area(domain, {{2, false}, {3, false}}) == doctest::Approx(4.0 / 3).epsilon(1e-13));
  }

  TEST_CASE("a circle far from the origin has its area to the rounding of the coordinates") {
    Domain domain;
    domain.curves.push_back({"circle", 1, make_circle({1e6, -1e6}, 1)});
    CHECK(signed_area(domain, {{0, false}}) == doctest::Approx(3.14159265358979).epsilon(1e-9));
  }

  TEST_CASE("a region turns its outer loop anticlockwise and its holes clockwise") {
    const Domain domain = square_with_hole({5, 5});
    validate(domain);
    const DomainRegion& region = domain.regions[0];
    REQUIRE(region.loops.size() == 2);
    CHECK(signed_area(domain, region.loops[0]) == 100);
    CHECK(signed_area(domain, region.loops[1]) == doctest::Approx(-kPi).epsilon(1e-12));
    CHECK(region.loops[1] == Loop{{4, true}});
  }

  TEST_CASE("a boundary that closes into several loops has its largest as the outer one") {
    Domain domain = rectangle_curves(10, 10);
    const Index hole = add_curve(domain, "hole", make_circle({5, 5}, 1));
    add_region(domain, "plate", 1, {hole, 0, 1, 2, 3}, {});
    validate(domain);
    CHECK(domain.regions[0].loops[0].size() == 4);
    CHECK(domain.regions[0].loops[1] == Loop{{hole, true}});
  }

  TEST_CASE("two regions share an interface in opposite directions") {
    Domain domain;
    add_curve(domain, "left", make_polyline(std::vector<Point>{{1, 0}, {0, 0}, {0, 1}, {1, 1}}));
    add_curve(domain, "right", make_polyline(std::vector<Point>{{1, 0}, {2, 0}, {2, 1}, {1, 1}}));
    add_curve(domain, "interface", make_line({1, 0}, {1, 1}));
    add_region(domain, "steel", 1, {0, 2}, {});
    add_region(domain, "copper", 2, {1, 2}, {});
    validate(domain);
    const auto use_of_interface = [&](std::size_t region) {
      const Loop& loop = domain.regions[region].loops[0];
      return *std::find_if(loop.begin(), loop.end(), [](CurveUse use) { return use.curve == 2; });
    };
    CHECK_FALSE(use_of_interface(0).reversed);
    CHECK(use_of_interface(1).reversed);
    CHECK(signed_area(domain, domain.regions[0].loops[0]) == 1);
    CHECK(signed_area(domain, domain.regions[1].loops[0]) == 1);
  }

  TEST_CASE("curves are found by name") {
    const Domain domain = rectangle_curves(1, 1);
    CHECK(find_curve(domain, "top") == 2);
    CHECK(find_curve(domain, "roof") == kNoIndex);
  }

  TEST_CASE("validation refuses what cannot be meshed and names it") {
    const auto refuse = [](Domain domain, const char* message) {
      CHECK_THROWS_WITH_AS(validate(domain), doctest::Contains(message), InputError);
    };
    const Domain good = square_with_hole({5, 5});
    validate(good);

    refuse(rectangle_curves(1, 1), "found no region");
    Domain bad = good;
    bad.curves[2].name = "left";
    refuse(bad, "two curves named 'left'");
    bad = good;
    bad.curves[2].tag = bad.curves[3].tag;  // a group of two curves
    CHECK_NOTHROW(validate(bad));
    bad = good;
    bad.curves[1].curve.weights[0] = 0;
    refuse(bad, "curve 'right': NURBS curve: weight 0 = 0");
    bad = good;
    bad.curves.push_back({"dot", 9, {1, {0, 0, 1, 1}, {1, 1}, {{3, 4}, {3, 4}}}});
    refuse(bad, "curve 'dot' at (3, 4) has zero length");
    bad = good;
    bad.curves[0].curve.points[1].x = std::numeric_limits<double>::infinity();
    refuse(bad, "curve 'bottom': NURBS curve: control point 1 = (inf, 0)");
    bad = good;
    bad.curves[0].curve.points[1].x = 9;
    refuse(bad, "'bottom' ends at (9, 0) but the next curve 'right' starts at (10, 0)");
    bad = good;
    bad.regions[0].loops[0].pop_back();
    refuse(bad, "open loop: curve 'top'");
    bad = good;
    bad.regions[0].loops[1][0].reversed = false;
    refuse(bad, "runs anticlockwise");
    bad = good;
    bad.regions[0].loops[0] = {{0, false}, {0, true}};
    refuse(bad, "encloses no area");
    bad = good;
    bad.regions[0].embedded_curves = {12};
    refuse(bad, "curve index 12");
    bad = good;
    bad.regions[0].loops.clear();
    refuse(bad, "found no loop");
    bad = good;
    bad.points = {{"load", 1, {1, 1}}, {"load", 2, {2, 2}}};
    refuse(bad, "two points named 'load'");
    bad.points = {{"load", 1, {1, 1}}, {"probe", 2, {2, 2}}, {"gauge", 3, {1, 1}}};
    refuse(bad, "points 'load' and 'gauge' both lie at (1, 1)");
    bad.points = {{"load", 1, {1, std::nan("")}}};
    refuse(bad, "point 'load': found (1, nan)");
    refuse(square_with_hole({12, 5}), "the hole through curve 'hole' from (13, 5) lies outside");
  }

  TEST_CASE("a region without boundary curves is refused") {
    Domain domain = rectangle_curves(1, 1);
    CHECK_THROWS_WITH_AS(add_region(domain, "plate", 1, {}, {}),
                         doctest::Contains("region 'plate': found no boundary curve"), InputError);
  }
}
