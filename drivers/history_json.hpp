#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "adapt/history.hpp"

namespace anisofront {

using Json = nlohmann::ordered_json;

/// history.json, schema 1: {"schema":1, "title":..., "variants":[{"name", "settings", "cycles":
/// [...], "stop_reason"}]}.
///
/// A cycle holds the counts and, under "quality" (alpha~ of triangles, beta~ of quadrilaterals),
/// "edge_length", "angle" (corners, in the metric, degrees) and "metric_complexity", the statistics
/// against the exact formula of a prescribed metric ("against":"exact"); the object
/// "background" beside them holds the same four against the metric interpolated on the mesh that
/// served as background ("against":"background"). A problem has no exact metric: there both are
/// against the background. "scaled_jacobian_min" is that of the quadrilaterals in the plane (1
/// without any). Unknown errors are null.
Json history_json(const std::string& title, const std::vector<VariantHistory>& variants);

/// One line per variant and cycle with the columns of the JSON, for spreadsheets.
/// Precondition: `history` comes from history_json().
std::string history_csv(const Json& history);

/// Statistics as in a cycle of history.json; `against`: "exact" or "background".
Json statistics_json(const MeshStatistics& statistics, const std::string& against);

}  // namespace anisofront
