#include "adapt/flux_patches.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

std::vector<Index> patches_at(const FluxPatches& patches, Index vertex) {
  std::vector<Index> found;
  for (Index p = 0; p < patches.count(); ++p)
    if (patches.vertex[p] == vertex) found.push_back(p);
  return found;
}

Index size_of(const FluxPatches& patches, Index p) {
  return patches.first[p + 1] - patches.first[p];
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("inside one region each vertex has one patch and inner vertices close it") {
    const Mesh mesh = mixed_square(4, 4);
    const FeMesh fe = straight_fe_mesh(mesh);
    const FluxPatches patches = flux_patches(fe, {});
    CHECK(patches.count() == 25);
    for (Index p = 0; p < 25; ++p) {
      const Point x = mesh.points[patches.vertex[p]];
      CHECK(bool(patches.is_interior[p]) == (x.x > 0 && x.x < 1 && x.y > 0 && x.y < 1));
      for (Index i = patches.first[p]; i < patches.first[p + 1]; ++i) {
        const Element element = element_at(fe, patches.elements[i]);
        CHECK(std::count(element.vertices.begin(), element.vertices.begin() + element.corners,
                         patches.vertex[p]) == 1);
      }
    }
    // Every corner of every element is in one patch.
    CHECK(patches.elements.size() == 3 * mesh.triangles.size() + 4 * mesh.quads.size());
  }

  TEST_CASE("a vertex between two regions has an open patch in each") {
    const Mesh mesh = with_two_regions(square_mesh(4));
    const FluxPatches patches = flux_patches(straight_fe_mesh(mesh), {});
    const auto middle = patches_at(patches, 12);
    REQUIRE(middle.size() == 2);
    CHECK(size_of(patches, middle[0]) + size_of(patches, middle[1]) == 6);
    CHECK_FALSE(patches.is_interior[middle[0]]);
    CHECK_FALSE(patches.is_interior[middle[1]]);
    CHECK(patches.count() == 25 + 5);
  }

  TEST_CASE("a marked curve divides the patches along it but not at its end") {
    const Mesh mesh = with_middle_curve(square_mesh(4), 0.5);
    const FeMesh fe = straight_fe_mesh(mesh);
    std::vector<char> jumps(fe.edges.count(), 0);
    for (std::size_t i = 0; i < mesh.edges.size(); ++i)
      jumps[fe.edges.curve_edges[i]] = mesh.edges[i].tag == kMiddle;
    const FluxPatches patches = flux_patches(fe, jumps);
    CHECK(patches_at(patches, 2).size() == 2);   // (0.5, 0)
    CHECK(patches_at(patches, 7).size() == 2);   // (0.5, 0.25)
    CHECK(patches_at(patches, 12).size() == 1);  // (0.5, 0.5), the end
    CHECK_FALSE(patches.is_interior[patches_at(patches, 12)[0]]);
    CHECK(patches.is_interior[patches_at(patches, 17)[0]]);
  }

  TEST_CASE("two elements that touch in a vertex only are two patches") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    const FluxPatches patches = flux_patches(straight_fe_mesh(mesh), {});
    CHECK(patches_at(patches, 0).size() == 2);
    CHECK(grown_patch(patches, patches_at(patches, 0)[0], 3) == std::vector<Index>{0});
  }

  TEST_CASE("a patch grows ring by ring within its region") {
    const Mesh mesh = with_two_regions(square_quads(4, 4));
    const FluxPatches patches = flux_patches(straight_fe_mesh(mesh), {});
    const Index corner = patches_at(patches, 0)[0];
    CHECK(grown_patch(patches, corner, 0) == std::vector<Index>{0});
    CHECK(grown_patch(patches, corner, 1) == std::vector<Index>{0, 1, 4, 5});
    CHECK(grown_patch(patches, corner, 2) == std::vector<Index>{0, 1, 4, 5, 8, 9});
    CHECK(grown_patch(patches, corner, 9).size() == 8);
  }
}
