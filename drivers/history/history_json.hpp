#pragma once

#include <array>
#include <string>
#include <vector>

#include "adapt/comparison.hpp"
#include "adapt/history.hpp"
#include "drivers/base/json.hpp"

namespace anisofront {

/// history.json, schema 1: {"schema":1, "version":..., "title":..., "variants":[...],
/// "comparison":[...]}; the version is that of the program. `keys`: one per variant (see
/// variant_key()), or none.
Json history_json(const std::string& title, const std::vector<VariantHistory>& variants,
                  const std::vector<std::string>& keys = {});

/// The words for StoppedBy, in its order.
inline constexpr std::array<const char*, 6> kStoppedByNames{"cycles", "target",      "plateau",
                                                            "budget", "interrupted", "failed"};

/// {"name", "key", "settings", "cycles":[...], "stop_reason" (in words), "stopped_by"
/// (kStoppedByNames, null while cycles are to follow), "target":"none"|"missed"|"reached"}.
///
/// A cycle holds the counts and, under "quality" (alpha~ of triangles, beta~ of quadrilaterals),
/// "edge_length", "angle" (corners, in the metric, degrees), "metric_complexity" and "stretch_max",
/// the statistics against the exact formula of a prescribed metric ("against":"exact"); the object
/// "background" beside them holds the same five against the metric interpolated on the mesh that
/// served as background ("against":"background"). A problem has no exact metric: there both are
/// against the background. "scaled_jacobian_min" is that of the quadrilaterals in the plane (1
/// without any). "error" holds "kind" ("true", "estimate" or null: the best that is known),
/// "estimate", "relative_energy" (the true error) and "effectivity"; "goal" {"value", "error"} or
/// null; "values" {name: value}. What is unknown is null.
Json variant_json(const VariantHistory& variant, const std::string& key);

/// The inverse of variant_json() but for the settings, which stay empty.
/// Throws nlohmann::json::exception for anything else.
VariantHistory variant_history(const Json& variant);

/// Statistics as in a cycle of history.json; `against`: "exact" or "background".
Json statistics_json(const MeshStatistics& statistics, const std::string& against);

/// {"settings":{...}, "against":"true"|"estimate", "error":..., "isotropic":{"vertices", "dofs"},
/// "anisotropic":{...}, "ratio":{...}} per comparison, unknown sizes null.
Json comparison_json(const std::vector<ModeComparison>& comparisons);

}  // namespace anisofront
