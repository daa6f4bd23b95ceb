#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "mesher/quads/quad_smooth.hpp"
#include "tests/mesher/quads/quad_fixtures.hpp"

// Boundary vertices that slide along their curves while the mesh is smoothed.

namespace {

using namespace anisofront;
using namespace anisofront::testing;

constexpr Index kSide = 4;

/// A square of 4 x 4 whose bottom is curve 0 and whose other sides are curve 1, a polyline; the
/// inner vertices of the bottom are shifted along it by 0.3.
struct SlideCase {
  Domain domain;
  MixedMesh mesh = quad_grid(kSide, kSide, [](Index, Index) { return false; });
  BackgroundMesh background = background_of([](Point) { return Metric{}; }, {-1, -1}, {6, 6});

  SlideCase() {
    domain.curves.push_back({"bottom", 1, make_line({0, 0}, {4, 0})});
    for (Index i = 1; i < kSide; ++i) mesh.vertices[i].p.x += 0.3;
    for (Index i = 0; i < kSide; ++i)
      mesh.segments.push_back(
          {i, i + 1, 0, mesh.vertices[i].p.x / 4, mesh.vertices[i + 1].p.x / 4, 0});
    fit(background, mesh);
  }

  QuadWork work(const std::vector<Index>& pinned) {
    QuadWork work(background, make_quad_mesh(mesh), {});
    work.allow_sliding(domain, mesh.segments, pinned);
    return work;
  }
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("shifted vertices of a straight side slide back and stay on it") {
    SlideCase slide;
    QuadWork work = slide.work({});
    for (int round = 0; round < 20; ++round)
      smooth_all(work, 4, {.first_step = 0.2, .last_step = 0.01});
    for (Index i = 1; i < kSide; ++i) {
      CHECK(work.mesh.vertices[i].p.y == 0);
      CHECK(std::fabs(work.mesh.vertices[i].p.x - i) < 0.03);
      CHECK(work.segments[i].parameter_a == work.segments[i - 1].parameter_b);
      CHECK(4 * work.segments[i].parameter_a == doctest::Approx(work.mesh.vertices[i].p.x));
    }
  }

  TEST_CASE("ends of curves and pinned vertices do not slide") {
    SlideCase slide;
    QuadWork work = slide.work({2});
    CHECK(!work.may_slide(0));
    CHECK(work.may_slide(1));
    CHECK(!work.may_slide(2));
    CHECK(work.may_slide(3));
    CHECK(!work.may_slide(kSide));
    CHECK(!work.may_slide(6));  // inside
    smooth_all(work, 8, {});
    CHECK(work.mesh.vertices[2].p == slide.mesh.vertices[2].p);
    CHECK(work.mesh.vertices[0].p == Point{0, 0});
  }

  TEST_CASE("vertices of an interface do not slide") {
    SlideCase slide;
    MixedMesh& mesh = slide.mesh;
    slide.domain.curves.push_back({"interface", 2, make_line({0, 2}, {4, 2})});
    for (Index i = 0; i < kSide; ++i)
      mesh.segments.push_back({10 + i, 11 + i, 1, 0.25 * i, 0.25 * (i + 1), 0, 0});
    const QuadWork work = slide.work({});
    for (Index v = 10; v <= 14; ++v) CHECK(!work.may_slide(v));
    CHECK(work.may_slide(1));
  }
}
