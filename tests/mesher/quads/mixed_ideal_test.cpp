#include "mesher/quads/mixed_ideal.hpp"

#include <doctest/doctest.h>

#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

using IdealPlace = Point (*)(const BackgroundMesh&, const MixedMesh&, Index,
                             std::span<const Corner>);

/// Ideal place of vertex 0, which lies in all faces; sizes 1 by 1 or, with `stretch`, of x only.
Point ideal(IdealPlace place, const std::vector<Point>& points, const std::vector<MixedFace>& faces,
            double stretch = 1) {
  const auto metric = background(
      [stretch](Point) {
        return metric_from_sizes(stretch, 1, {1, 0});
      },
      {-9, -9}, {9, 9});
  MixedMesh mesh = mixed_mesh(points, faces);
  look_up_metrics(*metric, mesh);
  return place(*metric, mesh, 0, face_stars(mesh)[0]);
}

bool near(Point p, Point q) { return norm(p - q) < 1e-9; }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("length smoothing puts a vertex at unit distance from the next vertex of a triangle") {
    CHECK(near(ideal(ideal_place_by_lengths, {{-2, 0}, {1, 0}, {1, 5}}, {triangle(0, 1, 2)}),
               {0, 0}));
    CHECK(near(ideal(ideal_place_by_lengths, {{0.8, 0}, {1, 0}, {1, 5}}, {triangle(0, 1, 2)}),
               {0, 0}));
    CHECK(near(ideal(ideal_place_by_lengths, {{-2, 0}, {1, 0}, {1, 5}}, {triangle(0, 1, 2)}, 4),
               {-3, 0}));
  }

  TEST_CASE("the opposite corner of a quadrilateral is to lie a diagonal away") {
    // (0, 0) for Q; T = (0, 3) is 4 away and is to be sqrt2 away: (-1, 3 - 1) direction (0, -1).
    const Point p =
        ideal(ideal_place_by_lengths, {{0, -1}, {1, -1}, {0, 3}, {-1, 2}}, {quad(0, 1, 2, 3)});
    CHECK(near(p, {0, 0.5 * (-1 + 3 - 1.4142135623730951)}));
  }

  TEST_CASE("every face round a vertex takes part with equal weight") {
    // Neighbours to the right and on the left, both to be a unit away.
    const Point p = ideal(ideal_place_by_lengths, {{0, 0}, {3, 0}, {0, 4}, {-1, 0}},
                          {triangle(0, 1, 2), triangle(0, 3, 2)});
    CHECK(near(p, {0.5 * (2 + 0), 0}));
  }

  TEST_CASE("quality smoothing builds a unit equilateral triangle on the outer edge") {
    const std::vector<Point> points{{3, 4}, {0, 0}, {2, 0}};
    CHECK(
        near(ideal(ideal_place_by_shapes, points, {triangle(0, 1, 2)}), {0.5, 0.8660254037844386}));
    CHECK(near(ideal(ideal_place_by_shapes, points, {triangle(0, 1, 2)}, 4),
               {2, 0.8660254037844386}));
  }

  TEST_CASE("quality smoothing builds unit squares on both outer edges") {
    CHECK(near(
        ideal(ideal_place_by_shapes, {{0.3, -0.2}, {1, 0}, {1, 1}, {0, 1}}, {quad(0, 1, 2, 3)}),
        {0, 0}));
    // With Q = (2, -1) the edge QT is (-1, 2), a unit of it turned by 90 degrees
    // (-2, -1) / sqrt5; the other edge still names the origin.
    CHECK(near(
        ideal(ideal_place_by_shapes, {{0.3, -0.2}, {2, -1}, {1, 1}, {0, 1}}, {quad(0, 1, 2, 3)}),
        {1 - 1 / std::sqrt(5.), -0.5 - 0.5 / std::sqrt(5.)}));
    CHECK(near(
        ideal(ideal_place_by_shapes, {{0.3, -0.2}, {4, 0}, {4, 1}, {0, 1}}, {quad(0, 1, 2, 3)}, 4),
        {0, 0}));
  }
}
