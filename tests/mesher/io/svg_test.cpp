#include "mesher/io/svg.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "io_support.hpp"
#include "mesher/io/svg_key.hpp"
#include "mesher/io/svg_outline.hpp"

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

SvgOptions scaled() {
  SvgOptions options;
  options.has_scale = true;
  return options;
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

  TEST_CASE("the scale bar has a round length in the scale of the mesh") {
    // Width 1000 with margins of 20: 480 pixels per unit of the 2 x 1 mesh; a quarter is 0.5.
    const std::string svg = drawn(small_file().mesh, scaled());
    CHECK(contains(svg, "height=\"585\""));  // 520 and the key
    const std::string bar = svg.substr(svg.find("class=\"scale\""));
    CHECK(contains(bar, " x=\"20\""));
    CHECK(contains(bar, " width=\"240\" height=\"5\""));
    CHECK(contains(bar, ">0.5</text>"));
  }

  TEST_CASE("round lengths are 1 2 or 5 times a power of ten") {
    const std::vector<std::pair<double, double>> cases{
        {0.25, 0.2}, {0.5, 0.5}, {0.499, 0.2}, {1, 1}, {0.99, 0.5}, {7e-9, 5e-9}, {3e7, 2e7}};
    for (const auto& [length, expected] : cases)
      CHECK(round_length(length) == doctest::Approx(expected).epsilon(1e-12));
  }

  TEST_CASE("a window shows a part at its own scale") {
    SvgOptions options = scaled();
    options.window = PlaneWindow{{1.2, 0.2}, {1.7, 0.7}};
    const std::string svg = drawn(small_file().mesh, options);
    CHECK(contains(svg, "width=\"1000\" height=\"1065\""));
    CHECK(contains(svg, "clip-path=\"url(#window)\""));
    // Of the elements only those that reach into the window.
    CHECK(occurrences(svg, "Z\n") < occurrences(drawn(small_file().mesh), "Z\n"));
    CHECK(contains(svg, "<title>the wall</title>"));
    CHECK(contains(svg, ">0.1</text>"));
    CHECK(contains(svg, " width=\"192\" height=\"5\""));  // 0.1 of 0.5 on 960 pixels
  }

  TEST_CASE("a framed part is marked at its place") {
    SvgOptions options;
    options.framed = PlaneWindow{{0.5, 0.25}, {1, 0.5}};
    CHECK(contains(drawn(small_file().mesh, options),
                   "x=\"260\" y=\"260\" width=\"240\" height=\"120\""));
  }

  TEST_CASE("tall meshes stand in the middle of a drawing that is not too high") {
    Mesh column;
    column.points = {{0, 0}, {1, 0}, {1, 6}};
    column.triangles = {{0, 1, 2}};
    column.triangle_regions = {1};
    SvgOptions options;
    options.highest = 1.5;
    // 6 units on 1.5 * 960 pixels: 240 per unit, 360 blank pixels on both sides.
    const std::string svg = drawn(column, options);
    CHECK(contains(svg, "height=\"1480\""));
    CHECK(contains(svg, "M380 1460L620 1460L620 20Z"));
  }

  TEST_CASE("values colour the elements from the least to the greatest") {
    const Mesh mesh = small_file().mesh;
    SvgOptions options;
    options.values.assign(mesh.triangles.size() + mesh.quads.size(), 2);
    options.values.front() = -1;
    options.values_name = "T<1>";
    const std::string svg = drawn(mesh, options);
    CHECK(contains(svg, "<path fill=\"#440154\" d=\"M20 500L500 500L500 20Z\n\"/>"));
    const std::string yellow = svg.substr(svg.find("<path fill=\"#fde725\""));
    CHECK(occurrences(yellow.substr(0, yellow.find("/>")), "Z") == options.values.size() - 1);
    CHECK(contains(svg, ">T&lt;1&gt;:   -1</text>"));
    CHECK(contains(svg, ">2</text>"));
    CHECK(occurrences(svg, "<rect") == 1 + 16);
  }

  TEST_CASE("values that are not finite leave their element white") {
    const Mesh mesh = small_file().mesh;
    SvgOptions options;
    options.values.assign(mesh.triangles.size() + mesh.quads.size(), 1e-300);
    options.values[0] = std::nan("");
    options.values[1] = HUGE_VAL;
    CHECK(occurrences(drawn(mesh, options), "Z\n") == options.values.size() - 2);
    options.values.assign(options.values.size(), std::nan(""));
    CHECK_FALSE(contains(drawn(mesh, options), "class=\"colours\""));
    options.values.pop_back();
    CHECK(contains(message_of([&] { drawn(mesh, options); }), "values for"));
  }

  TEST_CASE("elements of a class share an outline without the edges between them") {
    const Mesh mesh = small_file().mesh;  // two triangles of a square and a quad beside it
    const auto same = class_outlines(mesh, std::vector<Index>{4, 4, 4});
    REQUIRE(same.size() == 1);
    CHECK(same.at(4) == Loops{{0, 1, 4, 5, 2, 3}});
    const auto parts = class_outlines(mesh, std::vector<Index>{0, 7, kNoIndex});
    CHECK(parts.at(0) == Loops{{0, 1, 2}});
    CHECK(parts.at(7) == Loops{{0, 2, 3}});
    CHECK(class_outlines(Mesh{}, {}).empty());
  }

  TEST_CASE("outlines with a hole or a pinch have a loop each") {
    // 3 x 3 squares; the middle one is of another class, then the two at opposite corners of it.
    Mesh mesh;
    for (Index j = 0; j < 4; ++j)
      for (Index i = 0; i < 4; ++i) mesh.points.push_back({double(i), double(j)});
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < 3; ++i) {
        const Index a = 4 * j + i;
        mesh.quads.push_back({a, a + 1, a + 5, a + 4});
      }
    std::vector<Index> classes(9, 0);
    classes[4] = 1;
    const Loops ring = class_outlines(mesh, classes).at(0);
    REQUIRE(ring.size() == 2);
    CHECK(ring[0].size() == 12);
    CHECK(ring[1] == std::vector<Index>{5, 9, 10, 6});  // clockwise: the ring lies on its left
    const Loops corners = class_outlines(mesh, std::vector<Index>{1, 0, 0, 0, 1, 0, 0, 0, 1}).at(1);
    std::size_t vertices = 0;
    for (const auto& loop : corners) vertices += loop.size();
    CHECK(vertices == 12);
  }
}
