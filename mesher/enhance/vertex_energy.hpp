#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// The ring of a vertex copied into flat arrays, and the energy of the vertex at a trial place:
/// sum over triangles of alpha^-3 - 1 plus sum over edges of a length term that is 1 near l = sqrt2
/// and l = 1/sqrt2. Only + - * / and sqrt, so that the decisions are the same everywhere.
class VertexEnergy {
 public:
  /// Loads the surroundings of an interior vertex.
  void load(const Patch& patch, const Ring& ring);

  /// Energy at x; stops early, with a value above the limit, when it exceeds it. 1e30 when a
  /// triangle would be turned over. Keeps the squared edge lengths for length_proposal().
  double operator()(const WorkVertex& x, double limit);

  /// Mean displacement towards the places at unit distance from each neighbour (Eqn 25a), from the
  /// lengths of the last complete evaluation at x.
  Vector length_proposal(const WorkVertex& x) const;

  /// Mean displacement towards the apices of unit triangles over the outer edges (Eqn 26).
  Vector quality_proposal(const WorkVertex& x) const;

  /// Exact test that all triangles stay anticlockwise with the vertex at p.
  bool is_valid(Point p) const;

  int size() const { return size_; }

 private:
  int size_ = 0;
  std::array<Point, Ring::kCapacity + 1> p_;
  std::array<MetricFactor, Ring::kCapacity + 1> r_;
  std::array<double, Ring::kCapacity> squared_length_;
};

}  // namespace anisofront
