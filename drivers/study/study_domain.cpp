#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/study/study.hpp"

namespace anisofront {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

NurbsCurve parse_line(TomlTable& table) {
  const std::vector<Point> ends = table.points("line");
  if (ends.size() != 2)
    table.fail("line", fmt::format("expected two points [[x, y], [x, y]], found {}; for more "
                                   "points write polyline",
                                   ends.size()));
  return make_line(ends[0], ends[1]);
}

std::vector<Point> vertices_of(TomlTable& table, const std::string& kind) {
  std::vector<Point> vertices = table.points(kind);
  if (vertices.size() < 2)
    table.fail(kind, fmt::format("expected at least two points, found {}", vertices.size()));
  return vertices;
}

NurbsCurve parse_polyline(TomlTable& table) {
  return make_polyline(vertices_of(table, "polyline"));
}

NurbsCurve parse_spline(TomlTable& table) { return make_spline(vertices_of(table, "spline")); }

NurbsCurve parse_circle(TomlTable& table) {
  TomlTable circle = table.required(table.table("circle"), "circle");
  const Point centre = circle.required(circle.point("centre"), "centre");
  const double radius = circle.required(circle.positive("radius"), "radius");
  circle.finish();
  return make_circle(centre, radius);
}

/// Angles in degrees, anticlockwise from the x axis.
NurbsCurve parse_arc(TomlTable& table) {
  TomlTable arc = table.required(table.table("arc"), "arc");
  const Point centre = arc.required(arc.point("centre"), "centre");
  const double radius = arc.required(arc.positive("radius"), "radius");
  const double start = arc.required(arc.number("start"), "start");
  const double end = arc.required(arc.number("end"), "end");
  if (std::abs(end - start) > 360)
    arc.fail("end", "an arc turns by 360 degrees at most; angles are in degrees");
  if (start == end) arc.fail("end", "start and end are equal; for a full circle write circle");
  arc.finish();
  return make_arc(centre, radius, start * kDegree, end * kDegree);
}

NurbsCurve parse_ellipse(TomlTable& table) {
  TomlTable ellipse = table.required(table.table("ellipse"), "ellipse");
  const Point centre = ellipse.required(ellipse.point("centre"), "centre");
  const Point radii = ellipse.required(ellipse.point("radii"), "radii");
  if (radii.x <= 0 || radii.y <= 0) ellipse.fail("radii", "must be positive");
  const double rotation = ellipse.number("rotation").value_or(0);
  ellipse.finish();
  return make_ellipse(centre, radii.x, radii.y, rotation * kDegree);
}

NurbsCurve parse_nurbs(TomlTable& table) {
  TomlTable nurbs = table.required(table.table("nurbs"), "nurbs");
  NurbsCurve curve;
  curve.degree = nurbs.required(nurbs.integer("degree"), "degree");
  curve.knots = nurbs.numbers("knots");
  curve.points = nurbs.points("points");
  curve.weights = nurbs.has("weights") ? nurbs.numbers("weights")
                                       : std::vector<double>(curve.points.size(), 1.);
  nurbs.finish();
  try {
    validate(curve);
  } catch (const InputError& error) {
    nurbs.fail({}, error.what());
  }
  return curve;
}

struct CurveKind {
  const char* name;
  NurbsCurve (*parse)(TomlTable&);
};
constexpr std::array<CurveKind, 7> kCurveKinds{{{"line", parse_line},
                                                {"polyline", parse_polyline},
                                                {"spline", parse_spline},
                                                {"circle", parse_circle},
                                                {"arc", parse_arc},
                                                {"ellipse", parse_ellipse},
                                                {"nurbs", parse_nurbs}}};

Index curve_named(const Domain& domain, const TomlTable& table, const std::string& key,
                  const std::string& name) {
  const Index curve = find_curve(domain, name);
  if (curve != kNoIndex) return curve;
  std::vector<std::string> known;
  for (const DomainCurve& c : domain.curves) known.push_back(c.name);
  table.fail(key, fmt::format("no curve is called \"{}\"{}", name, name_proposal(name, known)));
}

std::vector<Index> curves_named(const Domain& domain, const TomlTable& table,
                                const std::string& key, const std::vector<std::string>& names) {
  std::vector<Index> curves;
  for (const std::string& name : names) curves.push_back(curve_named(domain, table, key, name));
  return curves;
}

void read_curves(TomlTable& table, Domain& domain) {
  TomlTable curves = table.required(table.table("curves"), "curves");
  for (const std::string& name : curves.keys()) {
    const TomlTable entry = curves.required(curves.table(name), name);
    domain.curves.push_back(
        {name, static_cast<Index>(domain.curves.size() + 1), parse_curve(entry)});
  }
}

void read_region(TomlTable entry, const std::string& name, Domain& domain) {
  const auto boundary = curves_named(domain, entry, "boundary", entry.texts("boundary"));
  if (boundary.empty())
    entry.fail({}, "needs boundary = [\"curve\", ...], the curves that close around it");
  std::vector<std::vector<Index>> holes;
  for (const auto& names : entry.lists_of_texts("holes"))
    holes.push_back(curves_named(domain, entry, "holes", names));
  const auto embedded = curves_named(domain, entry, "embedded", entry.texts("embedded"));
  entry.finish();
  const auto tag = static_cast<Index>(domain.regions.size() + 1);
  add_region(domain, name, tag, boundary, holes);
  domain.regions.back().embedded_curves = embedded;
}

void read_regions(TomlTable& table, Domain& domain) {
  TomlTable regions = table.required(table.table("regions"), "regions");
  for (const std::string& name : regions.keys())
    read_region(regions.required(regions.table(name), name), name, domain);
}

void read_points(TomlTable& table, Domain& domain) {
  auto points = table.table("points");
  if (!points) return;
  for (const std::string& name : points->keys())
    domain.points.push_back({name, static_cast<Index>(domain.points.size() + 1),
                             points->required(points->point(name), name)});
}

}  // namespace

NurbsCurve parse_curve(TomlTable table) {
  const CurveKind* found = nullptr;
  for (const CurveKind& kind : kCurveKinds) {
    if (!table.has(kind.name)) continue;
    if (found != nullptr)
      table.fail(kind.name, fmt::format("the curve is already a {}", found->name));
    found = &kind;
  }
  table.finish();
  if (found == nullptr)
    table.fail({}, "expected one of line, polyline, spline, circle, arc, ellipse, nurbs");
  return found->parse(table);
}

Domain parse_domain(TomlTable table) {
  Domain domain;
  read_curves(table, domain);
  read_regions(table, domain);
  read_points(table, domain);
  table.finish();
  validate(domain);
  return domain;
}

}  // namespace anisofront
