#include <algorithm>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_series.hpp"
#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

std::string band_data(const std::vector<const Json*>& variants) {
  std::string data =
      "# percent of the edges with a metric length between 1/sqrt(2) and sqrt(2)\n"
      "# cycle | percent; a block per variant\n";
  for (const Json* variant : variants) {
    data += "# " + one_line(variant->at("name").get<std::string>()) + "\n";
    for (const Json& cycle : variant->at("cycles"))
      data += fmt::format("{} {}\n", cycle.at("cycle").get<int>(),
                          cycle.at("edge_length").at("in_unit_band").get<double>());
    data += "\n\n";
  }
  return data;
}

}  // namespace

std::vector<Plot> band_plots(const Json& history) {
  std::vector<const Json*> variants;
  std::vector<CurveKind> kinds;
  int last = 1;
  for (const Json& variant : history.at("variants")) {
    if (variant.at("cycles").empty()) continue;
    variants.push_back(&variant);
    kinds.push_back(curve_kind(variant));
    last = std::max(last, variant.at("cycles").back().at("cycle").get<int>());
  }
  if (variants.empty()) return {};
  Plot plot{"unit-band",
            "Share of edges of unit length over the cycles",
            {},
            history.at("title"),
            band_data(variants),
            {},
            {}};
  plot.settings = fmt::format(
      "set xlabel 'cycle'\nset ylabel 'edges in the unit band (%)'\nset xrange [-0.2:{}.2]\n"
      "set xtics {}\nset yrange [0:103]\nset ytics 0, 20, 100\n",
      last, std::max(1, last / 10));
  const std::vector<CurveLook> looks = curve_looks(kinds);
  for (std::size_t i = 0; i < looks.size(); ++i)
    plot.items.push_back(
        {fmt::format("data index {} using 1:2 with linespoints {}", i, looks[i].style),
         looks[i].label});
  return {plot};
}

}  // namespace anisofront
