#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.hpp"

namespace anisofront {

/// Physical tag of the curves of this name. (Several chains of a mesh boundary share one.) Throws
/// UsageError that starts with `place` and proposes the nearest name.
Index curve_tag(const Domain& domain, const std::string& name, const std::string& place);

/// Physical tag of the region of this name; throws as curve_tag() does.
Index region_tag(const Domain& domain, const std::string& name, const std::string& place);

/// Name of the first curve with this tag; empty when there is none.
std::string curve_name(const Domain& domain, Index tag);

/// Curves at which exactly one region lies, the outer boundary and the holes: indices, ascending.
std::vector<Index> boundary_curves(const Domain& domain);

}  // namespace anisofront
