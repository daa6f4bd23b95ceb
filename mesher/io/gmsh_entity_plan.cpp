#include "mesher/io/gmsh_entity_plan.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "mesher/geometry/error.hpp"

namespace anisofront {

namespace {

using Entity = GmshEntityPlan::Entity;
using Key = std::pair<Index, Index>;  ///< preferred elementary tag, physical tag

/// Makes one entity per key, in ascending order; returns the entity of each key.
std::vector<std::size_t> make_entities(const std::vector<Key>& keys,
                                       std::vector<Entity>& entities) {
  constexpr Index kLargestPreferred = 1'000'000'000;  // room for fresh tags above
  std::map<Key, std::size_t> slots;
  for (const Key& key : keys) slots.emplace(key, 0);
  const auto usable = [](Index tag) { return tag > 0 && tag <= kLargestPreferred; };
  Index fresh = 1;
  for (const auto& [key, slot] : slots)
    if (usable(key.first)) fresh = std::max(fresh, key.first + 1);
  Index previous = 0;
  for (auto& [key, slot] : slots) {
    slot = entities.size();
    const bool preferred = usable(key.first) && key.first != previous;
    entities.push_back({.tag = preferred ? key.first : fresh++, .physical = key.second});
    previous = key.first;
  }
  std::vector<std::size_t> found;
  found.reserve(keys.size());
  for (const Key& key : keys) found.push_back(slots.find(key)->second);
  return found;
}

void make_surfaces(const Mesh& mesh, GmshEntityPlan& plan) {
  std::vector<Key> keys;
  keys.reserve(mesh.triangles.size() + mesh.quads.size());
  for (const Index region : mesh.triangle_regions) keys.emplace_back(region, region);
  for (const Index region : mesh.quad_regions) keys.emplace_back(region, region);
  const std::vector<std::size_t> found = make_entities(keys, plan.entities[2]);
  const auto split = found.begin() + static_cast<std::ptrdiff_t>(mesh.triangles.size());
  plan.triangle_surfaces.assign(found.begin(), split);
  plan.quad_surfaces.assign(split, found.end());
  // Vertices of no element need a place too.
  if (plan.entities[2].empty() && !mesh.points.empty()) plan.entities[2].push_back({.tag = 1});
}

void make_curves(const Mesh& mesh, GmshEntityPlan& plan) {
  std::vector<Key> keys;
  for (const CurveEdge& edge : mesh.edges) keys.emplace_back(edge.curve, edge.tag);
  plan.edge_curves = make_entities(keys, plan.entities[1]);
}

void make_points(const Mesh& mesh, GmshEntityPlan& plan) {
  for (std::size_t v = 0; v < mesh.vertex_tags.size(); ++v) {
    if (mesh.vertex_tags[v] == 0) continue;
    plan.point_vertices.push_back(static_cast<Index>(v));
    plan.entities[0].push_back(
        {.tag = static_cast<Index>(plan.point_vertices.size()), .physical = mesh.vertex_tags[v]});
  }
}

/// Places vertices on an entity; of several, the last call wins.
void place(GmshEntityPlan& plan, std::span<const Index> vertices, std::size_t dimension,
           std::size_t entity) {
  for (const Index v : vertices) plan.places[static_cast<std::size_t>(v)] = {dimension, entity};
}

void place_vertices(const Mesh& mesh, GmshEntityPlan& plan) {
  plan.places.resize(mesh.points.size());
  for (std::size_t q = mesh.quads.size(); q-- > 0;)
    place(plan, mesh.quads[q], 2, plan.quad_surfaces[q]);
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
    place(plan, mesh.triangles[t], 2, plan.triangle_surfaces[t]);
  for (std::size_t e = mesh.edges.size(); e-- > 0;)
    place(plan, mesh.edges[e].vertices, 1, plan.edge_curves[e]);
  for (std::size_t p = 0; p < plan.point_vertices.size(); ++p)
    place(plan, std::span(&plan.point_vertices[p], 1), 0, p);
}

/// Widens the box of an entity.
void widen(Entity& entity, const Mesh& mesh, std::span<const Index> vertices) {
  for (const Index v : vertices) {
    const Point p = mesh.points[static_cast<std::size_t>(v)];
    entity.low = {std::min(entity.low.x, p.x), std::min(entity.low.y, p.y)};
    entity.high = {std::max(entity.high.x, p.x), std::max(entity.high.y, p.y)};
  }
}

void find_boxes(const Mesh& mesh, GmshEntityPlan& plan) {
  auto& [points, curves, surfaces] = plan.entities;
  const auto start = [&mesh](Entity& entity, Index v) {
    entity.low = entity.high = mesh.points[static_cast<std::size_t>(v)];
  };
  for (std::size_t p = 0; p < points.size(); ++p) start(points[p], plan.point_vertices[p]);
  for (std::size_t e = mesh.edges.size(); e-- > 0;)
    start(curves[plan.edge_curves[e]], mesh.edges[e].vertices[0]);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    widen(curves[plan.edge_curves[e]], mesh, mesh.edges[e].vertices);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    start(surfaces[plan.triangle_surfaces[t]], mesh.triangles[t][0]);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    start(surfaces[plan.quad_surfaces[q]], mesh.quads[q][0]);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    widen(surfaces[plan.triangle_surfaces[t]], mesh, mesh.triangles[t]);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    widen(surfaces[plan.quad_surfaces[q]], mesh, mesh.quads[q]);
}

void check_tags(const GmshEntityPlan& plan, const std::string& name) {
  for (const std::vector<Entity>& list : plan.entities)
    for (const Entity& entity : list)
      if (entity.physical < 0)
        throw InputError("cannot write " + name + ": tag " + std::to_string(entity.physical) +
                         " is negative, Gmsh expects tags of at least 0 (0: none)");
}

}  // namespace

GmshEntityPlan plan_gmsh_entities(const Mesh& mesh, const std::string& name) {
  GmshEntityPlan plan;
  make_points(mesh, plan);
  make_curves(mesh, plan);
  make_surfaces(mesh, plan);
  check_tags(plan, name);
  place_vertices(mesh, plan);
  find_boxes(mesh, plan);
  return plan;
}

}  // namespace anisofront
