#include "adapt/density.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

using HessianFunction = std::function<Hessian(Point)>;

std::vector<Hessian> at_vertices(const Mesh& mesh, const HessianFunction& h) {
  std::vector<Hessian> field;
  for (const Point& p : mesh.points) field.push_back(h(p));
  return field;
}

/// Hessian of exp(-x / 0.1) + exp(-y / 0.1).
constexpr double kWidth = 0.1;
Hessian two_layers(Point p) {
  const auto decay = [](double s) { return std::exp(-s / kWidth) / (kWidth * kWidth); };
  return {decay(p.x), 0, decay(p.y)};
}

/// The metric of the density whose complexity is `n`.
MetricField scaled_to(const Mesh& mesh, const PrincipalField& density, double n) {
  return scale_metric(mesh, density, complexity, n, {}).field;
}

std::vector<Hessian> random_field(const Mesh& mesh, Noise& noise) {
  return at_vertices(mesh, [&](Point) { return Hessian{3 * noise(), noise(), 0.1 * noise()}; });
}

Eigen::Matrix2d matrix(const Hessian& h) {
  return (Eigen::Matrix2d() << h.xx, h.xy, h.xy, h.yy).finished();
}
Eigen::Matrix2d matrix(const PrincipalMetric& p) {
  const Metric m = metric_of(p);
  return (Eigen::Matrix2d() << m.m11, m.m12, m.m12, m.m22).finished();
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("two exponential layers get the L2 metric of the closed form") {
    // sqrt det M = N (a b)^(1/3) / I^2 with a = exp(-x/w)/w^2 and I the integral of a^(1/3).
    const Mesh mesh = square_mesh(80);
    const MetricField field =
        scaled_to(mesh, metric_density(mesh, {at_vertices(mesh, two_layers)}, {}), 1000);
    const double integral = 3 * std::cbrt(kWidth) * (1 - std::exp(-1 / (3 * kWidth)));
    const double at_origin = 1000 / (integral * integral) * std::pow(kWidth, -4. / 3);
    CHECK(field[0].m11 == doctest::Approx(at_origin).epsilon(2e-3));
    CHECK(field[0].m22 == doctest::Approx(at_origin).epsilon(2e-3));
    // At (1, 0) a is smaller by exp(-10): m11 by exp(-50/6) and m22 larger by exp(10/6).
    CHECK(field[80].m11 == doctest::Approx(at_origin * std::exp(-50. / 6)).epsilon(2e-3));
    CHECK(field[80].m22 == doctest::Approx(at_origin * std::exp(10. / 6)).epsilon(2e-3));
  }

  TEST_CASE("the energy metric has the square of the stretch of the Hessian's eigenvalues") {
    // sqrt det M = N (a b)^(1/2) / I^2 with I = 2 (1 - exp(-1/(2 w))).
    const Mesh mesh = square_mesh(80);
    const DensityOptions options{.norm = MetricNorm::energy};
    const MetricField field =
        scaled_to(mesh, metric_density(mesh, {at_vertices(mesh, two_layers)}, options), 1000);
    const double integral = 2 * (1 - std::exp(-1 / (2 * kWidth)));
    const double at_origin = 1000 / (integral * integral) / (kWidth * kWidth);
    CHECK(field[0].m11 == doctest::Approx(at_origin).epsilon(3e-3));
    CHECK(field[80].m22 / field[80].m11 == doctest::Approx(std::exp(20.)).epsilon(1e-6));
  }

  TEST_CASE("the isotropic counterpart takes the larger curvature both ways") {
    // |H| = diag(8, 1): L2 density l^(2/3) = 4, energy density l = 8, L1 density l^(1/2).
    const Mesh mesh = square_mesh(1);
    const FieldHessians fields{at_vertices(mesh, [](Point) { return Hessian{-8, 0, 1}; })};
    const auto density = [&](MetricNorm norm, double p) {
      DensityOptions options{.mode = AdaptMode::isotropic, .norm = norm, .p = p};
      const PrincipalMetric m = metric_density(mesh, fields, options)[2];
      CHECK(m.l2 == m.l1);
      return m.l1;
    };
    CHECK(density(MetricNorm::lp, 2) == doctest::Approx(4));
    CHECK(density(MetricNorm::lp, 1) == doctest::Approx(std::sqrt(8.)));
    CHECK(density(MetricNorm::energy, 2) == doctest::Approx(8));
  }

  TEST_CASE("curvatures across of two fields at right angles add up to an isotropic metric") {
    const Mesh mesh = square_mesh(2);
    const FieldHessians fields{at_vertices(mesh,
                                           [](Point) {
                                             return Hessian{3, 0, 0};
                                           }),
                               at_vertices(mesh, [](Point) {
                                 return Hessian{0, 0, -3};
                               })};
    const PrincipalMetric m = metric_density(mesh, fields, {})[4];
    CHECK(m.l1 == doctest::Approx(std::pow(3., 2. / 3)));
    CHECK(m.l2 == doctest::Approx(std::pow(3., 2. / 3)));
  }

  TEST_CASE("the intersection of two fields holds both at equal complexity") {
    // Field 1 is curved along x at the left, field 2, a thousand times weaker, along y at the
    // right.
    const Mesh mesh = square_mesh(20);
    const auto left = at_vertices(mesh, [](Point p) { return Hessian{2 - p.x, 0, 1}; });
    const auto right = at_vertices(mesh, [](Point p) {
      return Hessian{1e-3, 0, 1e-3 + 3e-3 * p.x};
    });
    const auto density = [&](const FieldHessians& fields) {
      return metric_density(mesh, fields, {.combination = Combination::intersection});
    };
    const PrincipalField both = density({left, right});
    const MetricField one = scaled_to(mesh, density({left}), 1);
    const MetricField two = scaled_to(mesh, density({right}), 1);
    for (std::size_t v = 0; v < both.size(); ++v) {
      const Metric m = metric_of(both[v]);
      CHECK(m.m11 == doctest::Approx(std::max(one[v].m11, two[v].m11)).epsilon(1e-3));
      CHECK(m.m22 == doctest::Approx(std::max(one[v].m22, two[v].m22)).epsilon(1e-3));
    }
  }

  TEST_CASE("a field of rounding errors does not take part in the intersection") {
    const Mesh mesh = square_mesh(6);
    const auto field = at_vertices(mesh, two_layers);
    const auto noise = at_vertices(mesh, [](Point p) { return Hessian{1e-13 * p.y, 0, 1e-13}; });
    const DensityOptions options{.combination = Combination::intersection};
    const PrincipalField with = metric_density(mesh, {field, noise}, options);
    const PrincipalField without = metric_density(mesh, {field}, options);
    // Up to the factor that the intersection gives to all.
    const double factor = with[0].l1 / without[0].l1;
    for (std::size_t v = 0; v < with.size(); ++v) {
      CHECK(with[v].l1 == doctest::Approx(factor * without[v].l1));
      CHECK(with[v].l2 == doctest::Approx(factor * without[v].l2));
    }
  }

  TEST_CASE("curvatures whose squares underflow still have an eigenvector") {
    const Mesh mesh = square_mesh(1);
    std::vector<Hessian> field(4, Hessian{1e-170, 2e-170, 1e-200});
    field[0] = {1, 0, 1};
    for (const PrincipalMetric& m : metric_density(mesh, {field, field}, {})) {
      CHECK(norm(m.e1) == doctest::Approx(1));
      CHECK(m.l2 > 0);
    }
  }

  TEST_CASE("fields without any curvature ask for a uniform mesh") {
    const Mesh mesh = square_mesh(3);
    const std::vector<Hessian> flat(mesh.points.size());
    for (const Combination c : {Combination::sum_of_squares, Combination::intersection}) {
      const PrincipalField density = metric_density(mesh, {flat, flat}, {.combination = c});
      for (const PrincipalMetric& m : density) {
        CHECK(m.l1 == doctest::Approx(density[0].l1));
        CHECK(m.l2 == doctest::Approx(density[0].l1));
      }
    }
  }

  TEST_CASE("Hessians of several components of nodal values are exact for quadratics") {
    const Mesh mesh = perturbed_mesh(5, 0.3, 2);
    std::vector<double> values;
    for (const Point& p : mesh.points) {
      values.push_back(p.x * p.x - 3 * p.y);
      values.push_back(p.x * p.y + 2 * p.y * p.y);
    }
    const FieldHessians fields = hessians_of(mesh, values, 2);
    REQUIRE(fields.size() == 2);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      CHECK((matrix(fields[0][v]) - matrix(Hessian{2, 0, 0})).norm() < 1e-9);
      CHECK((matrix(fields[1][v]) - matrix(Hessian{0, 1, 4})).norm() < 1e-9);
    }
  }

  TEST_CASE("bad fields and options are refused with the place") {
    const Mesh mesh = square_mesh(2);
    const std::vector<Hessian> good(mesh.points.size(), {1, 0, 1});
    CHECK_THROWS_WITH_AS(metric_density(mesh, {}, {}), doctest::Contains("no field"), InputError);
    CHECK_THROWS_WITH_AS(metric_density(mesh, {good, {{1, 0, 1}}}, {}),
                         doctest::Contains("field 2 has 1 Hessians"), InputError);
    auto bad = good;
    bad[5].xy = std::nan("");
    CHECK_THROWS_WITH_AS(metric_density(mesh, {bad}, {}), doctest::Contains("(1, 0.5)"),
                         InputError);
    CHECK_THROWS_AS(metric_density(mesh, {good}, {.p = 0.5}), InputError);
    CHECK_THROWS_AS(metric_density(mesh, {good}, {.curvature_floor = 0}), InputError);
  }
}

TEST_SUITE("property") {
  TEST_CASE("the sum of squares is the root of the sum of squared matrices") {
    const Mesh mesh = square_mesh(4);
    Noise noise(7);
    for (int count = 1; count <= 5; ++count) {
      FieldHessians fields;
      for (int c = 0; c < count; ++c) fields.push_back(random_field(mesh, noise));
      const PrincipalField density =
          metric_density(mesh, fields, {.p = 1, .curvature_floor = 1e-12});
      for (std::size_t v = 0; v < density.size(); ++v) {
        Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
        for (const auto& field : fields) sum += matrix(field[v]) * matrix(field[v]);
        const Eigen::Matrix2d root =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(sum).operatorSqrt();
        const Eigen::Matrix2d expected = std::pow(root.determinant(), -0.25) * root;
        CHECK((matrix(density[v]) - expected).norm() < 1e-10 * expected.norm());
      }
    }
  }

  TEST_CASE("one field gives the same by both combinations whatever the ratio of its curvatures") {
    const Mesh mesh = square_mesh(3);
    Noise noise(5);
    const auto field = at_vertices(mesh, [&](Point) {
      const double c = std::cos(noise()), s = std::sqrt(1 - c * c), weak = 1e-10;
      return Hessian{c * c - weak * s * s, (1 + weak) * c * s, s * s - weak * c * c};
    });
    DensityOptions options{.p = 1, .curvature_floor = 1e-15};
    const PrincipalField sum = metric_density(mesh, {field}, options);
    options.combination = Combination::intersection;
    const PrincipalField intersection = metric_density(mesh, {field}, options);
    for (std::size_t v = 0; v < sum.size(); ++v) {
      CHECK(sum[v].l1 / sum[v].l2 == doctest::Approx(1e10).epsilon(1e-5));
      CHECK(sum[v].l1 == intersection[v].l1);
      CHECK(sum[v].l2 == intersection[v].l2);
    }
  }

  TEST_CASE("a factor on all Hessians and their order do not change the scaled metric") {
    const Mesh mesh = square_mesh(5);
    Noise noise(9);
    const FieldHessians fields{random_field(mesh, noise), random_field(mesh, noise)};
    FieldHessians changed{fields[1], fields[0]};
    for (auto& field : changed)
      for (Hessian& h : field) h = {1e5 * h.xx, 1e5 * h.xy, 1e5 * h.yy};
    for (const MetricNorm norm : {MetricNorm::lp, MetricNorm::energy}) {
      const auto metric = [&](const FieldHessians& of) {
        return scaled_to(mesh, metric_density(mesh, of, {.norm = norm}), 100);
      };
      const MetricField a = metric(fields), b = metric(changed);
      for (std::size_t v = 0; v < a.size(); ++v) {
        CHECK(a[v].m11 == doctest::Approx(b[v].m11).epsilon(1e-3));
        CHECK(a[v].m12 == doctest::Approx(b[v].m12).epsilon(1e-3));
      }
    }
  }

  TEST_CASE("the metric turns with mesh and fields") {
    const double cosine = std::cos(0.7), sine = std::sin(0.7);
    const Eigen::Matrix2d turn = (Eigen::Matrix2d() << cosine, -sine, sine, cosine).finished();
    const Mesh mesh = square_mesh(4);
    const Mesh turned = mapped(mesh, [&](Point p) {
      return Point{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
    });
    Noise noise(3);
    const FieldHessians fields{random_field(mesh, noise), random_field(mesh, noise)};
    FieldHessians turned_fields = fields;
    for (auto& field : turned_fields)
      for (Hessian& h : field) {
        const Eigen::Matrix2d m = turn * matrix(h) * turn.transpose();
        h = {m(0, 0), m(0, 1), m(1, 1)};
      }
    for (const Combination c : {Combination::sum_of_squares, Combination::intersection}) {
      const PrincipalField a = metric_density(mesh, fields, {.combination = c});
      const PrincipalField b = metric_density(turned, turned_fields, {.combination = c});
      for (std::size_t v = 0; v < a.size(); ++v) {
        const Eigen::Matrix2d expected = turn * matrix(a[v]) * turn.transpose();
        CHECK((matrix(b[v]) - expected).norm() < 1e-7 * expected.norm());
      }
    }
  }

  TEST_CASE("another order of three intersected fields changes sizes by some percent only") {
    const Mesh mesh = square_mesh(6);
    Noise noise(21);
    const FieldHessians f{random_field(mesh, noise), random_field(mesh, noise),
                          random_field(mesh, noise)};
    const DensityOptions options{.combination = Combination::intersection};
    const auto vertices = [&](const FieldHessians& fields) {
      MetricField field;
      for (const PrincipalMetric& m : metric_density(mesh, fields, options))
        field.push_back(metric_of(m));
      return complexity(mesh, field);
    };
    const double first = vertices({f[0], f[1], f[2]}), other = vertices({f[2], f[0], f[1]});
    CHECK(first == vertices({f[0], f[1], f[2]}));
    CHECK(first != other);
    CHECK(first == doctest::Approx(other).epsilon(0.1));
  }
}
