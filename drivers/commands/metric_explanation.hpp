#pragma once

#include <filesystem>
#include <string>

#include "drivers/study/study_file.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

/// Where and on what the metric is to be explained.
struct MetricQuestion {
  Point at;
  std::filesystem::path mesh;  ///< empty: the initial mesh of the study
};

/// Solves on the mesh and says in words which stage of its making, or which entry of a prescribed
/// list, set the sizes of the metric at the point; below the sizes after each stage. A mesh called
/// cycle-K.msh counts as that of cycle K, others as that of the last cycle.
/// Throws UsageError for a point outside the domain, proposing the nearest one, and what
/// loop_input() and the analysis throw.
std::string explain_study_metric(const Variant& variant, const MetricQuestion& question,
                                 const Monitor& monitor = {});

}  // namespace anisofront
