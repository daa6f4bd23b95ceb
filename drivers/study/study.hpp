#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "drivers/study/expression.hpp"
#include "drivers/study/study_adapt.hpp"
#include "drivers/study/study_output.hpp"
#include "drivers/study/study_plate.hpp"
#include "drivers/study/study_problem.hpp"
#include "drivers/study/toml_table.hpp"
#include "mesher/generate.hpp"
#include "mesher/mesh/boundary_domain.hpp"

namespace anisofront {

/// One metric of a prescribed list: size h1 along e1, h2 across. The expressions know x, y, the
/// names of `where`, each other (h2 = "h1"), and with `distance_to` also d (distance to the nearest
/// of the curves), tx, ty (its unit tangent there) and c (its curvature, 1/length).
struct DirectionalSizes {
  ExpressionText h1, h2;
  std::optional<std::array<ExpressionText, 2>> e1;  ///< any length; default (1, 0)
  std::vector<NamedExpression> where;
  std::vector<std::string> distance_to;
  std::string place;
};

/// The metric is the intersection of the list, in its order (Eqn 8).
struct PrescribedMetric {
  Constants constants;
  std::vector<DirectionalSizes> list;
  bool isotropic = false;  ///< the smaller of the two final sizes holds in all directions
};

struct InitialMesh {
  std::filesystem::path file;  ///< empty: made by us with edges of length `size`
  double size = 0;
};

/// A study file with one combination of its [vary] values, in plain structs.
struct Study {
  std::filesystem::path file;
  std::string title;
  Domain domain;  ///< empty when domain_mesh is set
  std::filesystem::path domain_mesh;
  BoundaryDomainOptions domain_options;
  InitialMesh initial;
  Preset preset = Preset::best;
  Elements elements = Elements::triangle;
  QuadOptions quads;  ///< not read for triangles
  Interpolation interpolation = Interpolation::linear_size;
  double chord_height = 0;
  std::int64_t max_elements = 5'000'000;
  /// At least one is set, one problem at most. With a metric and a problem, the metric makes the
  /// meshes and the problem is solved on each.
  std::optional<PrescribedMetric> metric;
  std::optional<ScalarProblemText> problem;
  std::optional<PlateProblemText> plate;
  SolverSettings solver;
  OutputRequests output;
  AdaptSection adapt;
  std::string paper_row;  ///< row of the paper's tables to print beside, e.g. "13b"
};

/// Reads all tables of a study but [vary]. Throws UsageError with file:line:column for unknown
/// keys, wrong types and contradictions, and InputError for impossible geometry.
Study parse_study(const toml::table& root, const std::filesystem::path& file);

/// The [domain] table of a study: curves.NAME, regions.NAME, points.NAME.
Domain parse_domain(TomlTable table);

/// One entry of curves.NAME.
NurbsCurve parse_curve(TomlTable table);

/// The [metric] table, with the sub-table of the mode where the study has one.
PrescribedMetric parse_metric(TomlTable table, AdaptMode mode);

}  // namespace anisofront
