#include "adapt/flux_patches.hpp"

#include <algorithm>

#include "adapt/edge_sides.hpp"
#include "solver/space/disjoint_sets.hpp"

namespace anisofront {
namespace {

/// Two corners at one vertex whose elements share an edge.
struct CornerLink {
  Index a, b;
};

std::vector<CornerLink> corner_links(const FeMesh& mesh, const std::vector<char>& jumps) {
  const EdgeSides sides = edge_sides(mesh);
  std::vector<CornerLink> links;
  links.reserve(2 * sides.size());
  for (std::size_t e = 0; e < sides.size(); ++e) {
    const auto& [first, second] = sides[e];
    if (second.element == kNoIndex || (!jumps.empty() && jumps[e])) continue;
    const Element a = element_at(mesh, first.element), b = element_at(mesh, second.element);
    if (a.region != b.region) continue;
    const auto corner = [](const Element& element, int k) {
      return 4 * element.number + k % element.corners;
    };
    // Neighbours run through their edge in opposite directions.
    links.push_back({corner(a, first.side), corner(b, second.side + 1)});
    links.push_back({corner(a, first.side + 1), corner(b, second.side)});
  }
  return links;
}

/// Elements of each patch, by counting.
void set_elements(Index elements, const FeMesh& mesh, FluxPatches& patches) {
  const auto for_corners = [&](const auto& body) {
    for (Index e = 0; e < elements; ++e)
      for (int k = 0; k < (e < static_cast<Index>(mesh.mesh.triangles.size()) ? 3 : 4); ++k)
        body(patches.at_corner[e][k], e);
  };
  patches.first.assign(patches.vertex.size() + 1, 0);
  for_corners([&](Index p, Index) { ++patches.first[p + 1]; });
  std::partial_sum(patches.first.begin(), patches.first.end(), patches.first.begin());
  patches.elements.resize(patches.first.back());
  std::vector<Index> next(patches.first.begin(), patches.first.end() - 1);
  for_corners([&](Index p, Index e) { patches.elements[next[p]++] = e; });
}

/// Numbers the sets and names the patch of each corner.
void number_patches(const FeMesh& mesh, DisjointSets& sets, FluxPatches& patches) {
  const Index elements = mesh.element_count();
  patches.at_corner.assign(elements, {kNoIndex, kNoIndex, kNoIndex, kNoIndex});
  for (Index e = 0; e < elements; ++e) {
    const Element element = element_at(mesh, e);
    for (int k = 0; k < element.corners; ++k) {
      const Index root = sets.find(4 * e + k);
      if (root == 4 * e + k) {
        patches.at_corner[e][k] = patches.count();
        patches.vertex.push_back(element.vertices[k]);
      } else {
        patches.at_corner[e][k] = patches.at_corner[root / 4][root % 4];
      }
    }
  }
}

}  // namespace

FluxPatches flux_patches(const FeMesh& mesh, const std::vector<char>& jumps) {
  const std::vector<CornerLink> links = corner_links(mesh, jumps);
  // Corner k of element e has number 4 e + k.
  DisjointSets sets(4 * static_cast<std::size_t>(mesh.element_count()));
  for (const auto& [a, b] : links) sets.unite(a, b);
  FluxPatches patches;
  number_patches(mesh, sets, patches);
  set_elements(mesh.element_count(), mesh, patches);

  // An open fan of n elements has n - 1 links, a closed one n.
  std::vector<Index> closing(patches.vertex.size(), 0);
  for (const auto& [a, b] : links) ++closing[patches.at_corner[a / 4][a % 4]];
  for (Index p = 0; p < patches.count(); ++p)
    patches.is_interior.push_back(closing[p] == patches.first[p + 1] - patches.first[p]);
  return patches;
}

std::vector<Index> grown_patch(const FluxPatches& patches, Index p, int rings) {
  const auto elements_of = [&](Index q) {
    return std::span(patches.elements)
        .subspan(patches.first[q], patches.first[q + 1] - patches.first[q]);
  };
  std::vector<Index> elements(elements_of(p).begin(), elements_of(p).end());
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<Index> grown;
    for (const Index e : elements)
      for (const Index q : patches.at_corner[e])
        if (q != kNoIndex) grown.insert(grown.end(), elements_of(q).begin(), elements_of(q).end());
    std::sort(grown.begin(), grown.end());
    grown.erase(std::unique(grown.begin(), grown.end()), grown.end());
    elements = std::move(grown);
  }
  return elements;
}

}  // namespace anisofront
