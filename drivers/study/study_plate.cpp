#include "drivers/study/study_plate.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/study/study_expressions.hpp"

namespace anisofront {
namespace {

/// Replaces the values of `material` that the table gives.
void read_material(TomlTable& table, const ExpressionNames& names, PlateMaterial& material) {
  material.young = read_positive_number(table, "young", names).value_or(material.young);
  material.thickness = read_positive_number(table, "thickness", names).value_or(material.thickness);
  material.shear_factor =
      read_positive_number(table, "shear_factor", names).value_or(material.shear_factor);
  material.poisson = read_number(table, "poisson_ratio", names).value_or(material.poisson);
  if (!(material.poisson > -1 && material.poisson < 0.5))
    table.fail("poisson_ratio",
               fmt::format("must lie between -1 and 0.5, found {}", material.poisson));
}

void require_material(TomlTable& table) {
  for (const char* key : {"thickness", "young", "poisson_ratio"})
    table.required(table.has(key) ? std::optional(true) : std::nullopt, key);
}

/// A force or couple does no work where the support holds what it acts on.
void check_contradictions(TomlTable& entry, const PlateBoundaryText& boundary) {
  const HeldComponents held = held_components(boundary.support);
  const auto refuse = [&](const char* key, const char* what) {
    entry.fail(key, fmt::format("contradicts support = \"{}\", which {}",
                                name_of(kSupportNames, boundary.support), what));
  };
  if (boundary.deflection && !held.deflection) refuse("deflection", "leaves the deflection free");
  if (boundary.shear && held.deflection) refuse("shear", "holds the deflection");
  if (boundary.moment && held.normal_rotation) refuse("moment", "holds the normal rotation");
  if (boundary.twist && held.tangential_rotation) refuse("twist", "holds the tangential rotation");
}

PlateBoundaryText read_condition(TomlTable entry, const std::string& curve,
                                 const ExpressionNames& names) {
  PlateBoundaryText boundary;
  boundary.curve = curve;
  boundary.place = entry.place();
  boundary.support = value_named(
      kSupportNames,
      entry.choice("support", names_of(kSupportNames), name_of(kSupportNames, SupportKind::free)));
  boundary.deflection = read_expression(entry, "deflection", names);
  boundary.shear = read_expression(entry, "shear", names);
  boundary.moment = read_expression(entry, "moment", names);
  boundary.twist = read_expression(entry, "twist", names);
  entry.finish();
  check_contradictions(entry, boundary);
  return boundary;
}

/// boundary.NAME = "clamped", or = { support = "clamped", ... }.
std::vector<PlateBoundaryText> read_boundary(TomlTable& problem, const ExpressionNames& names) {
  std::vector<PlateBoundaryText> list;
  auto table = problem.table("boundary");
  if (!table) return list;
  for (const std::string& curve : table->keys()) {
    if (table->is_table(curve)) {
      list.push_back(read_condition(*table->table(curve), curve, names));
      continue;
    }
    PlateBoundaryText boundary;
    boundary.curve = curve;
    boundary.place = table->place(curve);
    boundary.support =
        value_named(kSupportNames, table->choice(curve, names_of(kSupportNames), ""));
    list.push_back(boundary);
  }
  return list;
}

std::vector<PlateRegionText> read_regions(TomlTable& problem, const PlateProblemText& text) {
  std::vector<PlateRegionText> regions;
  auto table = problem.table("regions");
  if (!table) return regions;
  for (const std::string& name : table->keys()) {
    TomlTable entry = table->required(table->table(name), name);
    PlateRegionText region{name, text.material, {}, entry.place()};
    read_material(entry, text.names, region.material);
    region.load = read_expression(entry, "load", text.names);
    entry.finish();
    regions.push_back(region);
  }
  return regions;
}

/// { at, force }, or { at, deflection, rotations }.
void read_points(TomlTable& problem, PlateProblemText& text) {
  for (TomlTable& entry : problem.tables("points")) {
    const Point at = entry.required(entry.point("at"), "at");
    const auto force = read_number(entry, "force", text.names);
    const auto deflection = read_number(entry, "deflection", text.names);
    const auto rotations = entry.boolean("rotations");
    entry.finish();
    if (force.has_value() == deflection.has_value())
      entry.fail({}, "expected either force = ... or deflection = ...");
    if (force && rotations)
      entry.fail("rotations", "goes with deflection: true holds the rotations there too");
    if (force) text.point_loads.push_back({at, *force});
    if (deflection) text.point_supports.push_back({at, *deflection, rotations.value_or(false)});
  }
}

}  // namespace

PlateProblemText parse_plate_problem(TomlTable table) {
  PlateProblemText text;
  text.place = table.place();
  text.names = read_names(table);
  text.element = value_named(kPlateElementNames,
                             table.choice("element", names_of(kPlateElementNames),
                                          name_of(kPlateElementNames, PlateElement::mitc)));
  read_material(table, text.names, text.material);
  require_material(table);
  text.load = read_expression(table, "load", text.names).value_or(text.load);
  text.regions = read_regions(table, text);
  text.boundary = read_boundary(table, text.names);
  read_points(table, text);
  table.finish();
  return text;
}

}  // namespace anisofront
