#pragma once

#include <string>
#include <vector>

namespace anisofront {

/// A study file to start from, with comments on every key that a beginner wants.
struct StudyTemplate {
  std::string kind;
  std::string summary;
  std::string text;
  /// A study whose initial mesh is to be written beside the file; its name goes where the text says
  /// @MESH@. Empty: none.
  std::string mesh_source;
};

/// All of them; the first is taken where nothing else is asked for.
const std::vector<StudyTemplate>& study_templates();

}  // namespace anisofront
