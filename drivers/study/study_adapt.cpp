#include "drivers/study/study_adapt.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include <spdlog/fmt/fmt.h>

#include "drivers/study/element_names.hpp"

namespace anisofront {
namespace {

constexpr Index kMaxCycles = 1000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<Named<AdaptMode>, 2> kModeNames{
    {{"anisotropic", AdaptMode::anisotropic}, {"isotropic", AdaptMode::isotropic}}};
constexpr std::array<Named<Combination>, 2> kCombinationNames{
    {{"sum-of-squares", Combination::sum_of_squares}, {"intersection", Combination::intersection}}};
constexpr std::array<Named<Goal::Kind>, 3> kGoalNames{{{"patch-mean", Goal::Kind::patch_mean},
                                                       {"region-mean", Goal::Kind::region_mean},
                                                       {"flux", Goal::Kind::curve_flux}}};

std::optional<double> positive_integer(TomlTable& table, const std::string& key) {
  const auto value = table.integer(key);
  if (value == Index{0}) table.fail(key, "must be positive");
  return value;
}

void read_target(TomlTable& adapt, Target& target) {
  auto table = adapt.table("target");
  if (!table) return;
  target.error = table->positive("error");
  target.vertices = positive_integer(*table, "nodes");
  table->finish();
  if (target.error.has_value() == target.vertices.has_value())
    table->fail({}, "expected one of { nodes = 1000 } and { error = 0.01 }");
}

/// A positive number, or false for `none`.
std::optional<double> read_limit(TomlTable& table, const std::string& key, double none) {
  if (!table.is_boolean(key)) return table.positive(key);
  if (*table.boolean(key)) table.fail(key, "expected a positive number, or false for no limit");
  return none;
}

void read_limits(TomlTable& adapt, LimitsText& limits) {
  auto table = adapt.table("limits");
  if (!table) return;
  limits.hmin = read_limit(*table, "hmin", 0);
  limits.hmax = read_limit(*table, "hmax", kInfinity);
  limits.stretch = read_limit(*table, "stretch", kInfinity);
  limits.gradation = read_limit(*table, "gradation", 0);
  if (limits.hmin && limits.hmax && *limits.hmin > *limits.hmax)
    table->fail("hmin", fmt::format("{} is larger than hmax = {}", *limits.hmin, *limits.hmax));
  if (limits.stretch && *limits.stretch < 1)
    table->fail("stretch", "is a ratio of sizes and must be at least 1");
  if (limits.gradation && *limits.gradation > 0 && *limits.gradation <= 1)
    table->fail("gradation", "is a ratio of sizes and must be larger than 1");
  table->finish();
}

/// norm = "energy", or "L2", "L1.5", ...
void read_norm(TomlTable& table, AdaptSection& adapt) {
  const std::string text = table.text("norm").value_or("L2");
  if (text == "energy") {
    adapt.norm = MetricNorm::energy;
    return;
  }
  const char* const end = text.data() + text.size();
  double p = 0;
  const bool is_lp = text.starts_with("L") &&
                     std::from_chars(text.data() + 1, end, p) == std::from_chars_result{end, {}};
  if (!is_lp || !(p >= 1) || !std::isfinite(p))
    table.fail("norm",
               fmt::format("found \"{}\", expected \"energy\" or \"Lp\" with p at least 1, such as "
                           "\"L2\"",
                           text));
  adapt.p = p;
}

double read_floor(TomlTable& table, double fallback) {
  const double floor = table.positive("curvature_floor").value_or(fallback);
  if (floor >= 1)
    table.fail("curvature_floor", "is a share of the largest curvature and must be smaller than 1");
  return floor;
}

LayerText read_layer(TomlTable& adapt) {
  LayerText layer;
  layer.place = adapt.place("layer");
  if (adapt.is_boolean("layer")) {
    if (*adapt.boolean("layer"))
      adapt.fail("layer",
                 "expected false, or a table such as { curves = [\"wall\"], width = 0.01 }");
    layer.is_on = false;
    return layer;
  }
  auto table = adapt.table("layer");
  if (!table) return layer;
  if (table->has("curves")) layer.curves = table->texts("curves");
  layer.width = table->positive("width");
  layer.first_size = table->positive("first_size");
  layer.reach = table->positive("reach");
  layer.growth = table->number("growth");
  layer.metric = table->boolean("metric");
  table->finish();
  if (layer.growth && *layer.growth < 0) table->fail("growth", "must not be negative");
  return layer;
}

std::optional<GoalText> read_goal(TomlTable& adapt) {
  auto table = adapt.table("goal");
  if (!table) return {};
  GoalText text;
  text.place = table->place();
  const auto kind = table->required(table->text("kind"), "kind");
  text.goal.kind = value_named(kGoalNames, table->choice("kind", names_of(kGoalNames), kind));
  switch (text.goal.kind) {
    case Goal::Kind::patch_mean:
      text.goal.at = table->required(table->point("at"), "at");
      text.goal.radius = table->required(table->positive("radius"), "radius");
      break;
    case Goal::Kind::region_mean:
      text.name = table->required(table->text("region"), "region");
      break;
    case Goal::Kind::curve_flux:
      text.name = table->required(table->text("curve"), "curve");
      break;
  }
  text.steers = table->boolean("steer").value_or(true);
  table->finish();
  return text;
}

std::optional<ReferenceText> read_reference(TomlTable& adapt) {
  if (adapt.is_boolean("reference"))
    return *adapt.boolean("reference") ? std::optional(ReferenceText{}) : std::nullopt;
  auto table = adapt.table("reference");
  if (!table) return {};
  const ReferenceText reference{table->required(positive_integer(*table, "nodes"), "nodes")};
  table->finish();
  return reference;
}

void read_stop_rules(TomlTable& adapt, StopRules& stop) {
  stop.plateau = adapt.positive("plateau").value_or(stop.plateau);
  if (stop.plateau >= 1)
    adapt.fail("plateau", "is the share by which the estimate still changes, such as 0.05");
  auto budget = adapt.table("budget");
  if (!budget) return;
  stop.max_vertices = budget->integer("nodes").value_or(0);
  stop.max_seconds = budget->positive("seconds").value_or(0);
  budget->finish();
  if (stop.max_vertices == 0 && stop.max_seconds == 0)
    budget->fail({}, "expected nodes = 100000, seconds = 60, or both");
}

/// The metric of a goal is that of its error: p = 1, weighted sum of squares.
void check_goal(TomlTable& table, const AdaptSection& adapt) {
  if (!adapt.goal || !adapt.goal->steers) return;
  for (const char* key : {"norm", "combination"})
    if (table.has(key))
      table.fail(key,
                 "a goal has a metric of its own; leave this out, or write goal.steer = false");
}

}  // namespace

AdaptSection parse_adapt(TomlTable table) {
  AdaptSection adapt;
  adapt.cycles = table.integer("cycles").value_or(adapt.cycles);
  if (adapt.cycles > kMaxCycles)
    table.fail("cycles", fmt::format("more than {} cycles", kMaxCycles));
  adapt.mode =
      value_named(kModeNames, table.choice("mode", names_of(kModeNames), kModeNames[0].name));
  read_target(table, adapt.target);
  read_limits(table, adapt.limits);
  read_norm(table, adapt);
  adapt.combination = value_named(
      kCombinationNames,
      table.choice("combination", names_of(kCombinationNames), kCombinationNames[0].name));
  adapt.curvature_floor = read_floor(table, adapt.curvature_floor);
  adapt.align = table.boolean("align").value_or(adapt.align);
  adapt.equidistribute = table.boolean("equidistribute").value_or(adapt.equidistribute);
  adapt.layer = read_layer(table);
  adapt.goal = read_goal(table);
  adapt.reference = read_reference(table);
  read_stop_rules(table, adapt.stop);
  adapt.stages = table.boolean("stages").value_or(adapt.stages);
  table.finish();
  check_goal(table, adapt);
  return adapt;
}

const std::vector<std::string>& keys_for_problems() {
  static const std::vector<std::string> keys{
      "target",         "norm",  "combination", "curvature_floor", "align",
      "equidistribute", "layer", "goal",        "reference",       "plateau"};
  return keys;
}

}  // namespace anisofront
