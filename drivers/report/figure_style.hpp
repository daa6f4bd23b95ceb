#pragma once

#include <string>

namespace anisofront {

/// Content of figures/style.gp, the looks of all figures: for users to change.
std::string figure_style();

/// Content of figures/formats.gp: what the scripts need besides.
std::string figure_formats();

/// Content of figures/README.txt.
std::string figure_readme();

}  // namespace anisofront
