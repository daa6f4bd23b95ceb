#pragma once

#include <functional>
#include <vector>

#include "drivers/report/cycle_blob.hpp"
#include "drivers/report/page.hpp"

namespace anisofront {

/// cycle_blob(), or what stands for it in tests. Called by several threads at once.
using MeshEncoder =
    std::function<std::string(const std::filesystem::path& folder, int cycle, Interpolation)>;

/// Puts meshes on the page until they take `max_bytes`: those of the last cycles of all variants
/// first, then the others in order. What is too large is passed over, so that smaller ones follow.
/// Sets "meshes" of every variant in `runs` (of run_data(), in the order of `folders`):
/// [{"cycle", "id": of the mesh or null, "note": why there is none}].
std::vector<PageMesh> add_meshes(Json& runs, const std::vector<std::filesystem::path>& folders,
                                 std::size_t max_bytes, const MeshEncoder& encode = cycle_blob);

}  // namespace anisofront
