#pragma once

#include <filesystem>

#include "adapt/loop.hpp"
#include "drivers/study/study.hpp"

namespace anisofront {

/// Everything a study says, ready for adapt_loop(): reads or makes the initial mesh, compiles the
/// expressions. `finished` stays empty. Throws UsageError (also for a problem without a target),
/// InputError and what generate() throws.
LoopInput loop_input(const Study& study, const Monitor& monitor = {});

/// A mesh file whose mesh can be remeshed (require_usable).
Mesh usable_mesh(const std::filesystem::path& file, const Monitor& monitor = {});

/// Domain and initial mesh of a study, the mesh attached to the domain.
struct Start {
  Domain domain;
  Mesh mesh;
};
/// What a mesh made by us consists of: cycles start from triangles, one solve has the elements of
/// the study.
enum class InitialElements { triangles, as_in_study };
Start study_start(const Study& study, InitialElements elements, const Monitor& monitor = {});

/// The preset with what the study changes.
GenerateOptions study_options(const Study& study);

/// A mesh of the domain with edges of length `size`, attached to it; of `options` the elements, the
/// chord height and the budget count.
Mesh uniform_mesh(const Domain& domain, double size, const GenerateOptions& options,
                  const Monitor& monitor = {});

}  // namespace anisofront
