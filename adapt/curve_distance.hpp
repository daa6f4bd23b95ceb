#pragma once

#include <optional>
#include <vector>

#include "mesher/background/alternating_digital_tree.hpp"
#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// The nearest point of a set of curve edges.
struct NearestOnCurves {
  double distance = 0;
  Vector tangent{1, 0};  ///< unit, of the curve where FeMesh knows it
};

/// Distances to the curve edges of a mesh that have one of some tags. Edges are straight or bent to
/// parabolas, as their elements are mapped. A tree of boxes, O(log n) for a point. May be asked by
/// several threads at once.
class CurveDistance {
 public:
  /// Distances beyond `reach` (> 0) are not wanted.
  CurveDistance(const FeMesh& mesh, const std::vector<Index>& tags, double reach);

  /// Empty when no edge is within reach. Of edges at equal distance the first one counts.
  std::optional<NearestOnCurves> nearest(Point p) const;

 private:
  /// The points a + t (chord + (1 - t) bend) with t in [0, 1]; no bend for straight edges.
  struct Arc {
    Point a;
    Vector chord, bend;
    std::array<Vector, 2> tangents;  ///< of the curve at both ends
    Index number;                    ///< in the order of the mesh
    Point at(double t) const { return a + t * (chord + (1 - t) * bend); }
    double nearest_parameter(Point p) const;
    Box box() const;
  };
  struct Foot {
    Index arc = kNoIndex;
    double t = 0;
    double distance = 0;
  };
  /// Arcs [begin, end) below a node of the tree.
  struct Range {
    Index node, begin, end;
    Index middle() const { return (begin + end) / 2; }
    bool is_leaf() const { return end - begin == 1; }
    Range half(int side) const {
      return side == 0 ? Range{2 * node + 1, begin, middle()} : Range{2 * node + 2, middle(), end};
    }
  };
  void sort_arcs();
  Box build(Range range);
  void search(Range range, Point p, Foot& best) const;

  double reach_;
  std::vector<Arc> arcs_;   ///< near ones next to each other
  std::vector<Box> boxes_;  ///< per node of a binary tree; children of node i are 2 i + 1, 2 i + 2
};

}  // namespace anisofront
