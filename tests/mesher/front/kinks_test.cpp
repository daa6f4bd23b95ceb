// Corners inside one curve: no edge may cut them off, however coarse the metric is.
#include <doctest/doctest.h>

#include "mesher/generate.hpp"
#include "tests/support/domains.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

Domain polyline_domain(const std::vector<Point>& corners) {
  Domain domain;
  domain.curves.push_back({"outline", 1, make_polyline(corners)});
  add_region(domain, "domain", 2, {0}, {});
  return domain;
}

/// Four vertices round [-2, 2]^2.
Mesh box() {
  Mesh mesh;
  mesh.points = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_regions = {1, 1};
  return mesh;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += polygon_area({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  return sum;
}

GenerateResult coarse_mesh(const Domain& domain, double size) {
  return generate(domain, box(), MetricField(4, metric_from_size(size)),
                  generate_options(Preset::best));
}

const std::vector<Point> kLShape{{0, -1}, {0, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, -1}, {0, -1}};

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("kinks of a polyline are its corners but for its ends") {
  const auto found = kinks(make_polyline(kLShape), 40);
  REQUIRE(found.size() == 5);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CHECK(found[k].parameter == doctest::Approx(static_cast<double>(k + 1)));
    CHECK(found[k].point == kLShape[k + 1]);
  }
}

TEST_CASE("kinks count from their angle on") {
  const std::vector<Point> bend{{0, 0}, {1, 0}, {2, std::tan(30 * kPi / 180)}};
  CHECK(kinks(make_polyline(bend), 29.9).size() == 1);
  CHECK(kinks(make_polyline(bend), 30.1).empty());
}

TEST_CASE("smooth joints of a circle are no kinks") {
  CHECK(kinks(make_circle({0, 0}, 1), 1).empty());
}

TEST_CASE("meshes keep the corners of a polyline") {
  const Domain domain = polyline_domain(kLShape);
  for (const double size : {0.17, 0.3, 0.45, 0.7, 1.9}) {
    CAPTURE(size);
    CHECK(area(coarse_mesh(domain, size).mesh) == doctest::Approx(3).epsilon(1e-12));
  }
}

TEST_SUITE_END();
