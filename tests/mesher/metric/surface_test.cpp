// Literals were computed with 40 digits (mpmath) for M = [[4, 1, -1/2], [1, 3, 1/4], [-1/2, 1/4,
// 2]] and a twisted torus at (u, v) = (0.4, 1.1).
#include "mesher/metric/surface.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

using namespace anisofront;
using doctest::Approx;

namespace {

const Metric3 kMetric{4, 1, 3, -0.5, 0.25, 2};
constexpr Vector3 kRu{-1.3448936766091332, 3.1809726764847509, 0.11};
constexpr Vector3 kRv{-0.82085633692087274, -0.34705249280839276, 0.49359612142557739};

void check_close(const Metric3& found, const Metric3& expected, double tolerance) {
  CHECK(std::fabs(found.a - expected.a) <= tolerance);
  CHECK(std::fabs(found.b - expected.b) <= tolerance);
  CHECK(std::fabs(found.c - expected.c) <= tolerance);
  CHECK(std::fabs(found.d - expected.d) <= tolerance);
  CHECK(std::fabs(found.e - expected.e) <= tolerance);
  CHECK(std::fabs(found.f - expected.f) <= tolerance);
}

double norm3(const Vector3& v) { return std::sqrt(dot(v, v)); }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("eigenpairs of a 3x3 metric (A1)") {
    const Eigenpairs3 pairs = eigenpairs(kMetric);
    CHECK(pairs.values[0] == Approx(4.6518757603653777).epsilon(1e-15));
    CHECK(pairs.values[1] == Approx(2.689794467298036).epsilon(1e-15));
    CHECK(pairs.values[2] == Approx(1.6583297723365864).epsilon(1e-15));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 image = kMetric * pairs.vectors[i], &v = pairs.vectors[i];
      const double value = pairs.values[i];
      CHECK(norm3({image.x - value * v.x, image.y - value * v.y, image.z - value * v.z}) < 4e-15);
      CHECK(norm3(v) == Approx(1).epsilon(1e-15));
    }
  }

  TEST_CASE("a diagonal metric keeps its axes in the order of its sizes") {
    const Eigenpairs3 pairs = eigenpairs({1, 0, 100, 0, 0, 4});
    CHECK(pairs.values == std::array<double, 3>{100, 4, 1});
    CHECK(pairs.vectors[0] == Vector3{0, 1, 0});
    CHECK(pairs.vectors[2] == Vector3{1, 0, 0});
  }

  TEST_CASE("squared lengths in space (A2)") {
    CHECK(squared_length(kMetric, {1, -2, 3}) == 4 - 4 + 12 - 3 - 3 + 18);  // by hand
  }

  TEST_CASE("square root and inverse square root of a 3x3 metric (A3a and A3b)") {
    check_close(square_root(kMetric),
                {1.9747943318104784, 0.27556128602348191, 1.7073940215126316, -0.15573478960813819,
                 0.094189346255339312, 1.4024532228768633},
                2e-15);
    check_close(inverse_square_root(kMetric),
                {0.52372230026556985, -0.088059556819425276, 0.60267238142361381,
                 0.064070624864751527, -0.05025426375513839, 0.72352605062401182},
                2e-15);
  }

  TEST_CASE("a positive determinant alone does not make a metric") {
    CHECK(is_positive_definite(kMetric));
    CHECK_FALSE(is_positive_definite(Metric3{-1, 0, -1, 0, 0, 1}));  // det = 1
    CHECK_FALSE(is_positive_definite(Metric3{1, 1, 1, 1, 1, 1}));
    CHECK_FALSE(is_positive_definite(Metric3{0, 0, 0, 0, 0, 0}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(is_positive_definite(Metric3{1, 0, 1, nan, 0, 1}));
  }

  TEST_CASE("the metric of the surface parameters (A7)") {
    const Metric plane = surface_metric({2, 0, 0}, {0, 0, 3});
    CHECK(plane == Metric{4, 0, 9});
    const Metric m = surface_metric(kRu, kRv);
    CHECK(m.m11 == Approx(11.939426169925791).epsilon(1e-15));
    CHECK(m.m12 == Approx(0.054295573356813513).epsilon(1e-14));
    CHECK(m.m22 == Approx(1.0378876897140462).epsilon(1e-15));
  }

  TEST_CASE("the metric of the surface combined with one of space (A9)") {
    const Metric m = surface_metric(kMetric, kRu, kRv);
    CHECK(m.m11 == Approx(29.381669236652729).epsilon(1e-15));
    CHECK(m.m12 == Approx(-0.17176798229332164).epsilon(1e-14));
    CHECK(m.m22 == Approx(4.4331111618119276).epsilon(1e-15));
  }
}

TEST_SUITE("property") {
  TEST_CASE("roots of random metrics square to the metric and to its inverse") {
    std::mt19937_64 random(61);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 2000; ++i) {
      // R'R of a random R with the last row scaled: condition up to about 1e4
      double r[3][3];
      for (auto& row : r)
        for (double& entry : row) entry = normal(random);
      for (double& entry : r[2]) entry *= 0.1;
      const auto product = [&r](int j, int k) {
        return r[0][j] * r[0][k] + r[1][j] * r[1][k] + r[2][j] * r[2][k];
      };
      const Metric3 m{product(0, 0), product(0, 1), product(1, 1),
                      product(0, 2), product(1, 2), product(2, 2)};
      if (eigenpairs(m).values[2] < 1e-4) continue;
      const Metric3 root = square_root(m), inverse = inverse_square_root(m);
      const Vector3 v{normal(random), normal(random), normal(random)};
      const Vector3 image = root * v, back = inverse * image;
      CHECK(dot(image, image) == Approx(squared_length(m, v)).epsilon(1e-11));
      CHECK(norm3({back.x - v.x, back.y - v.y, back.z - v.z}) < 1e-9);
    }
  }

  TEST_CASE("lengths on the surface are those of the mapped vectors (A6 and A8)") {
    std::mt19937_64 random(62);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 500; ++i) {
      const double u = normal(random), v = normal(random);
      const Vector3 dx{u * kRu.x + v * kRv.x, u * kRu.y + v * kRv.y, u * kRu.z + v * kRv.z};
      CHECK(squared_length(surface_metric(kRu, kRv), Vector{u, v}) ==
            Approx(dot(dx, dx)).epsilon(1e-13));
      CHECK(squared_length(surface_metric(kMetric, kRu, kRv), Vector{u, v}) ==
            Approx(squared_length(kMetric, dx)).epsilon(1e-13));
    }
  }
}
