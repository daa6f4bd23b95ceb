#pragma once

#include <span>
#include <vector>

#include "mesher/io/svg_path.hpp"

namespace anisofront {

/// Whether each element (triangles, then quads) reaches into what is drawn.
std::vector<bool> shown_elements(const Mesh& mesh, const SvgFrame& frame);

/// One path per region, in a tint of its own.
void write_regions(AtomicFile& out, const Mesh& mesh, SvgPath& path,
                   const std::vector<bool>& shown);

struct ValueRange {
  double least = HUGE_VAL, greatest = -HUGE_VAL;
};

/// Of the elements that are drawn; values that are not finite do not count.
ValueRange value_range(std::span<const double> values, const std::vector<bool>& shown);

/// One path per colour of kValueColours; elements without a finite value are left out.
void write_values(AtomicFile& out, const Mesh& mesh, SvgPath& path, const std::vector<bool>& shown,
                  std::span<const double> values, ValueRange range);

}  // namespace anisofront
