#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace anisofront {

/// Text on one line, for comments: control characters become blanks.
std::string one_line(std::string_view text);

/// Text as a string of gnuplot. In single quotes nothing is expanded: a name in backticks, which
/// gnuplot runs as a command in double quotes, stays a name.
std::string gnuplot_string(std::string_view text);

/// Number of characters of a text in UTF-8.
std::size_t character_count(std::string_view text);

/// At most `most` characters, the last an ellipsis where some were left out.
std::string shortened(const std::string& text, std::size_t most);

/// A name that is safe as part of a file name: letters, digits, '.', '_' and '-' stay, the rest
/// becomes '_', the first is a letter, a digit or '_', and there are at most about 100.
std::string file_stem(std::string_view name);

/// Rows of the legend below a plot.
struct LegendLayout {
  std::size_t rows = 0;
  double surplus = 0;  ///< characters by which gnuplot thinks the longest label too long
};
/// As many columns as the longest label leaves room for in `width` (cm).
LegendLayout legend_layout(const std::vector<std::string>& labels, double width);

/// Width in cm of a text in the font of style.gp, on the safe side.
double text_width(std::string_view text);

}  // namespace anisofront
