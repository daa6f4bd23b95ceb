#include "drivers/run/solution_json.hpp"

#include <algorithm>

namespace anisofront {
namespace {

Json mesh_json(const FeMesh& mesh) {
  return {
      {"vertices", mesh.mesh.points.size()},
      {"triangles", mesh.mesh.triangles.size()},
      {"quads", mesh.mesh.quads.size()},
      {"edges", mesh.edges.count()},
      {"boundary_edges", mesh.mesh.edges.size()},
      {"curved_edges", std::count(mesh.edge_is_bent.begin(), mesh.edge_is_bent.end(), char{1})}};
}

Json linear_json(const LinearReport& r) {
  const auto known = [](double value) { return value > 0 ? Json(value) : Json(nullptr); };
  return {{"method", r.method},
          {"unknowns", r.unknowns},
          {"nonzeros", r.nonzeros},
          {"factor_nonzeros", known(r.factor_nonzeros)},
          {"condition", known(r.condition)},
          {"residual", r.residual},
          {"refinements", r.refinements},
          {"iterations", r.iterations}};
}

Json settings_json(const SolutionRecord& record) {
  Json settings = record.solved.settings;
  for (const Override& value : record.variant.values) {
    const Json parsed = Json::parse(value.value, nullptr, false);
    settings[value.key] = parsed.is_discarded() ? Json(value.value) : parsed;
  }
  return settings;
}

Json value_json(const SampledValue& value, const std::vector<std::string>& quantities) {
  Json json{{"name", value.name}, {"at", {value.at.x, value.at.y}}};
  for (std::size_t i = 0; i < quantities.size(); ++i) json[quantities[i]] = value.state[i];
  return json;
}

/// One array per column.
Json line_json(const Profile& line) {
  Json json{{"name", line.name}};
  for (std::size_t i = 0; i < line.values.columns.size(); ++i) {
    Json column = Json::array();
    for (const std::vector<double>& row : line.values.rows) column.push_back(row[i]);
    json[line.values.columns[i]] = std::move(column);
  }
  return json;
}

Json seconds_json(const SolutionRecord& record) {
  const LinearReport& linear = record.solved.linear;
  return {{"mesh", record.seconds.mesh},     {"assembly", record.solved.assembly_seconds},
          {"factor", linear.factor_seconds}, {"solve", linear.solve_seconds},
          {"fields", record.seconds.fields}, {"total", record.seconds.total}};
}

}  // namespace

Json solution_json(const SolutionRecord& record) {
  const Study& study = record.variant.study;
  Json json{{"schema", 1},
            {"title", study.title},
            {"variant", record.variant.name},
            {"kind", study.plate ? "mindlin" : "poisson"},
            {"settings", settings_json(record)},
            {"mesh", mesh_json(record.mesh)},
            {"unknowns", record.solved.linear.unknowns},
            {"linear", linear_json(record.solved.linear)}};
  json.update(record.solved.totals);
  json["values"] = Json::array();
  for (const SampledValue& value : record.samples.values)
    json["values"].push_back(value_json(value, record.solved.state.quantities.at_point));
  json["lines"] = Json::array();
  for (const Profile& line : record.samples.lines) json["lines"].push_back(line_json(line));
  json["warnings"] = record.warnings;
  json["seconds"] = seconds_json(record);
  return json;
}

}  // namespace anisofront
