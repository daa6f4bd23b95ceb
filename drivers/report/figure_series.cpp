#include "drivers/report/figure_series.hpp"

#include <algorithm>

#include "drivers/report/figure_label.hpp"

namespace anisofront {
namespace {

std::optional<double> known(const Json& value) {
  return value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt;
}

SeriesPoint series_point(const Json& variant, const Json& cycle) {
  const Json& error = cycle.at("error");
  return {variant.at("name"),
          cycle.at("cycle"),
          cycle.at("dofs"),
          known(error.at("relative_energy")),
          known(error.at("estimate")),
          known(error.at("effectivity"))};
}

bool has_error(const Json& variant) {
  const Json& cycles = variant.at("cycles");
  return std::any_of(cycles.begin(), cycles.end(), [&](const Json& cycle) {
    const SeriesPoint point = series_point(variant, cycle);
    return point.unknowns > 0 && (point.error || point.estimate);
  });
}

/// The settings that variants of one series share.
Json shared_settings(const Json& variant) {
  Json shared = Json::object();
  const Json settings = variant.value("settings", Json::object());
  for (const auto& [key, value] : settings.items())
    if (!key.starts_with("adapt.target") && key != "report.paper") shared[key] = value;
  return shared;
}

struct Group {
  Json settings;
  std::vector<const Json*> variants;
};

std::vector<Group> grouped(const Json& history) {
  std::vector<Group> groups;
  for (const Json& variant : history.at("variants")) {
    if (!has_error(variant)) continue;
    const Json settings = shared_settings(variant);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& other) { return other.settings == settings; });
    if (group == groups.end()) group = groups.insert(group, {settings, {}});
    group->variants.push_back(&variant);
  }
  return groups;
}

void sort_by_unknowns(std::vector<SeriesPoint>& points) {
  std::stable_sort(points.begin(), points.end(), [](const SeriesPoint& a, const SeriesPoint& b) {
    return a.unknowns < b.unknowns;
  });
}

Series series_of(const Group& group, const std::string& label) {
  Series series{curve_kind(*group.variants.front()), {}, {}};
  if (!label.empty()) series.kind.label = label;
  const bool is_single = group.variants.size() == 1;
  for (const Json* variant : group.variants) {
    const Json& cycles = variant->at("cycles");
    for (const Json& cycle : cycles) {
      const bool is_last = cycle.at("cycle") == cycles.back().at("cycle");
      if (is_single || is_last)
        series.curve.push_back(series_point(*variant, cycle));
      else if (cycle.at("cycle") != 0)
        series.before.push_back(series_point(*variant, cycle));
    }
  }
  if (!is_single) sort_by_unknowns(series.curve);
  return series;
}

}  // namespace

std::vector<Series> error_series(const Json& history) {
  const std::vector<Group> groups = grouped(history);
  std::vector<Json> settings;
  for (const Group& group : groups) settings.push_back(group.settings);
  const std::vector<std::string> labels = distinguishing_labels(settings);
  std::vector<Series> series;
  for (std::size_t i = 0; i < groups.size(); ++i) series.push_back(series_of(groups[i], labels[i]));
  return series;
}

}  // namespace anisofront
