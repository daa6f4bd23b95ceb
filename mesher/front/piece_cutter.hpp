#pragma once

#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/front/boundary.hpp"
#include "mesher/front/curve_frame.hpp"
#include "mesher/front/curve_profile.hpp"
#include "mesher/geometry/domain.hpp"

namespace anisofront {

/// Cuts pieces of curves into edges of unit length (Eqns 18-20): by equal parts of the curve or of
/// the old boundary segments, or by equal chords. Results are the parameters of the end points of
/// the edges. Looks metrics up from `hint` on.
class PieceCutter {
 public:
  /// Keeps references to all arguments. Lengths above `max_length` are refused (BudgetError).
  PieceCutter(const Domain& domain, const Mesh& old_mesh, const BackgroundMesh& background,
              const BoundaryOptions& options, double max_length, const CurveFrame& frame);

  /// As many edges as the metric asks for (Eqn 19).
  std::vector<double> cut(const CurvePiece& piece, Index& hint) const;

  /// A given number of edges.
  std::vector<double> cut_into(const CurvePiece& piece, Index count, Index& hint) const;

  /// One edge more or less, whichever is nearer to the metric length L of the piece: the cost is
  /// |ln(N / L)|. `now`: how the piece is cut.
  struct Change {
    Index count;
    double cost;
  };
  Change cheapest_change(const CurvePiece& piece, const std::vector<double>& now,
                         Index& hint) const;

 private:
  void collect_old_edges();
  std::vector<CurveEdge> old_edges_of(const CurvePiece& piece) const;
  CurveProfile profile_of(const CurvePiece& piece, Index& hint) const;
  bool is_by_chords(const CurvePiece& piece) const;
  Index least_count(const CurvePiece& piece) const;
  const NurbsCurve& curve_of(const CurvePiece& piece) const {
    return domain_.curves[piece.curve].curve;
  }

  const Domain& domain_;
  const Mesh& old_mesh_;
  const BackgroundMesh& background_;
  const BoundaryOptions& options_;
  double max_length_;
  const CurveFrame& frame_;
  std::vector<Index> pieces_of_vertex_;            ///< number of pieces that end there
  std::vector<std::vector<CurveEdge>> old_edges_;  ///< per curve, by parameter
};

}  // namespace anisofront
