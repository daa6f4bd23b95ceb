#pragma once

#include <vector>

#include "solver/plate/shear_tying.hpp"
#include "solver/plate/small_blocks.hpp"
#include "solver/space/basis.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {

/// Degree of the rules for the load, on straight and on bent elements.
inline constexpr int kLoadDegree = 6, kBentLoadDegree = 8;

/// What is the same for all elements of a family with tied shear strain. With the covariant shear
/// strain g = grad_ref w - J theta, J[a][b] = dx_b / dxi_a, such an element replaces gamma = J^-1 g
/// by J^-1 g~, where g~ is the combination of the family's shear terms that has the same ties as g.
///
/// A Family (Mitc7, Mitc9, Mitc4, ArnoldFalk) has the shape, the numbers and the functions of w and
/// theta, the terms of g~, its ties, the degrees of quadrature (on straight and on bent elements),
/// whether all its elements count as straight, and the place of each function's unknown among the
/// local unknowns of the element.
template <class Family>
struct TiedTables {
  static constexpr int W = Family::kDeflections, R = Family::kRotations, T = Family::kTies;

  /// The functions at a reference point.
  struct Functions {
    WeightedPoint point;
    Block<W, 1> deflection;
    Block<R, 1> rotation;
    Block<R, 2> rotation_gradient;  ///< in the reference element
    Block<T, 2> shear;              ///< g~ by ties
    Block<W, 2> deflection_shear;   ///< g~ of the deflections
  };

  /// A tie sample with the rotation functions there.
  struct Sample {
    TieSample tie;
    Block<R, 1> rotation;
  };

  std::vector<Sample> samples;
  Block<T, T> terms;            ///< row k: the shear terms of the g~ whose tie k is 1
  Block<W, T> deflection_ties;  ///< of grad_ref w
  std::vector<Functions> points, bent_points;
  std::vector<Functions> load_points, bent_load_points;

  /// Computed on first use.
  static const TiedTables& instance() {
    static const TiedTables tables;
    return tables;
  }
  Functions functions_at(const WeightedPoint& point) const;

 private:
  TiedTables();
  std::vector<Functions> functions_of_rule(int degree) const;
};

template <class Family>
TiedTables<Family>::TiedTables() {
  Eigen::MatrixXd ties_of_terms = Eigen::MatrixXd::Zero(T, T);
  deflection_ties.setZero();
  for (const TieSample& tie : Family::ties()) {
    samples.push_back({tie, as_column(Family::rotations(tie.at).value)});
    const auto terms_there = Family::shear_terms(tie.at);
    for (int i = 0; i < T; ++i) ties_of_terms(i, tie.tie) += dot(terms_there[i], tie.direction);
    const auto slopes = Family::deflections(tie.at).gradient;
    for (int i = 0; i < W; ++i) deflection_ties(i, tie.tie) += dot(slopes[i], tie.direction);
  }
  terms = ties_of_terms.inverse();
  points = functions_of_rule(Family::kDegree);
  bent_points = functions_of_rule(Family::kBentDegree);
  load_points = functions_of_rule(kLoadDegree);
  bent_load_points = functions_of_rule(kBentLoadDegree);
}

template <class Family>
auto TiedTables<Family>::functions_at(const WeightedPoint& point) const -> Functions {
  const auto rotations = Family::rotations(point.at);
  const auto shear = product(terms, as_rows(Family::shear_terms(point.at)));
  return {point,
          as_column(Family::deflections(point.at).value),
          as_column(rotations.value),
          as_rows(rotations.gradient),
          shear,
          product(deflection_ties, shear)};
}

template <class Family>
auto TiedTables<Family>::functions_of_rule(int degree) const -> std::vector<Functions> {
  std::vector<Functions> functions;
  for (const WeightedPoint& point : reference_quadrature(Family::kShape, degree))
    functions.push_back(functions_at(point));
  return functions;
}

}  // namespace anisofront
