#include "mesher/front/boundary_parts.hpp"

#include <doctest/doctest.h>

#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

Domain with_embedded(Domain domain, const std::vector<NurbsCurve>& curves) {
  for (const NurbsCurve& curve : curves)
    domain.regions[0].embedded_curves.push_back(
        add_curve(domain, "e" + std::to_string(domain.curves.size()), 9, curve));
  return domain;
}

/// Per curve of the domain, the parts on the left and right of its segments; all must agree.
std::vector<std::array<Index, 2>> parts_per_curve(const Domain& domain, Index& count) {
  const auto metric = [](Point) { return metric_from_size(0.15); };
  WorkCase work(domain, metric, {-3, -3}, {3, 3});
  const BoundaryParts parts = find_parts(work.mesh());
  count = parts.count;
  constexpr Index kUnset = -9;
  std::vector<std::array<Index, 2>> of_curve(domain.curves.size(), {kUnset, kUnset});
  for (std::size_t s = 0; s < work.mesh().segments.size(); ++s) {
    auto& known = of_curve[work.mesh().segments[s].curve];
    if (known[0] == kUnset) known = parts.of_segment[s];
    CHECK(known == parts.of_segment[s]);
  }
  return of_curve;
}

}  // namespace

TEST_SUITE("unit") {
  using Sides = std::vector<std::array<Index, 2>>;

  TEST_CASE("an uncut region is one part with its holes and slits") {
    Domain domain = with_embedded(
        square_domain(1), {make_line({0.2, 0.2}, {0.4, 0.3}), make_line({0, 0.5}, {0.2, 0.5})});
    const Index hole = add_curve(domain, "hole", 8, make_circle({0.7, 0.7}, 0.2));
    domain.regions[0].loops.push_back({{hole, true}});
    Index count = 0;
    CHECK(parts_per_curve(domain, count) ==
          Sides{{0, -1}, {0, -1}, {0, -1}, {0, -1}, {0, 0}, {0, 0}, {-1, 0}});
    CHECK(count == 1);
  }

  TEST_CASE("an embedded curve from side to side cuts a region in two") {
    const Domain domain = with_embedded(square_domain(1), {make_line({0, 0}, {1, 1})});
    Index count = 0;
    CHECK(parts_per_curve(domain, count) == Sides{{0, -1}, {0, -1}, {1, -1}, {1, -1}, {1, 0}});
    CHECK(count == 2);
  }

  TEST_CASE("embedded loops lie in the part that encloses them most closely") {
    // Circles in circles; a slit between the two, one in the inner one and a free cross outside.
    const Domain domain = with_embedded(
        square_domain(2), {make_circle({1, 1}, 0.8), make_circle({1, 1}, 0.3),
                           make_line({0.4, 1}, {0.5, 1.1}), make_line({0.9, 1}, {1.1, 1}),
                           make_line({0.1, 0.1}, {0.2, 0.2}), make_line({0.2, 0.2}, {0.3, 0.1})});
    Index count = 0;
    CHECK(
        parts_per_curve(domain, count) ==
        Sides{{0, -1}, {0, -1}, {0, -1}, {0, -1}, {1, 0}, {2, 1}, {1, 1}, {2, 2}, {0, 0}, {0, 0}});
    CHECK(count == 3);
  }

  TEST_CASE("loops that meet in a point are parts of their own") {
    const std::vector<Point> p{{1, 1}, {1.5, 0.8}, {1.5, 1.2}, {0.5, 1.2}, {0.5, 0.8}};
    const Domain domain = with_embedded(
        square_domain(2), {make_line(p[0], p[1]), make_line(p[1], p[2]), make_line(p[2], p[0]),
                           make_line(p[0], p[3]), make_line(p[3], p[4]), make_line(p[4], p[0])});
    Index count = 0;
    const Sides sides = parts_per_curve(domain, count);
    CHECK(count == 3);
    for (Index c = 4; c < 7; ++c) CHECK(sides[c] == std::array<Index, 2>{1, 0});
    for (Index c = 7; c < 10; ++c) CHECK(sides[c] == std::array<Index, 2>{2, 0});
  }

  TEST_CASE("an edge with the same part on both sides counts twice") {
    BoundaryParts parts;
    parts.count = 3;
    parts.of_segment = {{0, kNoIndex}, {0, 1}, {1, 1}, {kNoIndex, 2}, {2, 2}};
    CHECK(odd_parts(parts) == std::vector<Index>{1, 2});
  }
}
