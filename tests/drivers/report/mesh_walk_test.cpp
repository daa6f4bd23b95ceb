#include "drivers/report/mesh_walk.hpp"

#include <doctest/doctest.h>

namespace anisofront {
namespace {

/// n x n unit squares; those left of `split` are halved into triangles.
Mesh lattice(Index n, Index split) {
  Mesh mesh;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      mesh.points.push_back({static_cast<double>(i), static_cast<double>(j)});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      if (i < split) mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      if (i >= split) mesh.quads.push_back({a, b, c, d});
    }
  return mesh;
}

double guessed(const VertexGuess& guess, const Mesh& mesh, double (*f)(Point)) {
  const auto value = [&](int i) { return f(mesh.points[guess.from[i]]); };
  return 0.5 * (guess.weight * value(0) + (4 - guess.weight) * value(1) - value(2) - value(3));
}

void check_order(const Mesh& mesh) {
  const std::vector<VertexGuess> walk = mesh_walk(mesh);
  REQUIRE(walk.size() == mesh.points.size());
  std::vector<int> place(walk.size(), -1);
  for (std::size_t i = 0; i < walk.size(); ++i) {
    REQUIRE(place[walk[i].vertex] == -1);
    place[walk[i].vertex] = static_cast<int>(i);
    for (const Index from : walk[i].from) {
      if (i == 0) CHECK(from == kNoIndex);
      if (i > 0) CHECK((from >= 0 && place[from] >= 0 && from != walk[i].vertex));
    }
  }
}

TEST_SUITE("unit") {
  TEST_CASE("A walk meets every vertex once and guesses from earlier ones") {
    for (const Index split : {0, 2, 5}) check_order(lattice(5, split));
  }

  TEST_CASE("A walk guesses linear functions exactly in regular meshes") {
    const auto plane = [](Point p) { return 3 + 2 * p.x - 5 * p.y; };
    for (const Index split : {0, 6}) {  // all quads, all triangles
      const Mesh mesh = lattice(6, split);
      const std::vector<VertexGuess> walk = mesh_walk(mesh);
      const std::size_t start = split == 0 ? 4 : 3;
      for (std::size_t i = start; i < walk.size(); ++i)
        CHECK(guessed(walk[i], mesh, plane) == doctest::Approx(plane(mesh.points[walk[i].vertex])));
    }
  }

  TEST_CASE("A walk reaches pieces that do not touch and vertices without element") {
    Mesh mesh = lattice(2, 1);
    const Index n = static_cast<Index>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), {{9, 9}, {10, 9}, {9, 10}, {20, 20}});
    mesh.triangles.push_back({n, n + 1, n + 2});
    check_order(mesh);
    CHECK(mesh_walk(mesh).back().vertex == n + 3);
    check_order(Mesh{});
  }

  TEST_CASE("A walk goes on where elements do not fit together") {
    Mesh mesh;
    mesh.points.resize(5);
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};  // two run through 0-1 alike
    check_order(mesh);
  }
}

}  // namespace
}  // namespace anisofront
