#include "mesher/front/visibility.hpp"

#include <algorithm>

#include "mesher/background/alternating_digital_tree.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

/// The element under test, anticlockwise, with the numbers of its vertices.
struct Candidate {
  Point a, b, c;
  Index va, vb, vc;
  Box box;
};

/// Signs of an end point with respect to the three sides; 0 for the sides it is an end of.
struct Signs {
  bool own;  ///< the point is a vertex of the element
  int ab, bc, ca;
};

Signs signs_of(const Candidate& t, Index v, Point p) {
  const bool a = v == t.va, b = v == t.vb, c = v == t.vc && t.vc != kNoIndex;
  return {a || b || c, a || b ? 0 : orientation(t.a, t.b, p), b || c ? 0 : orientation(t.b, t.c, p),
          c || a ? 0 : orientation(t.c, t.a, p)};
}

bool inside(const Signs& s) { return !s.own && s.ab >= 0 && s.bc >= 0 && s.ca >= 0; }

bool blocks(const Candidate& t, const FrontEdge& edge) {
  const Box box{{std::min(edge.a.x, edge.b.x), std::min(edge.a.y, edge.b.y)},
                {std::max(edge.a.x, edge.b.x), std::max(edge.a.y, edge.b.y)}};
  if (!overlap(box, t.box)) return false;
  const Signs p = signs_of(t, edge.va, edge.a);
  if (inside(p)) return true;
  const Signs q = signs_of(t, edge.vb, edge.b);
  if (p.own && q.own) return false;
  if (inside(q)) return true;
  if ((p.ab < 0 && q.ab < 0) || (p.bc < 0 && q.bc < 0) || (p.ca < 0 && q.ca < 0)) return false;
  if (p.bc * q.bc < 0 && orientation(edge.a, edge.b, t.b) * orientation(edge.a, edge.b, t.c) < 0)
    return true;
  return p.ca * q.ca < 0 && orientation(edge.a, edge.b, t.c) * orientation(edge.a, edge.b, t.a) < 0;
}

}  // namespace

bool is_valid_element(const FrontEdge& base, const Apex& apex, const std::vector<FrontEdge>& edges,
                      std::vector<Index>& near) {
  if (orientation(base.a, base.b, apex.p) <= 0) return false;
  const Point a = base.a, b = base.b, c = apex.p;
  const Candidate t{a,
                    b,
                    c,
                    base.va,
                    base.vb,
                    apex.vertex,
                    {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                     {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}}};
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (!blocks(t, edges[near[i]])) continue;
    std::swap(near[i], near[i / 2]);
    std::swap(near[i / 2], near[0]);
    return false;
  }
  return true;
}

}  // namespace anisofront
