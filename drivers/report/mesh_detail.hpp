#pragma once

#include <optional>

#include "mesher/io/svg.hpp"

namespace anisofront {

/// The part of a mesh that a drawing of the whole does not show: a square around the thinnest
/// elements, of these the most stretched (the first of equals), 60 to 240 thicknesses wide. Empty
/// when the thicknesses (area / longest edge) differ by less than a factor 30 or the square would
/// be more than half as wide as the mesh.
std::optional<PlaneWindow> detail_window(const Mesh& mesh);

}  // namespace anisofront
