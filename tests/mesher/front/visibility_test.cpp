#include "mesher/front/visibility.hpp"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

FrontEdge edge(Index va, Point a, Index vb, Point b) {
  FrontEdge e;
  e.va = va;
  e.vb = vb;
  e.a = a;
  e.b = b;
  return e;
}

// The base runs from vertex 0 at the origin to vertex 1 at (2, 0); the apex (vertex 2 when it
// exists already) stands at (1, 2).
const FrontEdge kBase = edge(0, {0, 0}, 1, {2, 0});
const Point kApex{1, 2};

struct Configuration {
  std::string what;
  FrontEdge obstacle;
  bool valid_as_new, valid_as_vertex_2;
};

// Vertices 5 and above are foreign to the triangle.
const std::vector<Configuration> kTable = {
    {"far away", edge(5, {4, 0}, 6, {5, 1}), true, true},
    {"box overlaps but the edge passes by", edge(5, {2, 0.5}, 6, {1.5, 2}), true, true},
    {"crosses side BC only from outside", edge(5, {3, 1}, 6, {1.2, 0.5}), false, false},
    {"crosses both new sides", edge(5, {-1, 1}, 6, {3, 1}), false, false},
    {"one end inside", edge(5, {1, 1}, 6, {9, 9}), false, false},
    {"entirely inside", edge(5, {0.9, 0.5}, 6, {1.1, 0.5}), false, false},
    {"end touches side BC", edge(5, {1.5, 1}, 6, {4, 1}), false, false},
    {"end touches side CA", edge(5, {-3, 1}, 6, {0.5, 1}), false, false},
    {"end on the base", edge(5, {1, 0}, 6, {1, -1}), false, false},
    {"passes through a foreign vertex at the apex", edge(5, {1, 2}, 6, {1, 3}), false, false},
    {"crosses through the place of the apex", edge(5, {0, 2}, 6, {2, 2}), true, true},
    {"collinear with side BC beyond B", edge(5, {2.5, -1}, 6, {3, -2}), true, true},
    {"collinear with side BC beyond C", edge(5, {0.5, 3}, 6, {0, 4}), true, true},
    {"collinear with side BC and overlapping", edge(5, {1.75, 0.5}, 6, {1.25, 1.5}), false, false},
    {"leaves A to the outside", edge(0, {0, 0}, 6, {-1, 1}), true, true},
    {"leaves A into the triangle", edge(0, {0, 0}, 6, {1, 1}), false, false},
    {"leaves A through the triangle and side BC", edge(0, {0, 0}, 6, {3, 2}), false, false},
    {"leaves A along side CA but ends before C", edge(0, {0, 0}, 6, {0.5, 1}), false, false},
    {"leaves B below the base", edge(1, {2, 0}, 6, {1, -1}), true, true},
    {"arrives at B through side CA", edge(6, {-1, 1.5}, 1, {2, 0}), false, false},
    {"the other side of the base", edge(1, {2, 0}, 0, {0, 0}), true, true},
    {"leaves C upwards", edge(2, {1, 2}, 6, {1, 3}), false, true},
    {"leaves C into the triangle", edge(2, {1, 2}, 6, {1, 1}), false, false},
    {"is side BC already", edge(1, {2, 0}, 2, {1, 2}), false, true},
    {"is the other side of BC", edge(2, {1, 2}, 1, {2, 0}), false, true},
    {"is side CA already", edge(2, {1, 2}, 0, {0, 0}), false, true},
    {"double-sided edge that hangs into the triangle from A", edge(6, {1, 0.5}, 0, {0, 0}), false,
     false},
    {"double-sided edge that hangs from A to the outside", edge(6, {-1, 0}, 0, {0, 0}), true, true},
};

bool valid(const FrontEdge& base, const Apex& apex, const std::vector<FrontEdge>& edges) {
  std::vector<Index> near;
  for (std::size_t i = 0; i < edges.size(); ++i) near.push_back(static_cast<Index>(i));
  const bool result = is_valid_element(base, apex, edges, near);
  std::vector<Index> sorted = near;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) CHECK(sorted[i] == static_cast<Index>(i));
  return result;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE(
      "a front edge blocks the triangle exactly when it meets it apart from shared vertices") {
    for (const Configuration& c : kTable) {
      INFO(c.what);
      CHECK(valid(kBase, {kNoIndex, kApex}, {c.obstacle}) == c.valid_as_new);
      CHECK(valid(kBase, {2, kApex}, {c.obstacle}) == c.valid_as_vertex_2);
    }
  }

  TEST_CASE("the verdict does not depend on direction and rotation of the configuration") {
    // Turned by 90 degrees and shifted by integers: exact in doubles.
    const auto turned = [](Point p) { return Point{7 - p.y, p.x - 3}; };
    const FrontEdge base = edge(0, turned(kBase.a), 1, turned(kBase.b));
    for (const Configuration& c : kTable) {
      INFO(c.what);
      const FrontEdge& o = c.obstacle;
      const FrontEdge reverse = edge(o.vb, turned(o.b), o.va, turned(o.a));
      CHECK(valid(base, {kNoIndex, turned(kApex)}, {reverse}) == c.valid_as_new);
      CHECK(valid(base, {2, turned(kApex)}, {reverse}) == c.valid_as_vertex_2);
    }
  }

  TEST_CASE("the triangle must be anticlockwise to the last bit") {
    CHECK_FALSE(valid(kBase, {2, {1, -1}}, {}));
    CHECK_FALSE(valid(kBase, {2, {1, 0}}, {}));
    CHECK(valid(kBase, {2, {1, 1e-300}}, {}));
    const FrontEdge slanted = edge(0, {0.1, 0.1}, 1, {0.3, 0.3});
    CHECK_FALSE(valid(slanted, {2, {0.2, 0.2}}, {}));
    CHECK(valid(slanted, {2, {0.2, std::nextafter(0.2, 1.)}}, {}));
  }

  TEST_CASE("one blocking edge among many suffices and is moved forward") {
    std::vector<FrontEdge> edges;
    for (int i = 0; i < 20; ++i) edges.push_back(edge(10 + i, {5. + i, 0}, 40 + i, {5. + i, 1}));
    edges.push_back(edge(70, {-1, 1}, 71, {3, 1}));
    std::vector<Index> near;
    for (Index i = 0; i <= 20; ++i) near.push_back(i);
    CHECK_FALSE(is_valid_element(kBase, {kNoIndex, kApex}, edges, near));
    CHECK(std::find(near.begin(), near.end(), 20) - near.begin() < 11);
  }
}
