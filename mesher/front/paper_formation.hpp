#pragma once

#include "mesher/front/ideal_point.hpp"

namespace anisofront {

/// Steps (ii) and (iii) of the paper.
struct PaperOffset {
  Point midpoint;   ///< pseudo-midpoint D of AB in the metric (Eqn 21, Appendix B)
  TrialPoint best;  ///< the one of C1, C2, C3 with the highest mu~
};
PaperOffset paper_offset(const BackgroundMesh& background, const WorkVertex& a,
                         const WorkVertex& b);

/// mu~ (Eqn 17) to the letter: alpha~ (Eqn 15) times e^(-delta), lengths by Appendix B.
/// Negative when the triangle ABC is clockwise.
double paper_mu(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b,
                const TrialPoint& c);

/// Length of the segment between two vertices by Appendix B, with metrics of the background mesh.
double paper_length(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b);

}  // namespace anisofront
