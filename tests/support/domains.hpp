#pragma once

// Domains that several tests mesh, with what their meshes must have.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesher/geometry/domain.hpp"

namespace anisofront::testing {

constexpr double kPi = 3.141592653589793;

/// One line per side, named "<name>-<k>"; returns the numbers of the curves.
inline std::vector<Index> add_polygon(Domain& domain, const std::vector<Point>& corners,
                                      const std::string& name, Index tag) {
  std::vector<Index> curves;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    curves.push_back(static_cast<Index>(domain.curves.size()));
    domain.curves.push_back({name + "-" + std::to_string(i), tag,
                             make_line(corners[i], corners[(i + 1) % corners.size()])});
  }
  return curves;
}

inline Index add_curve(Domain& domain, const std::string& name, Index tag, NurbsCurve curve) {
  domain.curves.push_back({name, tag, std::move(curve)});
  return static_cast<Index>(domain.curves.size()) - 1;
}

/// [0, side]^2 with curves side1 to side4 (tags 1 to 4) from the bottom on, region "domain" (tag
/// 5).
inline Domain square_domain(double side) {
  Domain domain;
  const Point p[4] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (int k = 0; k < 4; ++k)
    add_curve(domain, "side" + std::to_string(k + 1), k + 1, make_line(p[k], p[(k + 1) % 4]));
  add_region(domain, "domain", 5, {0, 1, 2, 3}, {});
  return domain;
}

/// Shoelace formula, from the first corner and in long double.
inline double polygon_area(const std::vector<Point>& corners) {
  long double sum = 0;
  const Point o = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const long double ux = static_cast<long double>(corners[i].x) - o.x;
    const long double uy = static_cast<long double>(corners[i].y) - o.y;
    const long double vx = static_cast<long double>(corners[i + 1].x) - o.x;
    const long double vy = static_cast<long double>(corners[i + 1].y) - o.y;
    sum += ux * vy - uy * vx;
  }
  return static_cast<double>(sum / 2);
}

/// Star-shaped polygon around the centre, anticlockwise: corners at evenly spread angles (moved a
/// little) with radii between `least` and 1 times the radius.
inline std::vector<Point> star_polygon(std::mt19937_64& random, Point centre, double radius,
                                       int corners, double least) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point> polygon;
  for (int i = 0; i < corners; ++i) {
    const double phi = 2 * kPi * (i + 0.6 * unit(random)) / corners;
    const double r = radius * std::lerp(least, 1., unit(random));
    polygon.push_back(centre + r * Vector{std::cos(phi), std::sin(phi)});
  }
  return polygon;
}

/// A domain with what its mesh must have.
struct KnownDomain {
  Domain domain;
  double area = 0;
  Index holes = 0;  ///< of the union of the regions
};

/// Random star polygon of radius 1 around the centre with up to three star-shaped holes, all
/// straight.
inline KnownDomain star_domain(std::mt19937_64& random, Point centre = {0, 0}, double scale = 1) {
  KnownDomain known;
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const std::vector<Point> outer = star_polygon(random, centre, scale, pick(5, 14), 0.5);
  const std::vector<Index> boundary = add_polygon(known.domain, outer, "outer", 1);
  known.area = polygon_area(outer);
  known.holes = pick(0, 3);
  std::vector<std::vector<Index>> holes;
  // The polygon holds the disc of half its least radius (its corners lie less than 120 degrees
  // apart), so three holes in it around 120 degrees stay apart.
  for (int k = 0; k < known.holes; ++k) {
    const double phi = 2 * kPi * k / 3;
    const Point c = centre + 0.13 * scale * Vector{std::cos(phi), std::sin(phi)};
    const std::vector<Point> hole = star_polygon(random, c, 0.09 * scale, pick(3, 8), 0.3);
    known.area -= polygon_area(hole);
    holes.push_back(add_polygon(known.domain, hole, "hole" + std::to_string(k), 2 + k));
  }
  add_region(known.domain, "star", 10, boundary, holes);
  return known;
}

}  // namespace anisofront::testing
