#include "adapt/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "adapt/reference.hpp"

namespace anisofront {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

const std::string kMode = "adapt.mode";
const std::string kTarget = "adapt.target";

/// One mesh: a size of it (vertices or unknowns) and its error.
struct ErrorPoint {
  double size = 0, error = 0;
};

/// The variants of a group by mode.
struct Group {
  Settings settings;
  std::vector<const VariantHistory*> isotropic, anisotropic;
};

using SizeOf = double (*)(const CycleRecord&);
double vertices_of(const CycleRecord& cycle) { return cycle.background.vertices; }
double dofs_of(const CycleRecord& cycle) { return cycle.dofs; }

using ErrorOf = std::optional<double> CycleError::*;

Settings shared_settings(const VariantHistory& variant) {
  Settings shared;
  for (const auto& setting : variant.settings)
    if (setting.first != kMode && !setting.first.starts_with(kTarget)) shared.push_back(setting);
  return shared;
}

std::string mode_of(const VariantHistory& variant) {
  for (const auto& [key, value] : variant.settings)
    if (key == kMode) return value;
  return {};
}

std::vector<Group> groups_of(std::span<const VariantHistory> variants) {
  std::vector<Group> groups;
  for (const VariantHistory& variant : variants) {
    Settings shared = shared_settings(variant);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& g) { return g.settings == shared; });
    if (group == groups.end())
      group = groups.insert(groups.end(), Group{std::move(shared), {}, {}});
    if (mode_of(variant) == "isotropic") group->isotropic.push_back(&variant);
    if (mode_of(variant) == "anisotropic") group->anisotropic.push_back(&variant);
  }
  return groups;
}

bool counts(const CycleRecord& cycle, ErrorOf which) {
  const std::optional<double>& error = cycle.error.*which;
  return cycle.cycle >= 1 && error && *error > 0 && std::isfinite(*error);
}

/// The points that no other beats in size and error: sizes up, errors down.
std::vector<ErrorPoint> best_points(const std::vector<const VariantHistory*>& variants,
                                    SizeOf size_of, ErrorOf which) {
  std::vector<ErrorPoint> points;
  for (const VariantHistory* variant : variants)
    for (const CycleRecord& cycle : variant->cycles)
      if (counts(cycle, which) && size_of(cycle) > 0)
        points.push_back({size_of(cycle), *(cycle.error.*which)});
  std::sort(points.begin(), points.end(), [](const ErrorPoint& a, const ErrorPoint& b) {
    return std::pair(a.size, a.error) < std::pair(b.size, b.error);
  });
  std::vector<ErrorPoint> best;
  for (const ErrorPoint& point : points)
    if (best.empty() || point.error < best.back().error) best.push_back(point);
  return best;
}

std::optional<double> size_at(const std::vector<ErrorPoint>& points, double level) {
  std::vector<double> sizes, errors;
  for (const ErrorPoint& point : points) {
    if (point.error == level) return point.size;
    sizes.push_back(point.size);
    errors.push_back(point.error);
  }
  return at_equal_error(sizes, errors, level);
}

SizeAtError sizes_at(const std::vector<const VariantHistory*>& variants, ErrorOf which,
                     double level) {
  return {size_at(best_points(variants, vertices_of, which), level),
          size_at(best_points(variants, dofs_of, which), level)};
}

std::optional<ModeComparison> compare(const Group& group, ErrorOf which) {
  const auto isotropic = best_points(group.isotropic, vertices_of, which);
  const auto anisotropic = best_points(group.anisotropic, vertices_of, which);
  if (isotropic.empty() || anisotropic.empty()) return {};
  ModeComparison comparison;
  comparison.settings = group.settings;
  comparison.is_true_error = which == &CycleError::relative_energy;
  comparison.error = std::max(isotropic.back().error, anisotropic.back().error);
  comparison.isotropic = sizes_at(group.isotropic, which, comparison.error);
  comparison.anisotropic = sizes_at(group.anisotropic, which, comparison.error);
  return comparison;
}

}  // namespace

std::vector<ModeComparison> compare_modes(std::span<const VariantHistory> variants) {
  std::vector<ModeComparison> comparisons;
  for (const Group& group : groups_of(variants)) {
    std::optional<ModeComparison> comparison = compare(group, &CycleError::relative_energy);
    if (!comparison) comparison = compare(group, &CycleError::estimate);
    if (comparison) comparisons.push_back(std::move(*comparison));
  }
  return comparisons;
}

std::optional<double> size_ratio(const std::optional<double>& anisotropic,
                                 const std::optional<double>& isotropic) {
  if (!anisotropic || !isotropic) return {};
  return *anisotropic / *isotropic;
}

}  // namespace anisofront
