#pragma once

#include "solver/system/sparse_rows.hpp"

namespace anisofront {

/// a_ij is a strong coupling when -a_ij is at least `strength` times the largest -a_ik or -a_jk: on
/// stretched elements, the neighbours across the short edges. (Measured on skewed stretched meshes:
/// half as many steps as with |a_ij| >= 0.08 sqrt(a_ii a_jj), eq. 2 of the reference in
/// multigrid.hpp. Positive a_ij, across obtuse angles, are never strong.) This is the matrix of
/// strong couplings, the weak ones added to the diagonal so that row sums stay.
SparseRows filtered_matrix(const SparseRows& matrix, double strength);

struct Aggregates {
  std::vector<Index> of_unknown;  ///< kNoIndex: coupled to nothing, left to the smoother
  Index count = 0;
};

/// Neighbourhoods of strong coupling in the order of the unknowns (section 5 of the reference).
Aggregates aggregate(const SparseRows& filtered);

/// (I - omega D^-1 A_F) applied to the constants on aggregates, omega = 4/3 over an estimate of the
/// largest eigenvalue of D^-1 A_F.
SparseRows smoothed_prolongation(const SparseRows& filtered, const Aggregates& aggregates);

}  // namespace anisofront
