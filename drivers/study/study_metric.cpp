#include "drivers/study/study.hpp"
#include "drivers/study/study_expressions.hpp"

namespace anisofront {
namespace {

std::optional<std::array<ExpressionText, 2>> parse_direction(TomlTable& entry) {
  if (!entry.has("e1")) return {};
  const std::vector<std::string> parts = entry.texts("e1");
  if (parts.size() != 2) entry.fail("e1", "expected two expressions [\"x part\", \"y part\"]");
  return {{ExpressionText{parts[0], entry.place("e1") + "[0]"},
           ExpressionText{parts[1], entry.place("e1") + "[1]"}}};
}

DirectionalSizes parse_sizes(TomlTable entry, const std::vector<NamedExpression>& shared) {
  DirectionalSizes sizes;
  sizes.place = entry.place();
  sizes.h1 = entry.required(entry.expression("h1"), "h1");
  sizes.h2 = entry.required(entry.expression("h2"), "h2");
  sizes.e1 = parse_direction(entry);
  sizes.distance_to = entry.texts("distance_to");
  sizes.where = shared;
  for (NamedExpression& own : read_where(entry)) sizes.where.push_back(std::move(own));
  entry.finish();
  return sizes;
}

std::vector<DirectionalSizes> parse_list(TomlTable& table,
                                         const std::vector<NamedExpression>& shared) {
  std::vector<DirectionalSizes> list;
  for (const TomlTable& entry : table.tables("prescribed"))
    list.push_back(parse_sizes(entry, shared));
  return list;
}

}  // namespace

PrescribedMetric parse_metric(TomlTable table, AdaptMode mode) {
  PrescribedMetric metric;
  metric.constants = read_constants(table);
  const std::vector<NamedExpression> shared = read_where(table);
  metric.list = parse_list(table, shared);
  // Both sub-tables are read, so that mistakes in the one not used are found too.
  for (const AdaptMode each : {AdaptMode::isotropic, AdaptMode::anisotropic}) {
    const std::string name = each == AdaptMode::isotropic ? "isotropic" : "anisotropic";
    auto sub = table.table(name);
    if (!sub) continue;
    if (table.has("prescribed"))
      table.fail(name, "give either prescribed or sub-tables isotropic and anisotropic");
    auto list = parse_list(*sub, shared);
    sub->finish();
    if (each == mode) metric.list = std::move(list);
  }
  metric.isotropic = mode == AdaptMode::isotropic && table.has("prescribed");
  table.finish();
  if (metric.list.empty())
    table.fail({}, std::string("prescribes nothing for adapt.mode = \"") +
                       (mode == AdaptMode::isotropic ? "isotropic" : "anisotropic") +
                       "\"; add prescribed = [{ h1 = \"...\", h2 = \"...\" }]");
  return metric;
}

}  // namespace anisofront
