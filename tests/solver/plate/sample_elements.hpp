#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "solver/plate/plate_elements.hpp"
#include "solver/space/reference_quadrature.hpp"
#include "tests/solver/plate/plate_cases.hpp"

namespace anisofront::test {

/// Sets the middles of the edges, moved by `bend` across each of the bent ones, and the centre.
inline Element with_edges(Element element, const std::vector<int>& bent_edges, double bend) {
  const int n = element.corners;
  for (int k = 0; k < n; ++k)
    element.nodes[n + k] = lerp(element.nodes[k], element.nodes[(k + 1) % n], 0.5);
  for (const int k : bent_edges) {
    const Vector along = element.nodes[(k + 1) % n] - element.nodes[k];
    element.nodes[n + k] = element.nodes[n + k] + bend * Vector{along.y, -along.x};
    element.bent = true;
  }
  if (n == 3) return element;
  Vector corners{}, edges{};
  for (int k = 0; k < 4; ++k) {
    corners = corners + element.nodes[k];
    edges = edges + element.nodes[4 + k];
  }
  element.nodes[8] = 0.5 * edges - 0.25 * corners;
  return element;
}

inline Element triangle_element(const std::array<Point, 3>& corners,
                                const std::vector<int>& bent = {}, double bend = 0.1) {
  Element element;
  std::copy(corners.begin(), corners.end(), element.nodes.begin());
  return with_edges(element, bent, bend);
}

inline Element quad_element(const std::array<Point, 4>& corners, const std::vector<int>& bent = {},
                            double bend = 0.1) {
  Element element;
  element.shape = Shape::quadrilateral;
  element.corners = 4;
  std::copy(corners.begin(), corners.end(), element.nodes.begin());
  return with_edges(element, bent, bend);
}

/// The element with all its nodes moved by an affine map.
inline Element moved(Element element, const std::function<Point(Point)>& map) {
  for (Point& node : element.nodes) node = map(node);
  return element;
}

/// Stretched by `aspect` in the direction of 30 degrees.
inline Element stretched(const Element& element, double aspect) {
  return moved(element, [aspect](Point p) {
    const Point q = turned(p, -0.5236);
    return turned({aspect * q.x, q.y}, 0.5236);
  });
}

inline Element obtuse_triangle() {
  return triangle_element({{{0.2, 0.1}, {1.3, 0.3}, {0.5, 0.6}}});
}
inline Element skew_quad() { return quad_element({{{0, 0}, {1.2, -0.2}, {0.9, 0.8}, {0.1, 1.3}}}); }

/// A family on a shape that it allows.
struct Candidate {
  const char* name;
  PlateElement kind;
  Element element;
};

inline std::vector<Candidate> straight_candidates() {
  return {{"MITC7", PlateElement::mitc, obtuse_triangle()},
          {"MITC9", PlateElement::mitc, skew_quad()},
          {"MITC4", PlateElement::mitc4, skew_quad()},
          {"Arnold-Falk", PlateElement::arnold_falk, obtuse_triangle()}};
}

inline std::vector<Candidate> bent_candidates() {
  auto candidates = straight_candidates();
  for (Candidate& c : candidates) c.element = with_edges(c.element, {0, 2}, 0.1);
  return candidates;
}

using DeflectionField = std::function<double(Point)>;
using RotationField = std::function<Vector(Point)>;

/// Unknowns of w and theta; for Arnold-Falk w is averaged over the edges (Simpson: up to third
/// degree). The bubble of triangles is left out: theta must be of second degree in the reference
/// coordinates.
inline LocalValues interpolated(PlateElement kind, const Element& element, const DeflectionField& w,
                                const RotationField& theta) {
  std::vector<double> values;
  const auto add_rotation = [&](Point p) {
    values.push_back(theta(p).x);
    values.push_back(theta(p).y);
  };
  const int n = element.corners;
  if (kind == PlateElement::arnold_falk) {
    for (int k = 0; k < 3; ++k) add_rotation(element.nodes[k]);
    for (int k = 0; k < 3; ++k) {
      const Point a = element.nodes[k], b = element.nodes[(k + 1) % 3];
      values.push_back((w(a) + 4 * w(lerp(a, b, 0.5)) + w(b)) / 6);
    }
  } else {
    for (int k = 0; k < (kind == PlateElement::mitc ? 2 * n : n); ++k) {
      values.push_back(w(element.nodes[k]));
      add_rotation(element.nodes[k]);
    }
  }
  if (kind == PlateElement::mitc && n == 4) add_rotation(element.nodes[8]);
  if (n == 3) values.insert(values.end(), {0, 0});
  return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

inline LocalValues random_values(PlateElement kind, const Element& element, std::uint64_t seed) {
  const int counts[3][2] = {{20, 26}, {0, 12}, {11, 0}};
  LocalValues values(counts[static_cast<int>(kind)][element.corners - 3]);
  Noise noise(seed);
  for (double& value : values) value = noise();
  return values;
}

inline ElementSystem system_of(PlateElement kind, const Element& element,
                               const PlateProblem& problem) {
  ElementSystem system;
  plate_kernel(kind, problem)(element, system);
  return system;
}

/// 1/2 int M : C^-1 : M and 1/2 int Q . Q / (k G t) of the states, by a rule of degree 12.
inline PlateEnergy integrated_energy(const Candidate& c, const PlateMaterial& material,
                                     const LocalValues& values) {
  PlateEnergy energy;
  for (const auto& [at, weight] : reference_quadrature(c.element.shape, 12)) {
    const PlateState s = plate_state(c.kind, material, c.element, values, at);
    const auto& [xx, yy, xy] = s.moments;
    const double nu = material.poisson, dx = weight * map_at(c.element, at).determinant();
    // C^-1 = [1 -nu 0; -nu 1 0; 0 0 2 (1 + nu)] / (D (1 - nu^2))
    energy.bending += 0.5 * dx * (xx * xx + yy * yy - 2 * nu * xx * yy + 2 * (1 + nu) * xy * xy) /
                      (material.bending_stiffness() * (1 - nu * nu));
    energy.shear += 0.5 * dx * squared_norm(s.shear) / material.shear_stiffness();
  }
  return energy;
}

/// Points inside the reference element and on its edge.
inline std::vector<ReferencePoint> probes(Shape shape) {
  if (shape == Shape::triangle) return {{1. / 3, 1. / 3}, {0.7, 0.1}, {0.1, 0.2}, {0.5, 0.5}};
  return {{0, 0}, {0.7, -0.4}, {-0.3, -0.9}, {1, 0.2}};
}

}  // namespace anisofront::test
