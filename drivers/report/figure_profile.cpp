#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include <spdlog/fmt/fmt.h>

#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_table.hpp"
#include "drivers/report/figure_text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// All that is known about one line.
struct LineProfile {
  std::string name;
  std::map<int, NumberTable> cycles;
  std::optional<NumberTable> reference;
};

/// "cycle-3-axis.csv" and "reference-axis.csv" of the folder, by the name of the line.
std::vector<LineProfile> read_profiles(const fs::path& folder) {
  std::map<std::string, LineProfile> profiles;
  if (!fs::is_directory(folder)) return {};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".csv") continue;
    if (stem.starts_with("reference-")) {
      profiles[stem.substr(10)].reference = read_number_table(entry.path());
    } else if (stem.starts_with("cycle-")) {
      const std::size_t dash = stem.find('-', 6);
      int cycle = -1;
      std::from_chars(stem.data() + 6, stem.data() + stem.size(), cycle);
      if (cycle >= 0 && dash != std::string::npos)
        profiles[stem.substr(dash + 1)].cycles[cycle] = read_number_table(entry.path());
    }
  }
  std::vector<LineProfile> sorted;
  for (auto& [name, profile] : profiles)
    if (!profile.cycles.empty()) {
      profile.name = name;
      sorted.push_back(std::move(profile));
    }
  return sorted;
}

/// Largest absolute value of a quantity over the cycles.
double greatest(const LineProfile& profile, const std::string& quantity) {
  double most = 0;
  for (const auto& [cycle, table] : profile.cycles)
    if (const auto column = column_of(table, quantity))
      for (const std::vector<double>& row : table.rows)
        most = std::fmax(most, std::fabs(row[*column]));
  return most;
}

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The solution and what has layers; with a reference those of them that it knows, or all of its
/// own if it knows none.
std::vector<std::string> candidates(const LineProfile& profile) {
  const std::vector<std::string> important{"u", "w", "M_n", "M_ns", "Q_n", "Q_s"};
  if (!profile.reference) return important;
  std::vector<std::string> known, others;
  for (const std::string& name : profile.reference->columns)
    if (!is_in({"s", "x", "y"}, name)) (is_in(important, name) ? known : others).push_back(name);
  return known.empty() ? others : known;
}

/// Without those that are 0 but for rounding.
std::vector<std::string> important_quantities(const LineProfile& profile) {
  constexpr double kRounding = 1e-12;
  std::vector<std::string> names = candidates(profile);
  double scale = 0;
  for (const std::string& name : names) scale = std::max(scale, greatest(profile, name));
  std::erase_if(names, [&](const std::string& name) {
    return !(greatest(profile, name) > kRounding * scale);
  });
  return names;
}

/// Lines "s value" of the points where both are known.
std::string block(const NumberTable& table, const std::string& quantity) {
  std::string text;
  const auto s = column_of(table, "s"), value = column_of(table, quantity);
  if (s && value)
    for (const std::vector<double>& row : table.rows)
      if (std::isfinite(row[*s]) && std::isfinite(row[*value]))
        text += fmt::format("{} {}\n", row[*s], row[*value]);
  return text;
}

/// gnuplot's enhanced text of "M_ns": subscripts.
std::string symbol(const std::string& quantity) {
  const std::size_t dash = quantity.find('_');
  if (dash == std::string::npos) return quantity;
  return quantity.substr(0, dash) + "_{" + quantity.substr(dash + 1) + "}";
}

/// A block of the data and its curve, the values times 10^-`power`.
void add_curve(Plot& plot, const std::string& points, const std::string& look,
               const std::string& name, int power) {
  if (points.empty()) return;
  const std::size_t index = plot.items.size();
  plot.data += fmt::format("# block {}: {}\n{}\n\n", index, name, points);
  plot.items.push_back(
      {fmt::format("data index {} using 1:($2*1e{}) {}", index, -power, look), name});
}

void add_cycles(Plot& plot, const LineProfile& profile, const std::string& quantity, int power) {
  const int last = profile.cycles.rbegin()->first;
  for (const auto& [cycle, table] : profile.cycles) {
    const std::string name = cycle == 0 ? "initial mesh" : fmt::format("cycle {}", cycle);
    const std::string look = cycle == 0
                                 ? "linestyle 50"
                                 : fmt::format("linecolor palette frac shade({}, {}) linewidth {}",
                                               cycle, last, cycle == last ? "1.6" : "1");
    add_curve(plot, block(table, quantity), "with lines " + look, name, power);
  }
}

/// As points, so that the curves show through.
void add_reference(Plot& plot, const LineProfile& profile, const std::string& quantity, int power) {
  constexpr std::size_t kPoints = 40;
  if (!profile.reference) return;
  const std::size_t step = profile.reference->rows.size() / kPoints + 1;
  add_curve(plot, block(*profile.reference, quantity),
            fmt::format("every {} with points linestyle 51", step), "reference", power);
}

/// Power of ten that is taken out of small and large values, so that the labels stay short.
int common_power(double most) {
  if (most >= 0.1 && most < 1000) return 0;
  return static_cast<int>(std::floor(std::log10(most)));
}

std::string axis_label(const std::string& quantity, int power) {
  const std::string label = symbol(quantity);
  return gnuplot_string(power == 0 ? label : fmt::format("{} / 10^{{{}}}", label, power));
}

Plot profile_plot(const std::string& variant, const LineProfile& profile,
                  const std::string& quantity) {
  const int power = common_power(greatest(profile, quantity));
  Plot plot{file_stem(variant) + "-profile-" + file_stem(profile.name) + "-" + file_stem(quantity),
            one_line(quantity) + " along the line " + one_line(profile.name),
            variant,
            variant + ": " + profile.name,
            fmt::format("# {}\n# s (length along the line) | value\n", one_line(quantity)),
            "set xlabel 's'\nset ylabel " + axis_label(quantity, power) + "\n",
            {}};
  add_cycles(plot, profile, quantity, power);
  add_reference(plot, profile, quantity, power);
  return plot;
}

}  // namespace

std::vector<Plot> profile_plots(const Json& variant, const fs::path& folder) {
  std::vector<Plot> plots;
  for (const LineProfile& profile : read_profiles(folder / "lines"))
    for (const std::string& quantity : important_quantities(profile))
      plots.push_back(profile_plot(variant.at("name"), profile, quantity));
  return plots;
}

}  // namespace anisofront
