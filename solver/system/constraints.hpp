#pragma once

#include <span>
#include <vector>

#include "solver/system/assemble.hpp"

namespace anisofront {

/// A prescribed unknown.
struct Constraint {
  Index unknown = kNoIndex;
  double value = 0;
};

/// Imposes the constraints (unknowns distinct): rows and columns become zero but for the diagonal,
/// which keeps its size so that the conditioning stays as it is; symmetric systems stay symmetric.
void impose(std::span<const Constraint> constraints, LinearSystem& system);

/// A pair of unknowns (first, first + 1), the components of a vector in x and y, that is to be
/// expressed along `axis` (unit) and `axis` turned anticlockwise by 90 degrees.
struct Frame {
  Index first = kNoIndex;
  Vector axis;
};

/// R^T A R and R^T b with the rotations of the frames (an exact transformation, no penalty).
/// Preconditions: distinct pairs; both unknowns of a pair couple to the same unknowns.
void rotate_to_frames(std::span<const Frame> frames, LinearSystem& system);

/// R x: from frame components back to x and y.
void rotate_back(std::span<const Frame> frames, Eigen::VectorXd& solution);

/// Components of a vector in x and y along the frames: R^T x.
void rotate_to_frames(std::span<const Frame> frames, Eigen::VectorXd& vector);

}  // namespace anisofront
