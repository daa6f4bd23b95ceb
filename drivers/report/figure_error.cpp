#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_series.hpp"
#include "drivers/report/figure_slope.hpp"
#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

using Values = std::optional<double> SeriesPoint::*;

/// Where a logarithm can be taken.
bool is_drawn(const SeriesPoint& point, Values value) {
  return point.unknowns > 0 && point.*value && *(point.*value) > 0;
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "NaN";
}

std::string point_line(const SeriesPoint& p) {
  const auto positive = [](const std::optional<double>& value) {
    return value && *value > 0 ? value : std::nullopt;
  };
  std::string variant = one_line(p.variant);
  std::replace(variant.begin(), variant.end(), '"', '\'');
  return fmt::format("{} {} {} {} {} \"{}\"\n", p.unknowns, number(positive(p.error)),
                     number(positive(p.estimate)), number(p.effectivity), p.cycle, variant);
}

/// Two blocks per series: the curve and the cycles before.
std::string error_data(const std::vector<Series>& all) {
  std::string data =
      "# relative errors in the energy norm\n"
      "# unknowns | true error | estimate | effectivity | cycle | variant\n";
  std::size_t block = 0;
  for (const Series& series : all)
    for (const auto* points : {&series.curve, &series.before}) {
      data += fmt::format("# block {}: {}{}\n", block++, one_line(series.kind.label),
                          points == &series.curve ? "" : ", cycles on the way");
      for (const SeriesPoint& point : *points) data += point_line(point);
      data += points->empty() ? "NaN NaN NaN NaN NaN \"\"\n\n\n" : "\n\n";
    }
  return data;
}

bool any_drawn(const std::vector<Series>& all, Values value,
               std::vector<SeriesPoint> Series::*points = &Series::curve) {
  return std::any_of(all.begin(), all.end(), [&](const Series& series) {
    return std::any_of((series.*points).begin(), (series.*points).end(),
                       [&](const SeriesPoint& point) { return is_drawn(point, value); });
  });
}

struct Range {
  double low = HUGE_VAL, high = 0;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
};

/// The axes of unknowns and of values, both with all that is drawn on them.
struct Axes {
  Range unknowns, values;
};
Axes axes_of(const std::vector<Series>& all, const std::vector<Values>& values) {
  Axes axes;
  for (const Series& series : all)
    for (const auto* points : {&series.curve, &series.before})
      for (const SeriesPoint& point : *points)
        for (const Values value : values)
          if (is_drawn(point, value)) {
            axes.unknowns.add(point.unknowns);
            axes.values.add(*(point.*value));
          }
  return axes;
}

std::vector<CurveLook> looks_of(const std::vector<Series>& all) {
  std::vector<CurveKind> kinds;
  for (const Series& series : all) kinds.push_back(series.kind);
  return curve_looks(kinds);
}

/// Whether every cycle has clearly more unknowns than the one before. Cycles towards a target size
/// have not: the mesh gets better at a fixed size, which tells nothing about the order.
bool grows(const std::vector<ErrorPoint>& points) {
  constexpr double kLeast = 1.1;
  const auto stays = [](const ErrorPoint& before, const ErrorPoint& after) {
    return after.first < kLeast * before.first;
  };
  return std::adjacent_find(points.begin(), points.end(), stays) == points.end();
}

/// The points of a curve from which its order can be measured.
std::vector<ErrorPoint> order_points(const Series& series, Values value) {
  const bool is_single = series.curve.front().variant == series.curve.back().variant;
  std::vector<ErrorPoint> points;
  for (const SeriesPoint& point : series.curve)
    if (is_drawn(point, value) && !(is_single && point.cycle == 0))
      points.emplace_back(point.unknowns, *(point.*value));
  if (is_single && !grows(points)) points.clear();
  return points;
}

std::vector<ReferenceSlope> slopes_of(const std::vector<Series>& all, Values value) {
  std::vector<std::vector<ErrorPoint>> curves;
  for (const Series& series : all) curves.push_back(order_points(series, value));
  return reference_slopes(curves);
}

std::string order_words(double order) {
  const double rounded = std::round(order);
  return order == rounded ? fmt::format("−{:g}", order) : fmt::format("−{:g}/2", 2 * order);
}

/// A line as one more block of the data, its slope written below the right end.
void add_slope(Plot& plot, const ReferenceSlope& slope, std::size_t block) {
  const auto value = [&](double unknowns) {
    return slope.factor * std::pow(unknowns, -slope.order);
  };
  plot.data += fmt::format("# block {}: slope -{:g}\n", block, slope.order);
  for (const double unknowns : {slope.first, slope.last})
    plot.data += fmt::format("{} {}\n", unknowns, value(unknowns));
  plot.data += "\n\n";
  plot.items.push_back({fmt::format("data index {} using 1:2 with lines linestyle 52", block), {}});
  plot.settings += fmt::format("set label '{}' at {:g}, {:g} right offset 0, -0.8\n",
                               order_words(slope.order), slope.last, value(slope.last));
}

/// Column of a quantity in the data.
int column(Values value) {
  if (value == &SeriesPoint::error) return 2;
  return value == &SeriesPoint::estimate ? 3 : 4;
}

/// The main curves have the labels and the cycles on the way; others are dashed.
enum class Role { main, other };

void add_curves(Plot& plot, const std::vector<Series>& all, Values value, Role role) {
  const std::vector<CurveLook> looks = looks_of(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    plot.items.push_back(
        {fmt::format("data index {} using 1:{} with linespoints {}{}", 2 * i, column(value),
                     looks[i].style, role == Role::main ? "" : " dashtype 2"),
         role == Role::main ? looks[i].label : ""});
    if (role == Role::main && !all[i].before.empty())
      plot.items.push_back({fmt::format("data index {} using 1:{} with points {} pointsize 0.2",
                                        2 * i + 1, column(value), looks[i].style),
                            {}});
  }
}

Plot error_plot(const std::vector<Series>& all, const std::string& title) {
  const bool has_true = any_drawn(all, &SeriesPoint::error);
  const bool has_estimate = any_drawn(all, &SeriesPoint::estimate);
  const Values best = has_true ? &SeriesPoint::error : &SeriesPoint::estimate;
  Plot plot{"error", "Error against the number of unknowns", {}, title, error_data(all), {}, {}};
  Axes axes = axes_of(all, {&SeriesPoint::error, &SeriesPoint::estimate});
  const std::vector<ReferenceSlope> slopes = slopes_of(all, best);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    axes.values.add(0.5 * slopes[i].factor * std::pow(slopes[i].last, -slopes[i].order));
    add_slope(plot, slopes[i], 2 * all.size() + i);
  }
  add_curves(plot, all, best, Role::main);
  if (has_true && has_estimate) {
    add_curves(plot, all, &SeriesPoint::estimate, Role::other);
    plot.items.push_back({"NaN with lines linestyle 53", "estimate"});
  }
  if (any_drawn(all, best, &Series::before))
    plot.items.push_back({"NaN with points linestyle 54", "cycles on the way"});
  plot.settings += fmt::format("set xlabel 'unknowns'\nset ylabel '{}'\n{}{}",
                               has_true ? "relative energy error" : "estimated relative error",
                               log_axis('x', axes.unknowns.low, axes.unknowns.high),
                               log_axis('y', axes.values.low, axes.values.high));
  return plot;
}

/// From 0 on, or logarithmic where some are far off.
std::string effectivity_axis(const Range& values) {
  constexpr double kFar = 4;
  if (values.high > kFar || values.low < 1 / kFar)
    return log_axis('y', std::min(values.low, 0.5), std::max(values.high, 2.));
  return fmt::format("set yrange [0:{:g}]\n", std::max(1.5, std::ceil(2.1 * values.high) / 2));
}

Plot effectivity_plot(const std::vector<Series>& all, const std::string& title) {
  Plot plot{"effectivity", "Estimated over true error", {}, title, error_data(all), {}, {}};
  const Axes axes = axes_of(all, {&SeriesPoint::effectivity});
  plot.settings = "set xlabel 'unknowns'\nset ylabel 'effectivity'\n" +
                  log_axis('x', axes.unknowns.low, axes.unknowns.high) +
                  effectivity_axis(axes.values);
  plot.items.push_back({"1 with lines linestyle 52", {}});
  add_curves(plot, all, &SeriesPoint::effectivity, Role::main);
  if (any_drawn(all, &SeriesPoint::effectivity, &Series::before))
    plot.items.push_back({"NaN with points linestyle 54", "cycles on the way"});
  return plot;
}

}  // namespace

std::vector<Plot> error_plots(const Json& history) {
  const std::vector<Series> all = error_series(history);
  std::vector<Plot> plots;
  const std::string title = history.at("title");
  if (any_drawn(all, &SeriesPoint::error) || any_drawn(all, &SeriesPoint::estimate))
    plots.push_back(error_plot(all, title));
  if (any_drawn(all, &SeriesPoint::effectivity)) plots.push_back(effectivity_plot(all, title));
  return plots;
}

}  // namespace anisofront
