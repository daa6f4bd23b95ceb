#pragma once

#include "adapt/model.hpp"
#include "drivers/problem/line_reference.hpp"

namespace anisofront {

/// A line of a study with all that does not depend on the mesh.
struct WatchedLine {
  std::string name;
  LinePoints line;
  std::optional<NumberTable> reference;
};

/// The [output] lines of a study. Throws as line_points() and line_reference() do.
std::vector<WatchedLine> watched_lines(const Study& study, const Domain& domain);

/// The model, leaving a profile of each line on every mesh.
Model with_profiles(Model model, std::vector<WatchedLine> lines);

}  // namespace anisofront
