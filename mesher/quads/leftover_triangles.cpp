// In rounds: every triangle left grows a cell of nearest faces (breadth first); where two cells
// meet lies a shortest way between their triangles. The shortest ways whose cells are not yet taken
// are walked, which cannot disturb each other. A round is linear and ends with a small part of
// its triangles. At least one way is walked in each part that holds two triangles; the new edge of
// a recut can always be had, for of the two that serve one side of the pentagon only one can exist
// outside already: they would cross there.
#include "mesher/quads/leftover_triangles.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/quads/recut.hpp"

namespace anisofront {
namespace {

/// The faces nearest to each triangle, never across a segment.
struct Cells {
  std::vector<Index> triangle;  ///< per face: the triangle whose cell it lies in, or kNoIndex
  std::vector<Index> parent;    ///< per face: the next one on the way to it
  std::vector<Index> distance;  ///< per face: steps to it
};

/// Two adjacent faces in the cells of different triangles, `distance` steps from each other.
struct Meeting {
  Index distance = 0;
  Index first = kNoIndex, second = kNoIndex;
};

std::vector<Index> triangles_of(const MixedMesh& mesh) {
  std::vector<Index> triangles;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (mesh.faces[f].vertices[0] != kNoIndex && !mesh.faces[f].is_quad())
      triangles.push_back(static_cast<Index>(f));
  return triangles;
}

template <class Visit>
void for_each_neighbour(const FaceLinks& links, Index f, Visit&& visit) {
  for (Index h = 4 * f; h < 4 * f + links.faces[f].size(); ++h)
    if (!links.closed[h]) visit(links.across(h));
}

Cells grow_cells(const FaceLinks& links, const std::vector<Index>& triangles) {
  const std::size_t faces = links.faces.size();
  Cells cells{std::vector<Index>(faces, kNoIndex), std::vector<Index>(faces, kNoIndex),
              std::vector<Index>(faces, 0)};
  std::vector<Index> queue = triangles;
  for (const Index t : triangles) cells.triangle[t] = t;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Index f = queue[head];
    for_each_neighbour(links, f, [&](Index g) {
      if (cells.triangle[g] != kNoIndex) return;
      cells.triangle[g] = cells.triangle[f];
      cells.parent[g] = f;
      cells.distance[g] = cells.distance[f] + 1;
      queue.push_back(g);
    });
  }
  return cells;
}

/// Where cells meet, the nearest triangles first.
std::vector<Meeting> meetings_of(const FaceLinks& links, const Cells& cells) {
  std::vector<Meeting> meetings;
  for (Index f = 0; f < static_cast<Index>(links.faces.size()); ++f) {
    if (cells.triangle[f] == kNoIndex) continue;
    for_each_neighbour(links, f, [&](Index g) {
      if (f < g && cells.triangle[f] != cells.triangle[g])
        meetings.push_back({cells.distance[f] + cells.distance[g] + 1, f, g});
    });
  }
  std::sort(meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.distance, a.first, a.second) < std::tie(b.distance, b.first, b.second);
  });
  return meetings;
}

/// The faces from one triangle to the other.
std::vector<Index> way_through(const Cells& cells, const Meeting& meeting) {
  std::vector<Index> way;
  for (Index f = meeting.first; f != kNoIndex; f = cells.parent[f]) way.push_back(f);
  std::reverse(way.begin(), way.end());
  for (Index f = meeting.second; f != kNoIndex; f = cells.parent[f]) way.push_back(f);
  return way;
}

/// The triangles at both ends of the way go towards each other, that first whose next step costs
/// less, and merge. Returns the number of steps; merges unless both get stuck.
struct Walk {
  int steps = 0;
  bool merged = false;
};
Walk walk(FaceLinks& links, const std::vector<WorkVertex>& vertices,
          const std::vector<Index>& way) {
  Walk result;
  std::size_t begin = 0, end = way.size() - 1;
  for (; begin + 1 < end; ++result.steps) {
    const Recut ahead = best_recut(links, vertices, way[begin], way[begin + 1], way[begin + 2]);
    const Recut back = best_recut(links, vertices, way[end], way[end - 1], way[end - 2]);
    if (!ahead.possible() && !back.possible()) return result;
    const bool go_ahead = ahead.possible() && (!back.possible() || ahead.cost <= back.cost);
    apply(links, go_ahead ? ahead : back);
    if (go_ahead)
      ++begin;
    else
      --end;
  }
  merge(links, way[begin], way[end]);
  result.merged = true;
  return result;
}

/// Walks as many pairs together as have cells of their own; returns their number.
Index walk_round(FaceLinks& links, const std::vector<WorkVertex>& vertices,
                 const std::vector<Index>& triangles) {
  const Cells cells = grow_cells(links, triangles);
  std::vector<char> taken(links.faces.size(), 0);
  Index merged = 0;
  for (const Meeting& meeting : meetings_of(links, cells)) {
    const Index first = cells.triangle[meeting.first], second = cells.triangle[meeting.second];
    if (taken[first] || taken[second]) continue;
    const Walk walked = walk(links, vertices, way_through(cells, meeting));
    merged += walked.merged ? 1 : 0;
    if (walked.merged || walked.steps > 0) taken[first] = taken[second] = 1;
  }
  return merged;
}

}  // namespace

Index merge_leftover_triangles(MixedMesh& mesh) {
  FaceLinks links = link_faces(mesh);
  std::vector<Index> triangles = triangles_of(mesh);
  while (walk_round(links, mesh.vertices, triangles) > 0) triangles = triangles_of(mesh);
  std::erase_if(mesh.faces, [](const MixedFace& f) { return f.vertices[0] == kNoIndex; });
  return static_cast<Index>(triangles.size());
}

}  // namespace anisofront
