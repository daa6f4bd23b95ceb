#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesher/geometry/monitor.hpp"
#include "mesher/io/gmsh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

// Medit ASCII files. Reference: P. Frey, MEDIT: an interactive mesh visualization software,
// INRIA technical report RT-0253 (2001), appendix.

/// Reads a Medit ASCII .mesh in two dimensions (Vertices, Edges, Triangles, Quadrilaterals,
/// Corners, RequiredVertices; other sections are skipped, with a warning when they would matter),
/// or in three with constant z, which is dropped. References become vertex_tags, CurveEdge::tag
/// and regions; CurveEdge::curve stays kNoIndex. Clockwise elements are turned round.
/// Fast: at 1e6 triangles reading is a tenth of the meshing time.
/// Throws InputError with file and line, what was found and what was expected; UsageError when
/// the file does not exist.
Mesh read_medit(const std::filesystem::path& path, const Monitor& monitor = {});

/// read_medit() on the bytes of a file; `name` is what error messages call it.
Mesh parse_medit(std::string_view bytes, const std::string& name, const Monitor& monitor = {});

/// Writes the vertices, elements, curve edges, tags, corners and required vertices; what Medit
/// cannot hold (curve indices and parameters, group names) is lost. Atomic, shortest exact
/// decimals. Throws InputError when the file cannot be written (the old file stays).
void write_medit(const std::filesystem::path& path, const Mesh& mesh);

/// Reads a Medit .sol with one tensor (m11 m12 m22) or one scalar size h (M = I/h^2) per vertex.
/// Throws InputError naming line and vertex of entries that are missing, not finite or not positive
/// definite, and when their number differs from `vertex_count`.
MetricField read_medit_metric(const std::filesystem::path& path, Index vertex_count);

/// read_medit_metric() on the bytes of a file; `name` is what error messages call it.
MetricField parse_medit_metric(std::string_view bytes, const std::string& name, Index vertex_count);

void write_medit_metric(const std::filesystem::path& path, const MetricField& field);

}  // namespace anisofront
