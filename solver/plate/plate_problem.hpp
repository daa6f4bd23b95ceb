#pragma once

#include <utility>
#include <vector>

#include "solver/space/coefficient.hpp"
#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// Reissner-Mindlin plate: deflection w, rotations theta, gamma = grad w - theta, shear forces
/// Q = k G t gamma, moments M = -D [(1 - nu) eps(theta) + nu tr eps(theta) I].
struct PlateMaterial {
  double young = 1;              ///< E, force / length^2
  double poisson = 0.3;          ///< nu in (-1, 1/2)
  double thickness = 1;          ///< t, length
  double shear_factor = 5. / 6;  ///< k

  /// D = E t^3 / (12 (1 - nu^2)).
  double bending_stiffness() const {
    return young * thickness * thickness * thickness / (12 * (1 - poisson * poisson));
  }
  /// k G t = k E t / (2 (1 + nu)).
  double shear_stiffness() const { return shear_factor * young * thickness / (2 * (1 + poisson)); }
};

/// Essential conditions (n outward normal, s tangent); the others are natural.
enum class SupportKind {
  clamped,       ///< w = theta_n = theta_s = 0 (hard)
  soft_clamped,  ///< w = theta_n = 0
  hard_support,  ///< w = theta_s = 0 (SS2)
  soft_support,  ///< w = 0 (SS1)
  free,          ///< none
  symmetry,      ///< theta_n = 0
  antisymmetry   ///< w = theta_s = 0
};

/// What a support of this kind holds.
struct HeldComponents {
  bool deflection = false, normal_rotation = false, tangential_rotation = false;
};
HeldComponents held_components(SupportKind kind);

/// On all mesh edges with this physical tag. Where conditions meet in a vertex, their union holds.
struct PlateSupport {
  Index tag = 0;
  SupportKind kind = SupportKind::free;
  /// Prescribed deflection (settlement) where the kind holds w.
  Coefficient deflection;
};

/// Forces and couples per length on all mesh edges with this tag: Q_n on w; M_n and M_ns as the
/// moments of the plate there (M_n = n.M n, M_ns = n.M s, s anticlockwise from n).
struct PlateEdgeLoad {
  Index tag = 0;
  Coefficient shear, moment, twist;
};

/// A force on the vertex next to `at`; w is unbounded there as the mesh gets finer.
struct PlatePointLoad {
  Point at;
  double force = 0;
};

/// Holds the vertex next to `at`: w, and theta where asked for.
struct PlatePointSupport {
  Point at;
  double deflection = 0;
  bool holds_rotations = false;
};

struct PlateProblem {
  PlateMaterial material;
  std::vector<std::pair<Index, PlateMaterial>> regions;  ///< by physical tag, instead of material
  RegionCoefficient load = 0.;                           ///< q, force / length^2
  std::vector<PlateSupport> supports;
  std::vector<PlateEdgeLoad> edge_loads;
  std::vector<PlatePointLoad> point_loads;
  std::vector<PlatePointSupport> point_supports;

  const PlateMaterial& material_in(Index region) const;
};

/// Smallest thickness / diameter of the domain: below, round-off (condition ~ (L/t)^2 (L/h)^4)
/// takes the digits that the answer needs.
inline constexpr double kLeastThicknessRatio = 1e-5;

/// Throws InputError for E, t, k <= 0, nu outside (-1, 1/2), t below kLeastThicknessRatio times the
/// longer side of the box round the mesh (with the reason), values that are not finite, tags that
/// no edge or region of the mesh carries (with the group name) or that come twice, vertices that no
/// element has. Functions are checked where they are evaluated.
void validate(const PlateProblem& problem, const FeMesh& mesh);

}  // namespace anisofront
