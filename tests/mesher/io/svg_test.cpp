#include "mesher/io/svg.hpp"

#include <doctest/doctest.h>

#include "io_support.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::string drawn(const Mesh& mesh, const SvgOptions& options = {}) {
  const Scratch scratch;
  write_svg(scratch / "m.svg", mesh, options);
  return contents(scratch / "m.svg");
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a drawing has one tint per region and one dark path per tag") {
    Mesh mesh = small_file().mesh;
    mesh.required_vertices = {2, 5};
    const std::string svg = drawn(mesh);
    CHECK(occurrences(svg, "<path fill=\"#") == 2);
    CHECK(occurrences(svg, "<path d=\"") == 3);  // mesh edges, tags 10 and 11
    CHECK(occurrences(svg, "<circle") == 2);
    CHECK(contains(svg, "<title>the wall</title>"));
    CHECK(contains(svg, "<title>left part</title>"));
  }

  TEST_CASE("the drawing fits its margins with y upwards") {
    // Width 1000 with margins of 20: 480 pixels per unit of the 2 x 1 mesh.
    const std::string svg = drawn(small_file().mesh);
    CHECK(contains(svg, "width=\"1000\" height=\"520\""));
    CHECK(contains(svg, "M20 500L500 500L500 20Z"));  // triangle (0,0) (1,0) (1,1)
    CHECK(contains(drawn(small_file().mesh, {.width = 500}), "width=\"500\" height=\"260\""));
  }

  TEST_CASE("every mesh edge is drawn once and curve edges in one go") {
    const std::string svg = drawn(small_file().mesh);
    const std::size_t start = svg.find("<path d=\"");
    const std::string edges = svg.substr(start, svg.find("/>", start) - start);
    CHECK(occurrences(edges, "M") == 8);
    CHECK(contains(svg, "M20 500L500 500\nL980 500\n"));  // the two edges of tag 10
  }

  TEST_CASE("lines get thinner with the number of elements") {
    Mesh fine;
    for (Index k = 0; k <= 5000; ++k)
      fine.points.insert(fine.points.end(), {{k / 5000.0, 0}, {k / 5000.0, 1}});
    for (Index k = 0; k < 10000; k += 2)
      fine.triangles.insert(fine.triangles.end(), {{k, k + 2, k + 3}, {k, k + 3, k + 1}});
    fine.triangle_regions.assign(fine.triangles.size(), 1);
    const auto width = [](const std::string& svg) {
      const std::string key = "stroke-width=\"";
      return std::stod(svg.substr(svg.find(key) + key.size()));
    };
    CHECK(width(drawn(fine)) < 0.5 * width(drawn(small_file().mesh)));
  }

  TEST_CASE("empty and flat meshes are drawn and endless ones refused") {
    CHECK(contains(drawn(Mesh{}), "</svg>"));
    Mesh line;
    line.points = {{0, 0}, {0, 2}};
    line.edges = {{{0, 1}, 1, 0, {0, 0}}};
    CHECK(contains(drawn(line), "M20 980L20 20"));
    Mesh endless;
    endless.points = {{-1e308, 0}, {1e308, 0}};
    CHECK(contains(message_of([&] { drawn(endless); }), "bounding box"));
  }
}
