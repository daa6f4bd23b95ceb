#include "mesher/quads/recut.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/metric/quality.hpp"

namespace anisofront {
namespace {

constexpr double kInverted = 20;

double triangle_cost(const WorkVertex& a, const WorkVertex& b, const WorkVertex& c) {
  const double alpha = least_alpha(a, b, c);
  return alpha > 0 ? -2 * std::log(alpha) : kInverted * (1 - alpha);
}

double quad_cost(const std::array<WorkVertex, 4>& v) {
  const double quality =
      beta(std::array{v[0].r, v[1].r, v[2].r, v[3].r}, std::array{v[0].p, v[1].p, v[2].p, v[3].p});
  if (quality > 0) return -std::log(quality);
  const double least = std::min({least_alpha(v[3], v[0], v[1]), least_alpha(v[0], v[1], v[2]),
                                 least_alpha(v[1], v[2], v[3]), least_alpha(v[2], v[3], v[0])});
  return kInverted * (1 - least);
}

/// The two new faces, both beginning at the new edge.
struct Cut {
  MixedFace triangle, quad;
};

Cut cut_of(const FaceLinks& links, const std::array<Index, 5>& outer) {
  std::array<Index, 5> v;
  std::transform(outer.begin(), outer.end(), v.begin(), [&](Index h) { return links.from(h); });
  return {{{v[0], v[1], v[2], kNoIndex}}, {{v[0], v[2], v[3], v[4]}}};
}

/// Keeps the cut whose triangle has outer[s] and outer[s + 1] if it is allowed and the cheapest.
void consider(const FaceLinks& links, const std::vector<WorkVertex>& vertices,
              std::array<Index, 5> outer, std::size_t s, Recut& best, Index triangle, Index quad) {
  std::rotate(outer.begin(), outer.begin() + static_cast<std::ptrdiff_t>(s), outer.end());
  const Cut cut = cut_of(links, outer);
  // A vertex that comes twice in the pentagon is joined with its neighbours there, so that this
  // also keeps it from coming twice in a face.
  if (is_joined(links, outer[0], cut.triangle.vertices[2])) return;
  const double cost = face_cost(vertices, cut.triangle) + face_cost(vertices, cut.quad);
  if (!best.possible() || cost < best.cost) best = {triangle, quad, outer, cost};
}

}  // namespace

double face_cost(const std::vector<WorkVertex>& vertices, const MixedFace& face) {
  const auto& [a, b, c, d] = face.vertices;
  return face.is_quad() ? quad_cost({vertices[a], vertices[b], vertices[c], vertices[d]})
                        : triangle_cost(vertices[a], vertices[b], vertices[c]);
}

Recut best_recut(const FaceLinks& links, const std::vector<WorkVertex>& vertices, Index triangle,
                 Index quad, Index goal) {
  Recut best;
  for (Index inner = 4 * triangle; inner < 4 * triangle + 3; ++inner) {
    if (links.across(inner) != quad) continue;  // two sides are shared round an inner vertex
    const Index side = links.next(links.twin[inner]);
    const std::array<Index, 5> outer{links.previous(inner), side, links.next(side),
                                     links.next(links.next(side)), links.next(inner)};
    for (std::size_t exit = 1; exit <= 3; ++exit) {
      if (links.across(outer[exit]) != goal) continue;
      consider(links, vertices, outer, exit, best, triangle, quad);
      consider(links, vertices, outer, exit - 1, best, triangle, quad);
    }
  }
  return best;
}

void apply(FaceLinks& links, const Recut& recut) {
  const Cut cut = cut_of(links, recut.outer);
  const Index t = 4 * recut.quad, q = 4 * recut.triangle;  // they change places
  renumber(links, recut.outer, std::array<Index, 5>{t, t + 1, q + 1, q + 2, q + 3});
  join(links, t + 2, q);
  links.faces[recut.quad] = cut.triangle;
  links.faces[recut.triangle] = cut.quad;
}

void merge(FaceLinks& links, Index first, Index second) {
  const Index h = side_towards(links, first, second), g = links.twin[h];
  const std::array<Index, 4> sides{links.previous(h), links.next(g), links.previous(g),
                                   links.next(h)};
  const MixedFace quad{
      {links.from(sides[0]), links.from(sides[1]), links.from(sides[2]), links.from(sides[3])}};
  renumber(links, sides,
           std::array<Index, 4>{4 * first, 4 * first + 1, 4 * first + 2, 4 * first + 3});
  links.faces[first] = quad;
  links.faces[second] = {};
}

}  // namespace anisofront
