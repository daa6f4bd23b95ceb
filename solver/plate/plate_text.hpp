#pragma once

#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// A physical tag as messages show it: `"rim" (tag 3)`, or `tag 3` where it has no name.
inline std::string describe_tag(const Mesh& mesh, int dimension, Index tag) {
  const std::string name = group_name(mesh, dimension, tag);
  const std::string number = "tag " + std::to_string(tag);
  return name.empty() ? number : '"' + name + "\" (" + number + ")";
}

}  // namespace anisofront
