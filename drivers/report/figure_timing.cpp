#include <algorithm>
#include <array>
#include <numeric>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

constexpr std::array<const char*, 6> kStages{"metric", "front", "enhance",
                                             "quads",  "solve", "estimate"};

struct Bar {
  std::string label;
  std::array<double, kStages.size()> seconds{};
};

void add(Bar& bar, const Json& seconds) {
  for (std::size_t i = 0; i < kStages.size(); ++i) bar.seconds[i] += seconds.value(kStages[i], 0.);
}

std::vector<Bar> bars_of(const Json& variants) {
  std::vector<Bar> bars;
  if (variants.size() == 1)
    for (const Json& cycle : variants[0].at("cycles")) {
      bars.push_back({fmt::format("cycle {}", cycle.at("cycle").get<int>()), {}});
      add(bars.back(), cycle.at("seconds"));
    }
  else
    for (const Json& variant : variants) {
      bars.push_back({variant.at("name"), {}});
      for (const Json& cycle : variant.at("cycles")) add(bars.back(), cycle.at("seconds"));
    }
  return bars;
}

std::string timing_data(const std::vector<Bar>& bars) {
  std::string data = "# CPU seconds per stage\n# row";
  for (const char* stage : kStages) data += fmt::format(" | {}", stage);
  data += " | what\n";
  for (std::size_t i = 0; i < bars.size(); ++i) {
    data += fmt::format("{}", -1 - static_cast<int>(i));
    for (const double seconds : bars[i].seconds) data += fmt::format(" {:.6g}", seconds);
    data += fmt::format(" # {}\n", one_line(bars[i].label));
  }
  return data;
}

std::string seconds_axis(const std::vector<Bar>& bars) {
  double longest = 0;
  for (const Bar& bar : bars)
    longest = std::max(longest, std::accumulate(bar.seconds.begin(), bar.seconds.end(), 0.));
  if (!(longest > 0)) return {};
  return fmt::format("set xlabel 'CPU seconds'\nset xrange [0:{:g}]\nset xtics {:g}\n",
                     1.02 * longest, round_step(longest, 5));
}

}  // namespace

std::vector<Plot> timing_plots(const Json& history) {
  const std::vector<Bar> bars = bars_of(history.at("variants"));
  if (bars.empty()) return {};
  Plot plot{"timings", "CPU time per stage", {}, history.at("title"), timing_data(bars), {}, {}};
  std::vector<std::string> labels;
  for (const Bar& bar : bars) labels.push_back(bar.label);
  const double pitch = std::clamp(12. / static_cast<double>(labels.size()), 0.26, 0.42);
  plot.settings = row_axis(labels, pitch) + seconds_axis(bars) +
                  "upto(n) = n < 2 ? 0 : sum [i=2:n] column(i)\n";
  for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
    double sum = 0;
    for (const Bar& bar : bars) sum += bar.seconds[stage];
    if (sum > 0)
      plot.items.push_back(
          {fmt::format("data using (upto({1})):1:(upto({0})):(upto({1})):($1-0.33):($1+0.33) with "
                       "boxxyerror linestyle {2}",
                       stage + 1, stage + 2, stage + 31),
           kStages[stage]});
  }
  if (plot.items.empty()) return {};
  return {plot};
}

}  // namespace anisofront
