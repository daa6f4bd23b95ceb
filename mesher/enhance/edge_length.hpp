#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

struct EdgeLengthOptions {
  double shortest = 0.7071;           ///< shorter edges are collapsed, shortest first
  double longest = 1.4142;            ///< longer edges are split, longest first
  double collapsed_longest = 1.4142;  ///< no edge may become longer than this by a collapse
  double collapsed_alpha =
      0.5;  ///< no triangle may become worse than this and than the worst before
};

/// Collapses short and splits long interior edges. Vertices on segments and required vertices stay.
void collapse_and_split(Patch& patch, const EdgeLengthOptions& options);

}  // namespace anisofront
