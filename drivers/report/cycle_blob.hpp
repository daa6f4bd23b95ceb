#pragma once

#include <filesystem>
#include <string>

#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// The mesh of a cycle for the viewer of the page: mesh_blob(), gzipped. Reads cycle-K.msh in the
/// folder of a variant, and from cycle-(K-1).msh the metric it was made for; that of the first mesh
/// is its own. `interpolation`: that of the study. Where the metric is missing or damaged, the
/// blob goes without what needs it and says so in its note.
/// Throws UsageError or InputError when the mesh itself is missing or damaged.
std::string cycle_blob(const std::filesystem::path& folder, int cycle,
                       Interpolation interpolation = Interpolation::linear_size);

}  // namespace anisofront
