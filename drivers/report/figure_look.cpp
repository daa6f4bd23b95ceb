#include <algorithm>
#include <array>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_series.hpp"

namespace anisofront {
namespace {

constexpr std::size_t kMostLabels = 12;
constexpr std::size_t kColours = 6;  // of each family in style.gp

bool same_elements(const std::vector<CurveKind>& kinds) {
  return std::all_of(kinds.begin(), kinds.end(), [&](const CurveKind& kind) {
    return kind.elements == kinds.front().elements;
  });
}

bool same_mode(const std::vector<CurveKind>& kinds) {
  return std::all_of(kinds.begin(), kinds.end(), [&](const CurveKind& kind) {
    return kind.is_isotropic == kinds.front().is_isotropic;
  });
}

/// gnuplot's open markers; the filled one is the next.
int marker_of(const CurveKind& kind) {
  if (kind.elements == "triangle") return 8;
  return kind.elements == "quadrilateral" ? 4 : 12;
}

std::string class_label(const CurveKind& kind) {
  const std::string elements = kind.elements == "mixed" ? "mixed" : kind.elements + "s";
  return (kind.is_isotropic ? "isotropic, " : "anisotropic, ") + elements;
}

/// Many curves: thin ones, the first of each class stands for it in the legend.
std::vector<CurveLook> class_looks(const std::vector<CurveKind>& kinds) {
  std::vector<CurveLook> looks;
  std::vector<std::string> labels;
  for (const CurveKind& kind : kinds) {
    std::string label = class_label(kind);
    const bool is_new = std::find(labels.begin(), labels.end(), label) == labels.end();
    if (is_new) labels.push_back(label);
    const int colour = (kind.is_isotropic ? 11 : 1) + (kind.elements == "triangle" ? 0 : 1);
    looks.push_back({fmt::format("linestyle {} linewidth 0.6 pointtype {}", colour,
                                 marker_of(kind) + (kind.is_isotropic ? 0 : 1)),
                     is_new ? label : ""});
  }
  return looks;
}

}  // namespace

CurveKind curve_kind(const Json& variant) {
  const Json settings = variant.value("settings", Json::object());
  const auto text = [&](const char* key) {
    const Json value = settings.value(key, Json(""));
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  return {variant.at("name"), text("adapt.mode") == "isotropic", text("mesh.elements")};
}

std::vector<CurveLook> curve_looks(const std::vector<CurveKind>& kinds) {
  if (kinds.size() > kMostLabels) return class_looks(kinds);
  constexpr std::array<int, kColours> kMarkers{6, 4, 8, 12, 10, 14};
  const bool is_one_mode = same_mode(kinds), is_one_element = same_elements(kinds);
  std::array<std::size_t, 2> counts{};  // anisotropic, isotropic
  std::vector<CurveLook> looks;
  for (const CurveKind& kind : kinds) {
    const std::size_t k = counts[kind.is_isotropic ? 1 : 0]++;
    const std::size_t family = is_one_mode ? 21 : kind.is_isotropic ? 11 : 1;
    const int marker = is_one_element ? kMarkers[k % kColours] : marker_of(kind);
    looks.push_back({fmt::format("linestyle {} pointtype {}", family + k % kColours,
                                 marker + (kind.is_isotropic ? 0 : 1)),
                     kind.label});
  }
  return looks;
}

}  // namespace anisofront
