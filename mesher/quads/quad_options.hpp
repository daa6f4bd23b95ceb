#pragma once

#include <cstdint>
#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/enhance/enhance.hpp"
#include "mesher/front/advance.hpp"
#include "mesher/front/boundary.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/monitor.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

enum class Elements { triangle, quadrilateral, mixed };

/// best: coarse right-angle frame, clean-up by local operations, division, clean-up again;
/// paper: the five steps of section 3 (with ERRATA and what paper_quads() says).
enum class QuadMethod { best, paper };

/// How long to search for better quadrilaterals.
enum class QuadEffort { fast, best };

/// What the first quadrilaterals are made from. `automatic` tries several on the coarse level and
/// keeps the one of least energy when the effort is best. Method paper: `systematic` merges layer
/// by layer, all others in the order of beta~.
enum class QuadStart { automatic, right_angle, equilateral, greedy, systematic };

struct QuadOptions {
  QuadMethod method = QuadMethod::best;
  QuadEffort effort = QuadEffort::best;
  QuadStart start = QuadStart::automatic;
};

/// Seconds of the phases and what was done in them.
struct QuadStatistics {
  double boundary = 0, front = 0, pairing = 0, cleaning = 0;  ///< CPU seconds
  std::int64_t triangles = 0;   ///< of the coarse triangulation that was kept
  std::int64_t leftovers = 0;   ///< triangles without partner
  std::int64_t trials = 0;      ///< local operations tried
  std::int64_t operations = 0;  ///< and kept
  int levels = 0;               ///< regular divisions
};

/// The finished faces with, per domain point, its vertex.
struct Quadrangulation {
  MixedMesh mesh;
  std::vector<Index> point_vertices;
  QuadStatistics statistics;
};

/// What the conversion needs of the options of generate().
struct QuadrangulateInput {
  const Domain& domain;
  const Mesh& old_mesh;
  BackgroundMesh& background;  ///< its size factor is changed on the way and 1 again in the end
  BoundaryOptions boundary;
  FrontOptions front;
  EnhanceOptions enhance;
  QuadOptions options;
  std::int64_t max_elements;
};

}  // namespace anisofront
