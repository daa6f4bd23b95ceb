#pragma once

#include <cstdint>

#include "mesher/enhance/enhance.hpp"
#include "mesher/front/advance.hpp"
#include "mesher/front/boundary.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/monitor.hpp"
#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"
#include "mesher/quads/quadrangulate.hpp"

namespace anisofront {

/// paper: the paper to the letter with the corrections of its errata; best: what measured best.
enum class Preset { best, paper };

struct GenerateOptions {
  Preset preset = Preset::best;
  Interpolation interpolation = Interpolation::linear_size;
  BoundaryOptions boundary;
  FrontOptions front;
  EnhanceOptions enhance;
  /// quadrilateral: nothing but convex quadrilaterals; mixed: triangles stay where no good
  /// quadrilateral can be made of them.
  Elements elements = Elements::triangle;
  QuadOptions quads;  ///< not read for triangles
  /// Refuse (BudgetError with the estimate) when the metric asks for more elements than this.
  std::int64_t max_elements = 5'000'000;
  /// Largest ratio of sizes over a unit of metric length; <= 1: leave the metric as it is.
  double gradation = 0;
};

/// Options of a preset; every field may be changed afterwards.
GenerateOptions generate_options(Preset preset);

/// CPU seconds of the phases. Triangles have no `quads`; else `quads` is all that comes between
/// the front and the check, and `enhance` is 0.
struct PhaseSeconds {
  double background = 0, boundary = 0, front = 0, enhance = 0, verify = 0, quads = 0;
};

struct GenerateResult {
  Mesh mesh;
  MetricField metric;  ///< the background metric at the vertices of `mesh`
  PhaseSeconds seconds;
  FrontStatistics front;      ///< of triangles only
  EnhanceStatistics enhance;  ///< of triangles only
  QuadStatistics quads;       ///< of quadrilaterals and mixed meshes only
};

/// The next mesh: boundary curves of `domain` cut into unit edges, the inside filled by the
/// advancing front, improved, verified. `background` carries one metric per vertex (`field`); its
/// edges name the curves of `domain` (see attach_to_domain). Groups, tags, regions, embedded curves
/// and required points are kept.
/// Throws InputError (bad metric or domain, with the place), BudgetError, MeshingError (also when
/// quadrilaterals were asked for and a triangle is left: never a mixed mesh by surprise),
/// Interrupted. Deterministic: equal input gives equal bits. Background and field are taken by
/// value because they are dropped as soon as they have been read: a caller that moves them saves
/// memory.
GenerateResult generate(const Domain& domain, Mesh background, MetricField field,
                        const GenerateOptions& options, const Monitor& monitor = {});

}  // namespace anisofront
