#pragma once

#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/curve.hpp"
#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Running metric length along a piece of a curve: length[i] at parameter[i], piecewise linear
/// between, length.front() == 0.
struct CurveProfile {
  std::vector<double> parameter;
  std::vector<double> length;
  double total() const { return length.back(); }
};

/// Number of segments for a metric length (Eqn 19): the integer nearest to L in ratio; at least 1.
Index segment_count(double length);

/// Profile over the curve itself between two parameters, with metrics of the background: halved
/// until no sample step is longer than `tolerance`, log-mean lengths (exact where the size is
/// linear). Throws BudgetError when the length exceeds `max_length`.
CurveProfile sample_curve(const BackgroundMesh& background, const NurbsCurve& curve, double t0,
                          double t1, double tolerance, double max_length, Index& hint);

/// Profile over the old segments (Eqn 18, Appendix B): `edges` cover the piece in order of their
/// parameters. Where the background has a size factor above 1 the sub-segments of Appendix B are as
/// short as without it: the trapezoid rule finds too much length by the square of theirs, 0.2 % on
/// the graded sides of Example 2 in the metric M/4, which is enough for one edge more (Eqn 19).
CurveProfile measure_old_segments(const BackgroundMesh& background, const Mesh& old_mesh,
                                  const std::vector<CurveEdge>& edges, Index& hint);

/// Parameters of count + 1 points at equal running lengths, both ends included (Eqn 20).
std::vector<double> equal_parts(const CurveProfile& profile, Index count);

/// Parameters of the end points of edges whose chords, not arcs, have equal metric length near 1:
/// starts from the profile and corrects number and density by the measured chords. Where the metric
/// is thin across the curve a chord is longer than its arc.
std::vector<double> equal_chords(const BackgroundMesh& background, const NurbsCurve& curve,
                                 CurveProfile profile, Index least_count, Index& hint);

/// The same for a given number of edges.
std::vector<double> equal_chords_of_count(const BackgroundMesh& background, const NurbsCurve& curve,
                                          CurveProfile profile, Index count, Index& hint);

/// Metric length of the chords between the points of the curve at the given parameters.
double total_chord_length(const BackgroundMesh& background, const NurbsCurve& curve,
                          const std::vector<double>& parameters, Index& hint);

/// Metric length of a straight segment by a fixed composite rule on the background.
double chord_length(const BackgroundMesh& background, Point a, Point b, Index& hint);

}  // namespace anisofront
