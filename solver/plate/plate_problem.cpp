#include "solver/plate/plate_problem.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "mesher/geometry/error.hpp"
#include "solver/plate/plate_text.hpp"

namespace anisofront {
namespace {

using Tags = std::set<Index>;

Tags edge_tags(const Mesh& mesh) {
  Tags tags;
  for (const CurveEdge& edge : mesh.edges) tags.insert(edge.tag);
  tags.erase(0);
  return tags;
}

/// Elements without a region lie in region 0, as in element_at().
Tags region_tags(const Mesh& mesh) {
  Tags tags(mesh.triangle_regions.begin(), mesh.triangle_regions.end());
  tags.insert(mesh.quad_regions.begin(), mesh.quad_regions.end());
  if (mesh.triangle_regions.size() < mesh.triangles.size() ||
      mesh.quad_regions.size() < mesh.quads.size())
    tags.insert(0);
  return tags;
}

std::string list_of(const Mesh& mesh, int dimension, const Tags& tags) {
  std::string text;
  for (const Index tag : tags)
    text += (text.empty() ? "" : ", ") + describe_tag(mesh, dimension, tag);
  return text.empty() ? "none" : text;
}

/// Refuses tags that nothing carries and tags that come twice.
class TagCheck {
 public:
  TagCheck(const Mesh& mesh, int dimension, const Tags& known)
      : mesh_(mesh), dimension_(dimension), known_(known) {}

  void add(Index tag, const std::string& what) {
    const std::string place = what + " on " + describe_tag(mesh_, dimension_, tag);
    const std::string entity = dimension_ == 1 ? "edge" : "element";
    if (known_.count(tag) == 0)
      throw InputError(place + ": no " + entity + " of the mesh carries it; the mesh has " +
                       list_of(mesh_, dimension_, known_));
    if (!seen_.insert(tag).second)
      throw InputError(place + " is given twice, expected once: remove one of the two");
  }

 private:
  const Mesh& mesh_;
  int dimension_;
  const Tags& known_;
  Tags seen_;
};

void require_positive(double value, const char* what, const std::string& place) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(std::string(what) + " of the plate in " + place + " is " + describe(value) +
                     ", expected a positive number");
}

void require_material(const PlateMaterial& material, double side, const std::string& place) {
  require_positive(material.young, "Young's modulus", place);
  require_positive(material.thickness, "the thickness", place);
  require_positive(material.shear_factor, "the shear factor", place);
  if (!(material.poisson > -1 && material.poisson < 0.5))
    throw InputError("Poisson's ratio of the plate in " + place + " is " +
                     describe(material.poisson) + ", expected a number between -1 and 0.5");
  if (material.thickness < kLeastThicknessRatio * side)
    throw InputError(
        "the thickness of the plate in " + place + " is " + describe(material.thickness) + ", " +
        describe(material.thickness / side) + " of the longer side " + describe(side) +
        " of the box round the mesh, expected at least " + describe(kLeastThicknessRatio) +
        ": the condition of the system grows like (L/t)^2 (L/h)^4 and round-off would "
        "take the digits of the result; use a thicker plate (below 1e-3 the result "
        "hardly changes but for the width of its layers)");
}

double longer_side(const Mesh& mesh) {
  Point low = mesh.points.front(), high = low;
  for (const Point p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

/// Functions are checked where they are evaluated.
void require_finite(const Coefficient& coefficient, const std::string& what) {
  if (coefficient.is_constant() && !std::isfinite(coefficient({})))
    throw InputError(what + " is " + describe(coefficient({})) + ", expected a finite number");
}

void require_finite(Point at, double value, const std::string& what) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(value))
    throw InputError(what + " at " + describe(at) + " is " + describe(value) +
                     ", expected finite numbers");
}

void check_regions(const PlateProblem& problem, const Mesh& mesh) {
  const Tags known = region_tags(mesh);
  TagCheck materials(mesh, 2, known), loads(mesh, 2, known);
  for (const auto& [tag, material] : problem.regions) materials.add(tag, "plate material");
  for (const auto& [tag, load] : problem.load.regions()) {
    loads.add(tag, "load");
    require_finite(load, "the load on " + describe_tag(mesh, 2, tag));
  }
  require_finite(problem.load.everywhere(), "the load");
  for (const Index tag : known)
    require_material(problem.material_in(tag), longer_side(mesh),
                     "region " + describe_tag(mesh, 2, tag));
}

void check_curves(const PlateProblem& problem, const Mesh& mesh) {
  const Tags known = edge_tags(mesh);
  TagCheck supports(mesh, 1, known), loads(mesh, 1, known);
  for (const PlateSupport& support : problem.supports) {
    supports.add(support.tag, "support");
    require_finite(support.deflection,
                   "the deflection prescribed on " + describe_tag(mesh, 1, support.tag));
  }
  for (const PlateEdgeLoad& load : problem.edge_loads) {
    loads.add(load.tag, "edge load");
    for (const Coefficient* value : {&load.shear, &load.moment, &load.twist})
      require_finite(*value, "the edge load on " + describe_tag(mesh, 1, load.tag));
  }
}

/// They would leave empty rows in the system.
void check_vertices(const FeMesh& mesh) {
  std::vector<char> is_used(mesh.mesh.points.size(), 0);
  for (const auto& [a, b] : mesh.edges.vertices) is_used[a] = is_used[b] = 1;
  const auto unused = std::find(is_used.begin(), is_used.end(), 0);
  if (unused == is_used.end()) return;
  const auto v = static_cast<std::size_t>(unused - is_used.begin());
  throw InputError("vertex " + std::to_string(v + 1) + " of the mesh at " +
                   describe(mesh.mesh.points[v]) +
                   " belongs to no element, expected elements round every vertex: remove it");
}

}  // namespace

HeldComponents held_components(SupportKind kind) {
  switch (kind) {
    case SupportKind::clamped:
      return {true, true, true};
    case SupportKind::soft_clamped:
      return {true, true, false};
    case SupportKind::hard_support:
    case SupportKind::antisymmetry:
      return {true, false, true};
    case SupportKind::soft_support:
      return {true, false, false};
    case SupportKind::symmetry:
      return {false, true, false};
    case SupportKind::free:
      break;
  }
  return {};
}

const PlateMaterial& PlateProblem::material_in(Index region) const {
  for (const auto& [tag, own] : regions)
    if (tag == region) return own;
  return material;
}

void validate(const PlateProblem& problem, const FeMesh& mesh) {
  check_vertices(mesh);
  check_regions(problem, mesh.mesh);
  check_curves(problem, mesh.mesh);
  for (const PlatePointLoad& load : problem.point_loads)
    require_finite(load.at, load.force, "the point load");
  for (const PlatePointSupport& support : problem.point_supports)
    require_finite(support.at, support.deflection, "the deflection of the point support");
}

}  // namespace anisofront
