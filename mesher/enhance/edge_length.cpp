#include "mesher/enhance/edge_length.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/enhance/collapse.hpp"
#include "mesher/enhance/split.hpp"

namespace anisofront {
namespace {

struct Edge {
  double length;
  Index a, b;
  Index triangle;
};

bool shorter(const Edge& e, const Edge& f) {
  if (e.length != f.length) return e.length < f.length;
  return e.a != f.a ? e.a < f.a : e.b < f.b;
}

}  // namespace

void collapse_and_split(Patch& patch, const EdgeLengthOptions& options) {
  std::vector<Edge> short_edges, long_edges;
  for (Index t = 0; t < static_cast<Index>(patch.mesh.triangles.size()); ++t) {
    const WorkTriangle& triangle = patch.mesh.triangles[t];
    if (triangle.dead()) continue;
    for (int k = 0; k < 3; ++k) {
      if (triangle.neighbours[k] < t) continue;
      const Index a = triangle.vertices[kNext[k]], b = triangle.vertices[kPrevious[k]];
      const double l = edge_length(patch.vertex(a), patch.vertex(b));
      if (l < options.shortest) short_edges.push_back({l, a, b, t});
      if (l > options.longest) long_edges.push_back({l, a, b, t});
    }
  }
  std::sort(short_edges.begin(), short_edges.end(), shorter);
  std::sort(long_edges.begin(), long_edges.end(),
            [](const Edge& e, const Edge& f) { return shorter(f, e); });
  for (const Edge& e : short_edges)
    if (!collapse(patch, e.a, e.b, options.collapsed_longest, options.collapsed_alpha))
      collapse(patch, e.b, e.a, options.collapsed_longest, options.collapsed_alpha);
  for (const Edge& e : long_edges) split(patch, e.a, e.b, e.length, e.triangle);
}

}  // namespace anisofront
