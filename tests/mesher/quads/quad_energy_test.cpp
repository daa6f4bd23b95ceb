#include "mesher/quads/quad_energy.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/predicates.hpp"
#include "mesher/metric/quality.hpp"
#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;

namespace {

using Corners = std::array<Point, 4>;
using Factors = std::array<MetricFactor, 4>;

/// Shape of the quadrilateral seen from its corner `first`.
QuadShape shape_of(const Corners& p, const Factors& r, int first = 0) {
  const auto vertex = [&](int k) { return WorkVertex{p[(first + k) % 4], r[(first + k) % 4], 0}; };
  return quad_shape(quad_view(vertex(1), vertex(2), vertex(3)), p[first], r[first],
                    inverse_of(r[first]));
}
QuadShape shape_of(const Corners& p) { return shape_of(p, {}); }

/// Least of the twice signed areas of the four corner triangles.
double least_corner(const Corners& p) {
  double least = 1e300;
  for (int k = 0; k < 4; ++k)
    least = std::min(least, twice_area(p[k], p[(k + 1) % 4], p[(k + 2) % 4]));
  return least;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("squares and rectangles have the shape 1") {
    for (const double width : {0.1, 1., 30.})
      CHECK(shape_of({{{2, 1}, {2 + width, 1}, {2 + width, 2}, {2, 2}}}).beta() ==
            doctest::Approx(1).epsilon(1e-12));
  }

  TEST_CASE("the shape of a rhombus follows from its angle") {
    // alpha = sqrt3 sin / (2 -+ cos) of the halves: beta = ((2 - cos) / (2 + cos))^2.
    for (const auto& [degrees, beta] : {std::pair{60., 0.36}, {80., 0.70598}, {85., 0.83999}}) {
      const double angle = degrees * 3.141592653589793 / 180;
      const Vector side{std::cos(angle), std::sin(angle)};
      CHECK(shape_of({{{0, 0}, {1, 0}, Vector{1, 0} + side, side}}).beta() ==
            doctest::Approx(beta).epsilon(1e-4));
    }
  }

  TEST_CASE("the least alpha is positive for convex quadrilaterals only") {
    CHECK(shape_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}).least > 0);
    CHECK(shape_of({{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}}).least < 0);   // concave
    CHECK(shape_of({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}).least < 0);       // clockwise
    CHECK(shape_of({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}).least < 0);       // crossing itself
    CHECK(shape_of({{{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}}}).least <= 0);  // flat corner
    CHECK(shape_of({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}).least <= 0);      // double corner
  }

  TEST_CASE("the length defect is near z^2 + z^4 where lengths usually are") {
    CHECK(length_defect(1, 1) == 0);
    for (double z = -1.2; z <= 1.2; z += 0.01) {
      if (std::fabs(z) < 0.25) continue;
      CAPTURE(z);
      const double squared = std::exp2(z), expected = z * z + z * z * z * z;
      CHECK(length_defect(squared, squared) == doctest::Approx(expected).epsilon(0.1));
      // Only the product of the two counts: the geometric mean of the end metrics.
      CHECK(length_defect(3 * squared, squared / 3) ==
            doctest::Approx(length_defect(squared, squared)).epsilon(1e-12));
    }
  }

  TEST_CASE("the length defect grows away from length 1 and is milder to very short edges") {
    double last = 0, last_short = 0;
    for (double l = 1.02; l < 50; l *= 1.02) {
      const double defect = length_defect(l * l, l * l);
      const double of_short = length_defect(1 / (l * l), 1 / (l * l));
      CHECK(defect > last);
      CHECK(of_short > last_short);
      if (l < 1.47)
        CHECK(of_short == doctest::Approx(defect).epsilon(1e-9));
      else
        CHECK(of_short < 1.001 * defect);
      last = defect;
      last_short = of_short;
    }
    CHECK(last_short < 0.1 * last);
  }

  TEST_CASE("the energy of a convex shape is sinh(-ln beta) down to beta 0.014") {
    const auto energy = [](double beta) { return shape_energy(beta, 1, 0.1, {}, 40); };
    CHECK(energy(1) == 0);
    for (const double beta : {0.9, 0.5, 0.1, 0.02}) {
      CHECK(energy(beta) == doctest::Approx(std::sinh(-std::log(beta))).epsilon(1e-12));
      // Only the ratio counts.
      CHECK(shape_energy(0.7 * beta, 0.7, 0.1, {}, 40) ==
            doctest::Approx(energy(beta)).epsilon(1e-12));
    }
    CHECK(energy(1e-3) == 36);
    CHECK(energy(1e-300) == 36);
    QuadWeights weights;
    weights.shape2 = 2;
    CHECK(shape_energy(0.5, 1, 0.1, weights, 40) ==
          doctest::Approx(0.75 + 2 * 0.5625).epsilon(1e-12));
  }

  TEST_CASE("what is not convex weighs more than anything convex and more the worse it is") {
    const auto energy = [](double least) { return shape_energy(-1e-9, 1, least, {}, 40); };
    CHECK(energy(0) == 40);
    CHECK(energy(-0.9) > energy(-0.8));
    CHECK(energy(-5) < 80);  // so that one is never traded for two
    QuadWeights steep;
    steep.shape2 = 1;
    CHECK(shape_energy(1e-300, 1, 1e-300, steep, 40) < 40);
    CHECK(shape_energy(1e-300, 1, 1e-300, {}, 40) < energy(0));
  }
}

TEST_SUITE("property") {
  TEST_CASE("the shape is beta~ from every corner of every convex quadrilateral") {
    std::mt19937_64 random(11);
    int tried = 0;
    while (tried < 5000) {
      Corners p;
      for (Point& q : p) q = random_point(random);
      if (least_corner(p) < 0.02) continue;
      ++tried;
      Factors r;
      for (MetricFactor& f : r) f = factor_of(random_metric(random, 100));
      const double expected = beta(r, p);
      double least = 1;
      for (const auto& [i, j, k] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}})
        least = std::min(least, alpha(std::array{r[i], r[j], r[k]}, std::array{p[i], p[j], p[k]}));
      for (int first = 0; first < 4; ++first) {
        const QuadShape shape = shape_of(p, r, first);
        CHECK(shape.beta() == doctest::Approx(expected).epsilon(1e-11));
        CHECK(shape.least == doctest::Approx(least).epsilon(1e-11));
      }
    }
  }

  TEST_CASE("the sign of the least alpha says whether a quadrilateral is convex") {
    std::mt19937_64 random(12);
    int convex = 0, others = 0;
    for (int i = 0; i < 20000; ++i) {
      Corners p;
      Factors r;
      for (int k = 0; k < 4; ++k) {
        p[k] = random_point(random);
        r[k] = factor_of(random_metric(random, 100));
      }
      const double least = least_corner(p);
      if (std::fabs(least) < 1e-9) continue;  // within rounding of flat
      ++(least > 0 ? convex : others);
      CHECK((shape_of(p, r).least > 0) == (least > 0));
    }
    CHECK(convex > 1000);
    CHECK(others > 1000);
  }
}
