#pragma once

#include <filesystem>
#include <vector>

#include "adapt/profile.hpp"

namespace anisofront {

/// Writes lines/cycle-K-NAME.csv into the folder of a variant, and lines/reference-NAME.csv where
/// there is a reference.
void write_profiles(const std::filesystem::path& folder, int cycle,
                    const std::vector<Profile>& profiles);

/// Removes the profiles of cycle `first` and later ones, with those of cycle 0 the references too,
/// and the folder when it is empty.
void remove_profiles(const std::filesystem::path& folder, int first);

}  // namespace anisofront
