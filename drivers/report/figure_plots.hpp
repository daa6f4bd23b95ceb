#pragma once

#include <filesystem>
#include <vector>

#include "drivers/base/json.hpp"
#include "drivers/report/figure_plot.hpp"

namespace anisofront {

/// Distributions of edge lengths (the paper's Figs. 16 and 17) and qualities, a line per cycle.
/// None without cycles; histories of older versions have no qualities.
std::vector<Plot> distribution_plots(const Json& variant);

/// Error and effectivity against the number of unknowns, as far as they are known.
std::vector<Plot> error_plots(const Json& history);

/// Vertices of isotropic and anisotropic meshes at equal error, one pair of bars per comparison.
std::vector<Plot> comparison_plots(const Json& history);

/// Percent of the edges in the unit band over the cycles, a line per variant.
std::vector<Plot> band_plots(const Json& history);

/// Seconds per stage, stacked: a bar per variant or, of a single variant, per cycle.
std::vector<Plot> timing_plots(const Json& history);

/// Values along the requested lines, from `folder`/lines of a variant: one plot per line and
/// quantity, with the cycles and the reference.
std::vector<Plot> profile_plots(const Json& variant, const std::filesystem::path& folder);

}  // namespace anisofront
