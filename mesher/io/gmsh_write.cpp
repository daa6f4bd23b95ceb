#include <algorithm>
#include <numeric>
#include <span>

#include "mesher/io/gmsh.hpp"
#include "mesher/io/gmsh_entity_plan.hpp"
#include "mesher/io/gmsh_marks.hpp"
#include "mesher/io/gmsh_sink.hpp"
#include "mesher/io/mesh_arrays.hpp"

namespace anisofront {

namespace {

enum GmshType { kLine = 1, kTriangle = 2, kQuad = 3, kPoint = 15 };

/// Elements of one type: their vertices, one after the other, and the entity of each.
struct ElementList {
  GmshType type;
  std::size_t dimension;
  std::size_t corners;
  std::vector<Index> vertices;
  std::vector<std::size_t> entities;
  std::size_t first_number = 1;

  std::size_t size() const { return entities.size(); }
  std::span<const Index> element(std::size_t e) const {
    return std::span(vertices).subspan(e * corners, corners);
  }
};

template <class Elements>
std::vector<Index> flattened(const Elements& elements) {
  std::vector<Index> flat;
  for (const auto& element : elements) flat.insert(flat.end(), element.begin(), element.end());
  return flat;
}

/// In the order of their numbers: curve edges, triangles, quads, tagged points.
std::array<ElementList, 4> element_lists(const Mesh& mesh, const GmshEntityPlan& plan) {
  std::vector<std::array<Index, 2>> edges;
  for (const CurveEdge& edge : mesh.edges) edges.push_back(edge.vertices);
  std::vector<std::size_t> points(plan.point_vertices.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  std::array<ElementList, 4> lists{
      {{kLine, 1, 2, flattened(edges), plan.edge_curves},
       {kTriangle, 2, 3, flattened(mesh.triangles), plan.triangle_surfaces},
       {kQuad, 2, 4, flattened(mesh.quads), plan.quad_surfaces},
       {kPoint, 0, 1, plan.point_vertices, points}}};
  for (std::size_t k = 1; k < lists.size(); ++k)
    lists[k].first_number = lists[k - 1].first_number + lists[k - 1].size();
  return lists;
}

std::size_t total_size(const std::array<ElementList, 4>& lists) {
  return lists.back().first_number - 1 + lists.back().size();
}

/// Indices of `keys` grouped by equal key: ascending keys, then ascending indices.
template <class Key>
std::vector<std::size_t> grouped(const std::vector<Key>& keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto by_key = [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; };
  if (!std::is_sorted(keys.begin(), keys.end()))
    std::stable_sort(order.begin(), order.end(), by_key);
  return order;
}

/// Calls use(indices) for each run of equal keys in `order`.
template <class Key, class Use>
void for_each_group(const std::vector<Key>& keys, const std::vector<std::size_t>& order, Use use) {
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first + 1;
    while (last < order.size() && keys[order[last]] == keys[order[first]]) ++last;
    use(std::span(order).subspan(first, last - first));
    first = last;
  }
}

template <class Key>
std::size_t group_count(const std::vector<Key>& keys, const std::vector<std::size_t>& order) {
  std::size_t n = 0;
  for_each_group(keys, order, [&n](std::span<const std::size_t>) { ++n; });
  return n;
}

void write_point(GmshSink& sink, Point p) {
  sink.real(p.x);
  sink.real(p.y);
  sink.real(0);
}

void write_format(GmshSink& sink, GmshVersion version) {
  sink.text(version == GmshVersion::v2_2 ? "$MeshFormat\n2.2 " : "$MeshFormat\n4.1 ");
  sink.text(sink.binary ? "1 8\n" : "0 8\n");
  if (sink.binary) {
    sink.integer(1);
    sink.text("\n");
  }
  sink.text("$EndMeshFormat\n");
}

/// A string between quotation marks, which Gmsh cannot hold inside; nor line ends.
void write_quoted(GmshSink& sink, std::string name) {
  std::replace(name.begin(), name.end(), '"', '\'');
  std::replace(name.begin(), name.end(), '\n', ' ');
  sink.text("\"" + name + "\"\n");
}

void write_physical_names(GmshSink& sink, const Mesh& mesh) {
  if (mesh.groups.empty()) return;
  sink.text("$PhysicalNames\n");
  sink.text_line(static_cast<std::int64_t>(mesh.groups.size()));
  for (const PhysicalGroup& group : mesh.groups) {
    sink.text(std::to_string(group.dimension) + " " + std::to_string(group.tag) + " ");
    write_quoted(sink, group.name);
  }
  sink.text("$EndPhysicalNames\n");
}

void write_nodes_2(GmshSink& sink, const Mesh& mesh) {
  sink.text("$Nodes\n");
  sink.text_line(static_cast<std::int64_t>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    sink.integer(static_cast<Index>(v + 1));
    write_point(sink, mesh.points[v]);
    sink.end_line();
  }
  sink.text(sink.binary ? "\n$EndNodes\n" : "$EndNodes\n");
}

void write_element_2(GmshSink& sink, const ElementList& list, std::size_t e,
                     const GmshEntityPlan& plan) {
  const GmshEntityPlan::Entity& entity = plan.entities[list.dimension][list.entities[e]];
  sink.integer(static_cast<Index>(list.first_number + e));
  if (!sink.binary) {
    sink.integer(list.type);
    sink.integer(2);
  }
  sink.integer(entity.physical);
  sink.integer(entity.tag);
  for (const Index v : list.element(e)) sink.integer(v + 1);
  sink.end_line();
}

void write_elements_2(GmshSink& sink, const Mesh& mesh, const GmshEntityPlan& plan) {
  const std::array<ElementList, 4> lists = element_lists(mesh, plan);
  sink.text("$Elements\n");
  sink.text_line(static_cast<std::int64_t>(total_size(lists)));
  for (const ElementList& list : lists) {
    if (sink.binary && list.size() > 0) {
      sink.integer(list.type);
      sink.integer(static_cast<Index>(list.size()));
      sink.integer(2);
    }
    for (std::size_t e = 0; e < list.size(); ++e) write_element_2(sink, list, e, plan);
  }
  sink.text(sink.binary ? "\n$EndElements\n" : "$EndElements\n");
}

void write_entity(GmshSink& sink, const GmshEntityPlan::Entity& entity, std::size_t dimension) {
  sink.integer(entity.tag);
  write_point(sink, entity.low);
  if (dimension > 0) write_point(sink, entity.high);
  sink.size(entity.physical != 0);
  if (entity.physical != 0) sink.integer(entity.physical);
  if (dimension > 0) sink.size(0);  // bounding entities
  sink.end_line();
}

void write_entities_4(GmshSink& sink, const GmshEntityPlan& plan) {
  sink.text("$Entities\n");
  for (const auto& list : plan.entities) sink.size(list.size());
  sink.size(0);  // volumes
  sink.end_line();
  for (std::size_t dimension = 0; dimension < 3; ++dimension)
    for (const auto& entity : plan.entities[dimension]) write_entity(sink, entity, dimension);
  sink.text(sink.binary ? "\n$EndEntities\n" : "$EndEntities\n");
}

void write_header_4(GmshSink& sink, std::size_t blocks, std::size_t total) {
  sink.size(blocks);
  sink.size(total);
  sink.size(total > 0);  // smallest and largest number
  sink.size(total);
  sink.end_line();
}

void write_node_block(GmshSink& sink, const Mesh& mesh, const GmshEntityPlan& plan,
                      std::span<const std::size_t> vertices) {
  const auto [dimension, entity] = plan.places[vertices.front()];
  sink.integer(static_cast<Index>(dimension));
  sink.integer(plan.entities[dimension][entity].tag);
  sink.integer(0);  // no parametric coordinates
  sink.size(vertices.size());
  sink.end_line();
  for (const std::size_t v : vertices) {
    sink.size(v + 1);
    sink.end_line();
  }
  for (const std::size_t v : vertices) {
    write_point(sink, mesh.points[v]);
    sink.end_line();
  }
}

void write_nodes_4(GmshSink& sink, const Mesh& mesh, const GmshEntityPlan& plan) {
  const std::vector<std::size_t> order = grouped(plan.places);
  sink.text("$Nodes\n");
  write_header_4(sink, group_count(plan.places, order), mesh.points.size());
  for_each_group(plan.places, order, [&](std::span<const std::size_t> vertices) {
    write_node_block(sink, mesh, plan, vertices);
  });
  sink.text(sink.binary ? "\n$EndNodes\n" : "$EndNodes\n");
}

void write_element_block(GmshSink& sink, const ElementList& list, const GmshEntityPlan& plan,
                         std::span<const std::size_t> elements) {
  sink.integer(static_cast<Index>(list.dimension));
  sink.integer(plan.entities[list.dimension][list.entities[elements.front()]].tag);
  sink.integer(list.type);
  sink.size(elements.size());
  sink.end_line();
  for (const std::size_t e : elements) {
    sink.size(list.first_number + e);
    for (const Index v : list.element(e)) sink.size(static_cast<std::size_t>(v) + 1);
    sink.end_line();
  }
}

void write_elements_4(GmshSink& sink, const Mesh& mesh, const GmshEntityPlan& plan) {
  const std::array<ElementList, 4> lists = element_lists(mesh, plan);
  std::array<std::vector<std::size_t>, 4> orders;
  std::size_t blocks = 0;
  for (std::size_t k = 0; k < lists.size(); ++k) {
    orders[k] = grouped(lists[k].entities);
    blocks += group_count(lists[k].entities, orders[k]);
  }
  sink.text("$Elements\n");
  write_header_4(sink, blocks, total_size(lists));
  for (std::size_t k = 0; k < lists.size(); ++k)
    for_each_group(lists[k].entities, orders[k], [&](std::span<const std::size_t> elements) {
      write_element_block(sink, lists[k], plan, elements);
    });
  sink.text(sink.binary ? "\n$EndElements\n" : "$EndElements\n");
}

/// Entries are numbered from `first_number`.
void write_field(GmshSink& sink, const FileField& field, std::string_view section,
                 std::size_t first_number) {
  const auto components = static_cast<std::size_t>(field.components);
  const std::size_t count = field.values.size() / components;
  sink.text("$" + std::string(section) + "\n1\n");
  write_quoted(sink, field.name);
  sink.text("1\n");
  sink.out.real(field.time);
  sink.text("\n3\n");
  sink.text_line(field.step);
  sink.text_line(field.components);
  sink.text_line(static_cast<std::int64_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    sink.integer(static_cast<Index>(first_number + i));
    for (std::size_t k = 0; k < components; ++k) sink.real(field.values[i * components + k]);
    sink.end_line();
  }
  sink.text(std::string(sink.binary ? "\n" : "") + "$End" + std::string(section) + "\n");
}

}  // namespace

void write_gmsh(const std::filesystem::path& path, const MeshFile& file, GmshFormat format) {
  require_writable(file, path.string());
  const Mesh& mesh = file.mesh;
  const GmshEntityPlan plan = plan_gmsh_entities(mesh, path.string());
  AtomicFile out(path);
  GmshSink sink{.out = out, .binary = format.binary};
  write_format(sink, format.version);
  write_physical_names(sink, mesh);
  if (format.version == GmshVersion::v2_2) {
    write_nodes_2(sink, mesh);
    write_elements_2(sink, mesh, plan);
  } else {
    write_entities_4(sink, plan);
    write_nodes_4(sink, mesh, plan);
    write_elements_4(sink, mesh, plan);
  }
  write_gmsh_marks(out, mesh, plan);
  for (const FileField& field : file.vertex_fields) write_field(sink, field, "NodeData", 1);
  for (const FileField& field : file.element_fields)
    write_field(sink, field, "ElementData", mesh.edges.size() + 1);
  out.commit();
}

}  // namespace anisofront
