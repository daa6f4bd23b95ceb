#include "drivers/report/figure_plot.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

constexpr double kWidth = 8.5;  // cm, of the legend

std::vector<std::string> labels_of(const Plot& plot) {
  std::vector<std::string> labels;
  for (const PlotItem& item : plot.items)
    if (!item.label.empty()) labels.push_back(item.label);
  return labels;
}

std::string item_text(const PlotItem& item) {
  return item.drawing + (item.label.empty() ? " notitle" : " title " + gnuplot_string(item.label));
}

/// 1, 2 or 5 times a power of ten, the greatest not above `value`.
double round_below(double value) {
  const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
  for (const double digit : {5., 2.})
    if (digit * power <= value * (1 + 1e-9)) return digit * power;
  return power;
}

double next_round(double value) {
  const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
  const double digit = std::round(value / power);
  return (digit < 2 ? 2 : digit < 5 ? 5 : 10) * power;
}

/// Without tics those of gnuplot.
std::string log_range(char axis, double first, double last, const std::vector<double>& tics) {
  std::string list;
  for (const double tic : tics) list += fmt::format("{}{:g}", list.empty() ? "" : ", ", tic);
  if (!list.empty()) list = fmt::format("set {}tics ({})\n", axis, list);
  return fmt::format("set logscale {0}\nset {0}range [{1:g}:{2:g}]\n", axis, first, last) + list;
}

/// Round numbers are too far from each other here: tics in equal steps.
std::string narrow_log_axis(char axis, double low, double high) {
  constexpr double kBlank = 1.15;
  const double first = low / kBlank, last = high * kBlank, step = round_step(last - first, 4);
  std::vector<double> tics;
  for (double tic = step * std::ceil(first / step); tic <= last; tic += step) tics.push_back(tic);
  return log_range(axis, first, last, tics);
}

}  // namespace

std::string plot_script(const Plot& plot) {
  const LegendLayout legend = legend_layout(labels_of(plot), kWidth);
  std::string script = fmt::format(
      "# {1}{2}\n# `gnuplot {0}.gp` draws {0}.svg, {0}.pdf and {0}.png from {0}.dat.\n"
      "reset\nname = '{0}'\ndata = '{0}.dat'\nload 'formats.gp'\nload 'style.gp'\n"
      "legend_rows = {3}; legend_surplus = {4:.2g}\n",
      plot.stem, one_line(plot.caption), plot.variant.empty() ? "" : ": " + one_line(plot.variant),
      legend.rows, legend.surplus);
  script += fmt::format("set title {} noenhanced\n", gnuplot_string(shortened(plot.title, 48)));
  script += plot.settings + "do for [format in formats(wanted)] {\n  eval begin(format)\n  plot ";
  for (std::size_t i = 0; i < plot.items.size(); ++i)
    script += (i == 0 ? "" : ", \\\n    ") + item_text(plot.items[i]);
  return script + "\n}\nunset output\n";
}

double round_step(double length, int most) {
  const double step = round_below(length / most);
  return step * most < length * (1 - 1e-9) ? next_round(step) : step;
}

std::string log_axis(char axis, double low, double high) {
  constexpr double kManyDecades = 100, kNarrow = 2;
  if (high < kNarrow * low) return narrow_log_axis(axis, low, high);
  const double first = round_below(low);
  std::vector<double> tics{first};
  while (tics.back() < high * (1 - 1e-9)) tics.push_back(next_round(tics.back()));
  if (tics.back() < kManyDecades * first) return log_range(axis, first, tics.back(), tics);
  return log_range(axis, first, tics.back(), {}) + fmt::format("set format {} '10^{{%L}}'\n", axis);
}

std::string row_axis(const std::vector<std::string>& labels, double pitch) {
  constexpr std::size_t kLongest = 48, kMany = 24;
  constexpr double kPlot = 5.6;  // cm, least width of the bars
  double longest = 0;
  std::string tics;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string label = shortened(labels[i], kLongest);
    longest = std::max(longest, text_width(label));
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", \\\n  ", gnuplot_string(label), -1 - int(i));
  }
  const auto rows = static_cast<double>(labels.size());
  const double left = 0.35 + longest, height = 2 + pitch * std::max(rows, 1.6 / pitch);
  return fmt::format(
      "left = {:.2f}\nwidth = left + {:g} > width ? left + {:g} : width\nheight = {:.2f}\n"
      "set yrange [{:g}:-0.4]\nunset grid\nset grid xtics\nset border 1\n"
      "set ytics ({}) scale 0 noenhanced{}\n",
      left, kPlot, kPlot, height, -0.6 - rows, tics, labels.size() > kMany ? " font ',6'" : "");
}

}  // namespace anisofront
