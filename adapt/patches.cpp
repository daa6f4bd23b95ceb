#include "adapt/patches.hpp"

#include <algorithm>

namespace anisofront {
namespace {

constexpr std::size_t kMinPatch = 10;
constexpr int kMaxRings = 4;

std::vector<Index> element_regions(const Mesh& mesh) {
  std::vector<Index> regions = mesh.triangle_regions;
  regions.resize(mesh.triangles.size());
  regions.insert(regions.end(), mesh.quad_regions.begin(), mesh.quad_regions.end());
  regions.resize(mesh.triangles.size() + mesh.quads.size());
  return regions;
}

bool are_equal(const std::vector<Index>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
}

}  // namespace

PatchTopology::PatchTopology(const Mesh& mesh, bool by_region)
    : mesh_(mesh), stars_(vertex_stars(mesh)) {
  if (!by_region) return;
  regions_ = element_regions(mesh);
  if (are_equal(regions_)) {
    regions_.clear();
    return;
  }
  for (Index v = 0; v < vertex_count(); ++v) on_interface_.push_back(regions_at(v).size() > 1);
}

std::vector<Index> PatchTopology::regions_at(Index vertex) const {
  std::vector<Index> result;
  for (const Index e : elements(vertex)) result.push_back(region(e));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

PatchCollector::PatchCollector(const PatchTopology& topology)
    : topology_(topology), mark_(topology.vertex_count(), 0) {}

std::span<const Index> PatchCollector::around(Index vertex, Index region, bool drop_interfaces) {
  ++patch_;
  region_ = region;
  vertices_.clear();
  ring_ = 0;
  add(vertex);
  add_ring(Ring::edges);
  add_ring(Ring::elements);
  const auto kept = [&]() -> std::span<const Index> {
    if (!drop_interfaces) return vertices_;
    kept_.clear();
    std::copy_if(vertices_.begin(), vertices_.end(), std::back_inserter(kept_),
                 [this](Index v) { return !topology_.is_on_interface(v); });
    return kept_;
  };
  for (int ring = 2; ring < kMaxRings && kept().size() < kMinPatch; ++ring)
    add_ring(Ring::elements);
  return kept();
}

void PatchCollector::add_ring(Ring kind) {
  const std::size_t end = vertices_.size();
  for (std::size_t i = ring_; i < end; ++i) add_around(vertices_[i], kind);
  ring_ = end;
}

void PatchCollector::add_around(Index vertex, Ring kind) {
  for (const Index e : topology_.elements(vertex)) {
    if (topology_.region(e) != region_) continue;
    const std::span<const Index> corners = topology_.vertices(e);
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const bool is_next = corners[(k + 1) % n] == vertex || corners[(k + n - 1) % n] == vertex;
      if (kind == Ring::elements || is_next) add(corners[k]);
    }
  }
}

void PatchCollector::add(Index vertex) {
  if (mark_[vertex] == patch_) return;
  mark_[vertex] = patch_;
  vertices_.push_back(vertex);
}

}  // namespace anisofront
