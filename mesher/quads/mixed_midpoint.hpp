#pragma once

#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// Midpoints in the metric of the background (Eqn 29 and Appendix B with ERRATA: half of the
/// edge's own length). One sample costs one look-up; sub-segments are halved until they are shorter
/// than `tolerance` (the paper: 0.25), at least once.
class MidpointFinder {
 public:
  MidpointFinder(const BackgroundMesh& background, double tolerance)
      : background_(background), tolerance_(tolerance) {}

  /// Of the straight edge ab; a and b carry the metric of the background.
  WorkVertex of_edge(const WorkVertex& a, const WorkVertex& b);

  struct OnCurve {
    double parameter = 0;
    WorkVertex vertex;
  };
  /// Of the part of the curve between the vertices of the segment. The length is that of the chords
  /// between the samples.
  OnCurve of_segment(const NurbsCurve& curve, const Segment& segment, const WorkVertex& a,
                     const WorkVertex& b);

 private:
  struct Sample {
    double t = 0;
    WorkVertex vertex;
    double length = 0;  ///< of the sub-segment that ends here
  };
  WorkVertex look_up(Point p, Index hint) const;
  template <class Place>
  void sample(const Sample& from, const Sample& to, const Place& place, int level);
  template <class Place>
  double halving_parameter(const Sample& from, const Sample& to, const Place& place);

  const BackgroundMesh& background_;
  double tolerance_;
  std::vector<Sample> samples_;  ///< of the present edge
};

}  // namespace anisofront
