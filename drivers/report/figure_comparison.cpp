#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_label.hpp"
#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

std::string number(const Json& value) { return value.is_number() ? value.dump() : "0"; }

std::string comparison_data(const Json& comparisons, const std::vector<std::string>& labels) {
  std::string data =
      "# isotropic and anisotropic meshes at equal error; 0: no mesh with so large an error\n"
      "# row | vertices: isotropic | anisotropic | ratio | unknowns: isotropic | anisotropic | "
      "ratio | error | of which kind | what\n";
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Json& c = comparisons[i];
    data += fmt::format("{}", -1 - static_cast<int>(i));
    for (const char* what : {"vertices", "dofs"})
      for (const char* side : {"isotropic", "anisotropic", "ratio"})
        data += " " + number(c.at(side).at(what));
    std::string label = one_line(labels[i]);
    std::replace(label.begin(), label.end(), '"', '\'');
    data += fmt::format(" {} {} \"{}\"\n", number(c.at("error")),
                        c.at("against").get<std::string>(), label);
  }
  return data;
}

std::vector<std::string> labels_of(const Json& comparisons) {
  std::vector<Json> settings;
  for (const Json& comparison : comparisons) settings.push_back(comparison.at("settings"));
  std::vector<std::string> labels = distinguishing_labels(settings);
  if (labels.size() == 1) labels.front() = "all variants";
  return labels;
}

/// Numbers of vertices that are known.
std::vector<double> sizes_of(const Json& comparisons) {
  std::vector<double> sizes;
  for (const Json& comparison : comparisons)
    for (const char* mode : {"isotropic", "anisotropic"}) {
      const Json& vertices = comparison.at(mode).at("vertices");
      if (vertices.is_number() && vertices > 0) sizes.push_back(vertices);
    }
  return sizes;
}

/// Bars of one mode between the heights `low` and `high` of each row, with their numbers.
void add_bars(Plot& plot, int column, double low, double high, const std::string& mode) {
  plot.items.push_back(
      {fmt::format("data using {0}:1:(1):{0}:($1+{1:g}):($1+{2:g}) with boxxyerror "
                   "linestyle {3}",
                   column, low, high, column == 2 ? 11 : 1),
       mode});
}

/// A text at the end of each bar; where there is none, why: nothing is extrapolated.
void add_numbers(Plot& plot, int column, double height, const std::string& text) {
  plot.items.push_back(
      {fmt::format("data using (${0} > 0 ? ${0} : 1.02*first):($1+{1:g}):(${0} > 0 ? {2} : "
                   "'no mesh with so large an error') with labels left offset 0.4, 0",
                   column, height, text),
       {}});
}

std::string size_axis(const std::vector<double>& sizes) {
  const auto [low, high] = std::minmax_element(sizes.begin(), sizes.end());
  const double first = std::pow(10, std::floor(std::log10(*low / 1.5)));
  const double last = std::pow(*high / first, 1.65) * first;  // room for the numbers
  return fmt::format(
      "first = {0:g}\nset logscale x\nset xrange [{0:g}:{1:.6g}]\nset format x '10^{{%L}}'\n",
      first, last);
}

}  // namespace

std::vector<Plot> comparison_plots(const Json& history) {
  const Json comparisons = history.value("comparison", Json::array());
  const std::vector<double> sizes = sizes_of(comparisons);
  if (sizes.empty()) return {};
  const std::vector<std::string> labels = labels_of(comparisons);
  Plot plot{"comparison",
            "Vertices of isotropic and anisotropic meshes at equal error",
            {},
            history.at("title"),
            comparison_data(comparisons, labels),
            {},
            {}};
  plot.settings =
      row_axis(labels, 0.72) + size_axis(sizes) + "set xlabel 'vertices at equal error'\n";
  add_bars(plot, 2, 0.02, 0.36, "isotropic");
  add_bars(plot, 3, -0.36, -0.02, "anisotropic");
  add_numbers(plot, 2, 0.19, "sprintf('%.0f', $2)");
  add_numbers(plot, 3, -0.19, "sprintf($4 > 0 ? '%.0f (× %.2g)' : '%.0f', $3, $4)");
  return {plot};
}

}  // namespace anisofront
