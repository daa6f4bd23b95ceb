#include "mesher/io/svg_fill.hpp"

#include <array>
#include <set>

#include "mesher/io/svg_key.hpp"
#include "mesher/io/svg_outline.hpp"

namespace anisofront {

namespace {

constexpr std::array<std::string_view, 8> kTints{"#e6f0fa", "#fdeedb", "#e6f4e1", "#f9e4ec",
                                                 "#eee8f8", "#fbf6d5", "#dff3f1", "#f1ece4"};

/// Without the quotation mark at the end.
void begin_fill(AtomicFile& out, SvgPath& path, std::string_view colour, const Loops& loops) {
  out.text("<path fill=\"" + std::string(colour) + "\" d=\"");
  for (const std::vector<Index>& loop : loops) path.polygon(loop);
}

std::vector<Index> regions_of(const Mesh& mesh) {
  std::vector<Index> regions = mesh.triangle_regions;
  regions.insert(regions.end(), mesh.quad_regions.begin(), mesh.quad_regions.end());
  return regions;
}

}  // namespace

std::vector<bool> shown_elements(const Mesh& mesh, const SvgFrame& frame) {
  std::vector<bool> shown;
  for (const Triangle& triangle : mesh.triangles) shown.push_back(is_shown(mesh, frame, triangle));
  for (const Quad& quad : mesh.quads) shown.push_back(is_shown(mesh, frame, quad));
  return shown;
}

void write_regions(AtomicFile& out, const Mesh& mesh, SvgPath& path,
                   const std::vector<bool>& shown) {
  const std::vector<Index> regions = regions_of(mesh);
  const std::set<Index> sorted(regions.begin(), regions.end());
  const std::vector<Index> tags(sorted.begin(), sorted.end());
  std::vector<Index> classes;
  for (std::size_t e = 0; e < regions.size(); ++e) {
    const auto place = std::lower_bound(tags.begin(), tags.end(), regions[e]) - tags.begin();
    classes.push_back(shown[e] ? static_cast<Index>(place) : kNoIndex);
  }
  for (const auto& [number, loops] : class_outlines(mesh, classes)) {
    const auto k = static_cast<std::size_t>(number);
    begin_fill(out, path, kTints[k % kTints.size()], loops);
    end_path(out, mesh, 2, tags[k]);
  }
}

ValueRange value_range(std::span<const double> values, const std::vector<bool>& shown) {
  ValueRange range;
  for (std::size_t e = 0; e < values.size(); ++e) {
    if (!shown[e] || !std::isfinite(values[e])) continue;
    range.least = std::min(range.least, values[e]);
    range.greatest = std::max(range.greatest, values[e]);
  }
  return range;
}

void write_values(AtomicFile& out, const Mesh& mesh, SvgPath& path, const std::vector<bool>& shown,
                  std::span<const double> values, ValueRange range) {
  constexpr auto kCount = static_cast<double>(kValueColours.size());
  const double extent = range.greatest > range.least ? range.greatest - range.least : 1;
  std::vector<Index> classes(values.size(), kNoIndex);
  for (std::size_t e = 0; e < values.size(); ++e)
    if (shown[e] && std::isfinite(values[e]))
      classes[e] =
          static_cast<Index>(std::min(kCount * ((values[e] - range.least) / extent), kCount - 1));
  // Without smoothing, neighbours of different colours leave no gap.
  out.text("<g shape-rendering=\"crispEdges\">\n");
  for (const auto& [number, loops] : class_outlines(mesh, classes)) {
    begin_fill(out, path, kValueColours[static_cast<std::size_t>(number)], loops);
    out.text("\"/>\n");
  }
  out.text("</g>\n");
}

}  // namespace anisofront
