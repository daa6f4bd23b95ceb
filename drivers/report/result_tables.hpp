#pragma once

#include "drivers/report/summary.hpp"

namespace anisofront {

/// Variants that solve a problem, one row each: number of cycles, and of the last mesh vertices,
/// unknowns, estimated and true relative energy error, effectivity, percent of the edges in the
/// unit band; the reason of stopping. No rows when there is no problem.
TextTable result_table(const Json& history);

/// Goal with its estimated error and the named values on the last mesh of each variant. No rows
/// when there are none.
TextTable value_table(const Json& history);

/// The comparisons of isotropic and anisotropic meshes at equal error. "true" or "estimate": which
/// errors are equal.
TextTable comparison_table(const Json& history);

/// The tables that have rows, that of the paper (summary_table()) for prescribed metrics only.
std::string console_summary(const Json& history);

}  // namespace anisofront
