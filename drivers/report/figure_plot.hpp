#pragma once

#include <string>
#include <vector>

namespace anisofront {

/// One item of gnuplot's plot command.
struct PlotItem {
  std::string drawing;  ///< "data using 1:2 with lines ..."; `data` names the data file
  std::string label;    ///< in the legend; empty: not there
};

/// A figure before it is drawn.
struct Plot {
  std::string stem;  ///< of its files
  std::string caption;
  std::string variant;  ///< empty: about all of them
  std::string title;
  std::string data;      ///< content of the .dat
  std::string settings;  ///< commands of gnuplot, one a line
  std::vector<PlotItem> items;
};

/// The script that draws a plot; it loads style.gp and formats.gp.
std::string plot_script(const Plot& plot);

/// "set logscale" with a range from 1, 2 or 5 times a power of ten to another and labels that
/// suit it; where the values differ by less than a factor 2, in a range just around them. `axis`:
/// 'x' or 'y'. Precondition: 0 < low <= high.
std::string log_axis(char axis, double low, double high);

/// The least of 1, 2 or 5 times a power of ten that covers `length` in at most `most` steps.
/// Precondition: length > 0.
double round_step(double length, int most);

/// Labels of the rows of a bar chart, the first on top at y = -1, the next at -2, ...; room for
/// them on the left and for rows `pitch` cm apart in the height.
std::string row_axis(const std::vector<std::string>& labels, double pitch);

}  // namespace anisofront
