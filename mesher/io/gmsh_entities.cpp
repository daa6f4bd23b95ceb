#include "mesher/io/gmsh_content.hpp"

namespace anisofront {

namespace {

using Counts = std::array<std::int64_t, 4>;  ///< points, curves, surfaces, volumes

Counts read_counts(GmshStream& in) {
  Counts counts;
  for (std::int64_t& n : counts) n = in.size("a number of entities");
  return counts;
}

/// The first of the physical tags, or 0.
Index read_physical_tags(GmshStream& in, bool& several) {
  const std::int64_t n = in.size("a number of physical tags");
  Index first = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    const Index tag = unsigned_tag(in.integer("a physical tag"));
    if (i == 0) first = tag;
  }
  several = several || n > 1;
  return first;
}

/// What follows the tags of an entity: bounding box, physical tags, boundary.
void read_rest(GmshStream& in, GmshEntity& entity, bool& several) {
  const int coordinates = entity.dimension == 0 ? 3 : 6;
  for (int k = 0; k < coordinates; ++k) in.real("a coordinate");
  entity.physical = read_physical_tags(in, several);
  if (entity.dimension == 0) return;
  const std::int64_t n = in.size("the number of bounding entities");
  for (std::int64_t i = 0; i < n; ++i) in.integer("the tag of a bounding entity");
}

/// Parent and partitions of a partitioned entity.
void read_parent(GmshStream& in, GmshEntity& entity) {
  const Index dimension = in.integer("the dimension of the parent");
  const Index tag = in.integer("the tag of the parent");
  entity.is_interface = dimension > entity.dimension;
  if (dimension == entity.dimension) entity.elementary = tag;
  const std::int64_t n = in.size("the number of partitions");
  for (std::int64_t i = 0; i < n; ++i) in.integer("the number of a partition");
}

void read_all(GmshStream& in, GmshContent& content, GmshEntities& entities, bool partitioned) {
  bool several = false;
  const Counts counts = read_counts(in);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      GmshEntity entity{.dimension = dimension, .tag = in.integer("the tag of an entity")};
      entity.elementary = entity.tag;
      if (partitioned) read_parent(in, entity);
      read_rest(in, entity, several);
      entities.push_back(entity);
    }
  // Stable: of equal tags, the later (partitioned) one is found by searching from the end.
  std::stable_sort(entities.begin(), entities.end(), [](const GmshEntity& a, const GmshEntity& b) {
    return std::pair(a.dimension, a.tag) < std::pair(b.dimension, b.tag);
  });
  if (several)
    content.warning("entities belong to several physical groups; the first of each is kept");
}

}  // namespace

void read_gmsh_entities(GmshStream& in, GmshContent& content, GmshEntities& entities) {
  read_all(in, content, entities, false);
}

void read_gmsh_partitioned_entities(GmshStream& in, GmshContent& content, GmshEntities& entities) {
  in.size("the number of partitions");
  const std::int64_t ghosts = in.size("the number of ghost entities");
  for (std::int64_t i = 0; i < ghosts; ++i) {
    in.integer("the tag of a ghost entity");
    in.integer("the number of a partition");
  }
  read_all(in, content, entities, true);
}

}  // namespace anisofront
