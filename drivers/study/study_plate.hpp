#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drivers/study/element_names.hpp"
#include "drivers/study/toml_table.hpp"
#include "solver/plate/plate_elements.hpp"

namespace anisofront {

inline constexpr std::array<Named<PlateElement>, 3> kPlateElementNames{
    {{"mitc", PlateElement::mitc},
     {"mitc4", PlateElement::mitc4},
     {"arnold-falk", PlateElement::arnold_falk}}};

inline constexpr std::array<Named<SupportKind>, 7> kSupportNames{
    {{"clamped", SupportKind::clamped},
     {"soft-clamped", SupportKind::soft_clamped},
     {"hard-support", SupportKind::hard_support},
     {"soft-support", SupportKind::soft_support},
     {"free", SupportKind::free},
     {"symmetry", SupportKind::symmetry},
     {"antisymmetry", SupportKind::antisymmetry}}};

struct PlateBoundaryText {
  std::string curve;
  SupportKind support = SupportKind::free;
  std::optional<ExpressionText> deflection, shear, moment, twist;
  std::string place;
};

/// What is different in one region.
struct PlateRegionText {
  std::string region;
  PlateMaterial material;
  std::optional<ExpressionText> load;
  std::string place;
};

/// A Reissner-Mindlin plate, as a study says it.
struct PlateProblemText {
  std::string place;
  ExpressionNames names;
  PlateElement element = PlateElement::mitc;
  PlateMaterial material;
  ExpressionText load{"0", {}};
  std::vector<PlateRegionText> regions;
  std::vector<PlateBoundaryText> boundary;
  std::vector<PlatePointLoad> point_loads;
  std::vector<PlatePointSupport> point_supports;
};

/// The [problem] table of kind "mindlin". Throws UsageError with file:line:column, also for
/// conditions that contradict each other (a couple on a rotation that the support holds).
PlateProblemText parse_plate_problem(TomlTable table);

}  // namespace anisofront
