// Rules of D. A. Dunavant, High degree efficient symmetrical Gaussian quadrature rules for the
// triangle, Int. J. Numer. Meth. Engng 21 (1985) 1129-1148, doi:10.1002/nme.1620210612, their 15
// digits polished to double precision by Newton steps on the moment equations. Degrees 3, 7, 9-11
// are served by the next rule: Dunavant's of degrees 3, 7 and 11 have negative weights or points
// outside, and 9 and 10 save too little to deserve a table.
#include "solver/space/quadrature.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace anisofront {
namespace {

using Rule = std::vector<QuadraturePoint>;

/// Points that symmetry makes equal: the centre, three points (a, a, 1-2a), six (a, b, 1-a-b).
struct Centre {
  double weight;
};
struct Orbit3 {
  double weight, a;
};
struct Orbit6 {
  double weight, a, b;
};

Rule expand(const std::vector<Centre>& centres, const std::vector<Orbit3>& threes,
            const std::vector<Orbit6>& sixes) {
  Rule rule;
  for (const auto& [w] : centres) rule.push_back({{1. / 3, 1. / 3, 1. / 3}, w});
  for (const auto& [w, a] : threes) {
    const double b = 1 - 2 * a;
    for (const auto& l : {std::array{a, a, b}, {a, b, a}, {b, a, a}}) rule.push_back({l, w});
  }
  for (const auto& [w, a, b] : sixes) {
    const double c = 1 - a - b;
    for (const auto& l :
         {std::array{a, b, c}, {a, c, b}, {b, a, c}, {b, c, a}, {c, a, b}, {c, b, a}})
      rule.push_back({l, w});
  }
  return rule;
}

const Rule& degree_1() {
  static const Rule rule = expand({{1}}, {}, {});
  return rule;
}

const Rule& degree_2() {
  static const Rule rule = expand({}, {{1. / 3, 1. / 6}}, {});
  return rule;
}

const Rule& degree_4() {
  static const Rule rule = expand(
      {}, {{0.22338158967801147, 0.44594849091596489}, {0.10995174365532187, 0.091576213509770743}},
      {});
  return rule;
}

const Rule& degree_6() {
  static const Rule rule = expand(
      {}, {{0.1167862757263794, 0.2492867451709104}, {0.050844906370206823, 0.063089014491502233}},
      {{0.082851075618373554, 0.053145049844816932, 0.31035245103378442}});
  return rule;
}

const Rule& degree_8() {
  static const Rule rule =
      expand({{0.14431560767778725}},
             {{0.095091634267284575, 0.4592925882927232},
              {0.10321737053471823, 0.17056930775176026},
              {0.032458497623198071, 0.050547228317030971}},
             {{0.02723031417443502, 0.0083947774099576911, 0.26311282963463795}});
  return rule;
}

const Rule& degree_12() {
  static const Rule rule =
      expand({},
             {{0.025731066440424627, 0.48821738977383621},
              {0.043692544537935892, 0.43972439229450759},
              {0.062858224217944513, 0.27121038501208532},
              {0.034796112930879258, 0.12757614554186386},
              {0.0061662610515318019, 0.021317350453150311}},
             {{0.040371557766298649, 0.11534349453464872, 0.27571326968594188},
              {0.022356773202328574, 0.022838332222283983, 0.28132558098977846},
              {0.017316231108681398, 0.025734050548370144, 0.11625191590745875}});
  return rule;
}

}  // namespace

std::span<const QuadraturePoint> triangle_quadrature(int degree) {
  if (degree < 0 || degree > kMaxQuadratureDegree)
    throw std::out_of_range("triangle_quadrature: degree " + std::to_string(degree) +
                            ", expected 0 to " + std::to_string(kMaxQuadratureDegree));
  if (degree <= 1) return degree_1();
  if (degree <= 2) return degree_2();
  if (degree <= 4) return degree_4();
  if (degree <= 6) return degree_6();
  if (degree <= 8) return degree_8();
  return degree_12();
}

}  // namespace anisofront
