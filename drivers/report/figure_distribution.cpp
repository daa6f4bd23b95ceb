#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

/// What is counted: a histogram of each cycle.
struct Distribution {
  const char* key;   ///< of a cycle in history.json
  const char* stem;  ///< end of the file name
  const char* quantity;
  const char* counted;
  const char* caption;
};
constexpr Distribution kLengths{"edge_length", "edge-lengths", "edge length in the metric", "edges",
                                "Edge lengths per cycle"};
constexpr Distribution kQualities{"quality", "quality", "quality of the elements", "elements",
                                  "Quality of the elements per cycle"};

bool has_histogram(const Json& cycle, const Distribution& what) {
  return cycle.at(what.key).contains("histogram");
}

struct Histogram {
  std::vector<double> bounds;  ///< upper bounds of the bins; the last bin may have none
  std::vector<double> percent;
};

Histogram histogram_of(const Json& cycle, const Distribution& what) {
  const Json& json = cycle.at(what.key).at("histogram");
  Histogram histogram{json.at("bounds"), json.at("counts")};
  double sum = 0;
  for (const double count : histogram.percent) sum += count;
  for (double& value : histogram.percent) value *= sum > 0 ? 100 / sum : 0;
  return histogram;
}

double upper_bound(const Histogram& histogram, std::size_t bin) {
  const std::vector<double>& bounds = histogram.bounds;
  if (bin < bounds.size()) return bounds[bin];
  return 2 * bounds.back() - bounds.at(bounds.size() - 2);
}

double middle(const Histogram& histogram, std::size_t bin) {
  return ((bin == 0 ? 0 : upper_bound(histogram, bin - 1)) + upper_bound(histogram, bin)) / 2;
}

std::string cycle_name(const Json& cycle) {
  const int number = cycle.at("cycle");
  return number == 0 ? "initial mesh" : fmt::format("cycle {}", number);
}

std::string distribution_data(const Json& cycles, const std::vector<Histogram>& histograms,
                              const Distribution& what) {
  std::string data = fmt::format("# percent of the {} per bin\n# {}: middle of the bin",
                                 what.counted, what.quantity);
  for (const Json& cycle : cycles) data += fmt::format(" | {}", cycle_name(cycle));
  data += '\n';
  for (std::size_t bin = 0; bin < histograms.front().percent.size(); ++bin) {
    data += fmt::format("{:.3f}", middle(histograms.front(), bin));
    for (const Histogram& histogram : histograms)
      data += fmt::format(" {:.6g}", histogram.percent.at(bin));
    data += '\n';
  }
  return data;
}

/// Least round percentage above all bins with an upper bound; the open bin of a bad initial mesh
/// would make the others flat.
double top_percent(const std::vector<Histogram>& histograms) {
  double top = 1;
  for (const Histogram& histogram : histograms)
    for (std::size_t bin = 0; bin < histogram.bounds.size() && bin < histogram.percent.size();
         ++bin)
      top = std::max(top, histogram.percent[bin]);
  const double step = top > 20 ? 10 : top > 5 ? 5 : 1;
  return std::min(step * std::ceil(1.02 * top / step), 100.);
}

std::vector<PlotItem> cycle_curves(const Json& cycles) {
  const std::size_t last = cycles.size() - 1;
  std::vector<PlotItem> curves;
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const bool is_initial = cycles[k].at("cycle") == 0;
    const std::string look = is_initial
                                 ? "linestyle 50"
                                 : fmt::format("linecolor palette frac shade({}, {}) linewidth {}",
                                               k, last, k == last ? "2" : "1.2");
    curves.push_back(
        {fmt::format("data using 1:{} with lines {}", k + 2, look), cycle_name(cycles[k])});
  }
  return curves;
}

/// The last bin, which has no upper bound, is labelled by its lower one.
std::string length_axis(const Histogram& histogram) {
  const double last = histogram.bounds.back();
  return fmt::format(
      "set xrange [0:{0:g}]\nset xtics 0, 0.5, {1:g}\nset xtics add ('≥ {2:g}' {3:g})\n"
      "set object 1 rectangle from sqrt(0.5), graph 0 to sqrt(2), graph 1 "
      "fillcolor rgb band_colour fillstyle solid noborder behind\n",
      upper_bound(histogram, histogram.bounds.size()), last - 0.5, last,
      middle(histogram, histogram.bounds.size()));
}

Plot distribution_plot(const Json& variant, const Distribution& what) {
  const Json& cycles = variant.at("cycles");
  std::vector<Histogram> histograms;
  for (const Json& cycle : cycles) histograms.push_back(histogram_of(cycle, what));
  const std::string name = variant.at("name");
  Plot plot{fmt::format("{}-{}", file_stem(name), what.stem), what.caption, name, name, {}, {}, {}};
  plot.data = distribution_data(cycles, histograms, what);
  plot.settings = fmt::format("set xlabel '{}'\nset ylabel '{} (%)'\nset yrange [0:{:g}]\n",
                              what.quantity, what.counted, top_percent(histograms));
  plot.items = cycle_curves(cycles);
  if (histograms.front().percent.size() == histograms.front().bounds.size()) {
    plot.settings += "set xrange [0:1]\n";
    return plot;
  }
  plot.settings += length_axis(histograms.front());
  plot.items.push_back({"NaN with boxes fillcolor rgb band_colour", "unit band"});
  return plot;
}

}  // namespace

std::vector<Plot> distribution_plots(const Json& variant) {
  std::vector<Plot> plots;
  const Json& cycles = variant.at("cycles");
  for (const Distribution& what : {kLengths, kQualities})
    if (!cycles.empty() && std::all_of(cycles.begin(), cycles.end(), [&](const Json& cycle) {
          return has_histogram(cycle, what);
        }))
      plots.push_back(distribution_plot(variant, what));
  return plots;
}

}  // namespace anisofront
