#include "mesher/enhance/patch.hpp"

namespace anisofront {

void Patch::update_all_alphas() {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!mesh.triangles[t].dead()) update_alpha(static_cast<Index>(t));
}

Patch make_patch(const BackgroundMesh& background, WorkMesh& mesh,
                 const std::vector<Index>& required) {
  Patch patch{background, mesh, {}, {}, {}, {}, {}};
  const std::size_t vertices = mesh.vertices.size();
  // Splits append: room for them is cheaper than a second copy of each array.
  const std::size_t room = vertices + vertices / 32 + 16;
  patch.triangle_of.reserve(room);
  patch.fixed.reserve(room);
  patch.active.reserve(room);
  patch.triangle_of.assign(vertices, kNoIndex);
  patch.fixed.assign(vertices, 0);
  patch.active.assign(vertices, 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Index v : mesh.triangles[t].vertices) patch.triangle_of[v] = static_cast<Index>(t);
  for (const Segment& s : mesh.segments) patch.fixed[s.a] = patch.fixed[s.b] = 1;
  for (const Index v : required) patch.fixed[v] = 1;
  patch.alpha.reserve(mesh.triangles.size() + 2 * (room - vertices));
  patch.alpha.resize(mesh.triangles.size());
  patch.update_all_alphas();
  return patch;
}

bool closed_ring(const Patch& patch, Index v, Ring& ring) {
  const Index start = patch.triangle_of[v];
  Index current = start;
  ring.size = 0;
  ring.closed = true;
  do {
    if (current < 0 || ring.size == Ring::kCapacity) return false;
    const WorkTriangle& t = patch.mesh.triangles[current];
    const int next = kNext[local_index(t, v)];
    ring.triangles[ring.size] = current;
    ring.vertices[ring.size++] = t.vertices[next];
    current = t.neighbours[next];
  } while (current != start);
  ring.vertices[ring.size] = ring.vertices[0];
  return true;
}

bool fan_through(const Patch& patch, Index v, Index triangle, Ring& ring) {
  Index start = triangle;
  for (int turns = 0; turns <= Ring::kCapacity; ++turns) {
    const WorkTriangle& t = patch.mesh.triangles[start];
    const Index before = t.neighbours[kPrevious[local_index(t, v)]];
    if (before < 0 || before == triangle) break;
    start = before;
  }
  ring.size = 0;
  for (Index current = start; ring.size < Ring::kCapacity;) {
    const WorkTriangle& t = patch.mesh.triangles[current];
    const int i = local_index(t, v);
    ring.triangles[ring.size] = current;
    ring.vertices[ring.size++] = t.vertices[kNext[i]];
    ring.vertices[ring.size] = t.vertices[kPrevious[i]];
    current = t.neighbours[kNext[i]];
    if (current < 0 || current == start) {
      ring.closed = current == start;
      return true;
    }
  }
  return false;
}

}  // namespace anisofront
