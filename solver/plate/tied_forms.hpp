#pragma once

#include "solver/plate/plate_forms.hpp"
#include "solver/plate/tied_strains.hpp"

namespace anisofront {

template <class Family>
using FormsOf = PlateForms<Family::kDeflections, Family::kRotations>;

/// The forms of any element, by quadrature. Throws InputError, see positive_determinant().
template <class Family>
FormsOf<Family> integrated_forms(const TiedTables<Family>& tables, const Element& element) {
  const RotationTies<Family> ties = rotation_ties(tables, element);
  FormsOf<Family> forms;
  forms.set_zero();
  for (const auto& f : element.bent ? tables.bent_points : tables.points) {
    const MapPoint map = map_at(element, f.point.at);
    const double weight = f.point.weight * positive_determinant(map, element);
    const auto strains = strains_at<Family>(map, ties, f);
    forms.gradients.add_products(weight, strains.dx, strains.dy);
    forms.shear.add_products(weight, strains.deflection, strains.x, strains.y);
  }
  return forms;
}

/// Integrals over the reference element. As J is constant on straight triangles, their forms are
/// combinations of these.
template <class Family>
struct ReferenceForms {
  RotationBlocks<Family::kRotations> gradients;
  /// The squares of g~_xi, of g~_eta and twice their product, for w and the covariant components
  /// of theta.
  PlateBlocks<Family::kDeflections, Family::kRotations> xi, eta, mixed;

  explicit ReferenceForms(const TiedTables<Family>& tables);
};

template <class Family>
ReferenceForms<Family>::ReferenceForms(const TiedTables<Family>& tables) {
  Element reference;
  reference.nodes = {{{0, 0}, {1, 0}, {0, 1}}};
  const RotationTies<Family> ties = rotation_ties(tables, reference);
  gradients.set_zero();
  for (auto* form : {&xi, &eta, &mixed}) form->set_zero();
  for (const auto& f : tables.points) {
    const double weight = f.point.weight;
    const auto [dx, dy, w, x, y] = strains_at<Family>(map_at(reference, f.point.at), ties, f);
    gradients.add_products(weight, dx, dy);
    const Block<2, 1> a(1, 0), b(0, 1), sum(1, 1);
    xi.add_products(weight, product(w, a), product(x, a), product(y, a));
    eta.add_products(weight, product(w, b), product(x, b), product(y, b));
    mixed.add_products(weight, product(w, sum), product(x, sum), product(y, sum));
  }
  mixed = combination({1, -1, -1}, {&mixed, &xi, &eta});  // 2 a b = (a + b)^2 - a^2 - b^2
}

/// The forms of a straight triangle: gamma . gamma = g~' (J J')^-1 g~ and theta_cov = J theta.
template <class Family>
FormsOf<Family> affine_forms(const ReferenceForms<Family>& reference, const Element& element) {
  const MapPoint map = map_at(element, {0, 0});
  const Vector u = map.d_xi, v = map.d_eta;
  const double det = positive_determinant(map, element), s = 1 / det;
  FormsOf<Family> forms;
  // d_x N = (v.y d_xi N - u.y d_eta N) / det, d_y N = (u.x d_eta N - v.x d_xi N) / det
  forms.gradients = substituted(reference.gradients, s, {v.y, -u.y}, {-v.x, u.x});
  const auto [ww, w0, w1, rotation] =
      combination({s * dot(v, v), s * dot(u, u), -s * dot(u, v)},
                  {&reference.xi, &reference.eta, &reference.mixed});
  forms.shear = {ww, combination({u.x, v.x}, {&w0, &w1}), combination({u.y, v.y}, {&w0, &w1}),
                 substituted(rotation, 1, {u.x, v.x}, {u.y, v.y})};
  return forms;
}

}  // namespace anisofront
