#pragma once

#include <algorithm>

#include "solver/plate/plate_elements.hpp"
#include "solver/plate/tied_forms.hpp"

namespace anisofront {

// Matrices and fields of one family of plate elements with tied shear strain (see TiedTables).

/// The unknowns of an element by field.
template <class Family>
struct FieldValues {
  Block<Family::kDeflections, 1> w;
  Block<Family::kRotations, 1> x, y;

  explicit FieldValues(const LocalValues& values) {
    for (int i = 0; i < Family::kDeflections; ++i) w[i] = values[Family::deflection_unknown(i)];
    for (int i = 0; i < Family::kRotations; ++i) {
      x[i] = values[Family::rotation_unknown(i)];
      y[i] = values[Family::rotation_unknown(i) + 1];
    }
  }
};

/// The element that the family sees: straight where it takes all elements as straight.
template <class Family>
Element seen_by(const Element& element) {
  Element seen = element;
  if (Family::kIsStraight) seen.bent = false;
  return seen;
}

/// affine_forms() lose this many times the rounding error to cancellation at an acute angle between
/// two long sides (at 64 the patch test misses its bar, 1e-10, by a factor of two).
inline constexpr double kMostCancellation = 16;

inline bool is_mild(const Element& triangle) {
  const Vector u = triangle.nodes[1] - triangle.nodes[0], v = triangle.nodes[2] - triangle.nodes[0];
  return std::max(squared_norm(u), squared_norm(v)) <= kMostCancellation * cross(u, v);
}

template <class Family>
FormsOf<Family> forms_of(const Element& element) {
  const auto& tables = TiedTables<Family>::instance();
  if constexpr (Family::kShape == Shape::triangle) {
    static const ReferenceForms<Family> reference(tables);
    if (!element.bent && is_mild(element)) return affine_forms(reference, element);
  }
  return integrated_forms(tables, element);
}

/// Writes D times the bending and kGt times the shear form into the places of the unknowns.
template <class Family>
void write_stiffness(const FormsOf<Family>& forms, const PlateMaterial& material,
                     ElementSystem& system) {
  const double bending = material.bending_stiffness(), shear = material.shear_stiffness();
  const auto curvature = bending_form(forms.gradients, material.poisson);
  const auto& [ww, wx, wy, rotation] = forms.shear;
  auto& matrix = system.matrix;
  const auto write = [&matrix](int row, int column, double value) {
    matrix(row, column) = value;
    matrix(column, row) = value;
  };
  for (int j = 0; j < Family::kDeflections; ++j) {
    const int w = Family::deflection_unknown(j);
    for (int i = 0; i <= j; ++i) write(Family::deflection_unknown(i), w, shear * ww(i, j));
    for (int i = 0; i < Family::kRotations; ++i) {
      const int theta = Family::rotation_unknown(i);
      write(theta, w, shear * wx(j, i));
      write(theta + 1, w, shear * wy(j, i));
    }
  }
  for (int j = 0; j < Family::kRotations; ++j) {
    const int x = Family::rotation_unknown(j), y = x + 1;
    for (int i = 0; i < Family::kRotations; ++i) {
      const int row = Family::rotation_unknown(i);
      write(row, y, bending * curvature.xy(i, j) + shear * rotation.xy(i, j));
      if (i > j) continue;
      write(row, x, bending * curvature.xx(i, j) + shear * rotation.xx(i, j));
      write(row + 1, y, bending * curvature.yy(i, j) + shear * rotation.yy(i, j));
    }
  }
}

/// int q w. Throws InputError where q is not finite.
template <class Family>
void add_load(const Element& element, const Coefficient& load, ElementSystem& system) {
  const auto& tables = TiedTables<Family>::instance();
  for (const auto& f : element.bent ? tables.bent_load_points : tables.load_points) {
    const MapPoint map = map_at(element, f.point.at);
    const double q = finite_value(load, map.x, "load of the plate");
    const double weight = q * f.point.weight * map.determinant();
    for (int i = 0; i < Family::kDeflections; ++i)
      system.rhs[Family::deflection_unknown(i)] += weight * f.deflection[i];
  }
}

/// Stiffness and load. Throws InputError where the load is not finite or the map not positive.
template <class Family>
void fill_system(const Element& given, const PlateMaterial& material, const Coefficient& load,
                 ElementSystem& system) {
  const Element element = seen_by<Family>(given);
  system.matrix.resize(Family::kUnknowns, Family::kUnknowns);
  system.rhs.setZero(Family::kUnknowns);
  write_stiffness<Family>(forms_of<Family>(element), material, system);
  if (!load.is_zero()) add_load<Family>(element, load, system);
}

template <class Family>
PlateEnergy energy_of(const Element& element, const PlateMaterial& material,
                      const LocalValues& values) {
  const FieldValues<Family> u(values);
  const auto forms = forms_of<Family>(seen_by<Family>(element));
  const auto curvature = bending_form(forms.gradients, material.poisson);
  return {0.5 * material.bending_stiffness() * curvature.square(u.x, u.y),
          0.5 * material.shear_stiffness() * forms.shear.square(u.w, u.x, u.y)};
}

template <class Family>
PlateState state_of(const Element& given, const PlateMaterial& material, const LocalValues& values,
                    ReferencePoint at) {
  const auto& tables = TiedTables<Family>::instance();
  const Element element = seen_by<Family>(given);
  const FieldValues<Family> u(values);
  const auto f = tables.functions_at({at, 1});
  const auto strains = strains_at<Family>(map_at(element, at), rotation_ties(tables, element), f);

  PlateState state;
  state.x = map_at(given, at).x;
  state.w = dot(u.w, f.deflection);
  state.rotation = {dot(u.x, f.rotation), dot(u.y, f.rotation)};
  const double xx = dot(u.x, strains.dx), yy = dot(u.y, strains.dy),
               xy = dot(u.x, strains.dy) + dot(u.y, strains.dx);
  const double bending = material.bending_stiffness(), nu = material.poisson;
  state.moments = {-bending * (xx + nu * yy), -bending * (nu * xx + yy),
                   -bending * 0.5 * (1 - nu) * xy};
  const Vector gamma = combination(u.w, strains.deflection) + combination(u.x, strains.x) +
                       combination(u.y, strains.y);
  state.shear = material.shear_stiffness() * gamma;
  return state;
}

}  // namespace anisofront
