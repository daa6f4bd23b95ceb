#include "drivers/report/mesh_blob.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "mesher/mesh/topology.hpp"
#include "mesher/metric/statistics.hpp"
#include "tests/drivers/blob_reader.hpp"

namespace anisofront {
namespace {

using testing::BlobReader;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Quads in the upper half, triangles of another region in the lower one, graded towards y = 0 by
/// powers of `ratio`; far from the origin.
Mesh graded_mesh(Index n = 8, double ratio = 0.4) {
  Mesh mesh;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      mesh.points.push_back(
          {100 + i + 0.1 * std::sin(3. * i + j), j == 0 ? -3 : -3 + n * std::pow(ratio, n - j)});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      if (2 * j < n) mesh.triangles.insert(mesh.triangles.end(), {{c, a, b}, {a, c, d}});
      if (2 * j >= n) mesh.quads.push_back({b, c, d, a});
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 7);
  mesh.quad_regions.assign(mesh.quads.size(), 12);
  mesh.groups = {{2, 7, "layer"}, {2, 12, "above"}, {1, 3, "wall"}};
  for (Index i = 0; i < n; ++i) mesh.edges.push_back({{i, i + 1}, 3});
  return mesh;
}

MetricFunction stretched_metric() {
  return [](Point p) {
    return metric_from_sizes(0.02 + 0.1 * std::fabs(p.y + 3), 1.5, {std::sin(p.x / 9), 1});
  };
}

std::vector<double> wave(const Mesh& mesh, double size) {
  std::vector<double> values;
  for (const Point p : mesh.points) values.push_back(size * std::sin(p.x) * std::cos(p.y));
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i]));
  return most;
}

TEST_SUITE("unit") {
  TEST_CASE("A mesh blob holds elements as they are and points to a part of their edges") {
    const Mesh mesh = graded_mesh();
    const BlobReader read(mesh_blob({mesh, {}, {}}, {}));
    CHECK(read.is_padded);
    CHECK(read.is_complete);
    CHECK(read.mesh.triangles == mesh.triangles);
    CHECK(read.mesh.quads == mesh.quads);
    CHECK(read.header["vertices"] == mesh.points.size());
    CHECK(read.header["edges"] == mesh_edges(mesh).size());
    std::vector<double> shortest(mesh.points.size(), 1e300);
    for (const auto& edge : mesh_edges(mesh))
      for (const Index v : edge)
        shortest[v] = std::min(shortest[v], norm(mesh.points[edge[1]] - mesh.points[edge[0]]));
    REQUIRE(*std::min_element(shortest.begin(), shortest.end()) < 1e-1);
    const Point centre{read.header["centre"][0], read.header["centre"][1]};
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      CHECK(norm(read.mesh.points[v] + centre - mesh.points[v]) < 1e-3 * shortest[v]);
  }

  TEST_CASE("Points of a mesh blob are never finer than 2^-28 of the mesh") {
    const Mesh mesh = graded_mesh(24, 0.3);  // heights down to 1e-11
    const BlobReader read(mesh_blob({mesh, {}, {}}, {}));
    CHECK(read.mesh.quads == mesh.quads);
    const Point centre{read.header["centre"][0], read.header["centre"][1]};
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      CHECK(norm(read.mesh.points[v] + centre - mesh.points[v]) < 24 * 1e-3);
    CHECK(std::fabs(read.mesh.points[0].y + centre.y + 3) <= 24 * std::exp2(-28));
  }

  TEST_CASE("A mesh blob names regions and curves") {
    const Mesh mesh = graded_mesh();
    const BlobReader read(mesh_blob({mesh, {}, {}}, {}));
    CHECK(read.header["regions"] == Json{{"7", "layer"}, {"12", "above"}});
    CHECK(read.header["curves"] == Json{{"3", "wall"}});
    const std::vector<double> region = read.values("element:region");
    CHECK(region.front() == 7);
    CHECK(region.back() == 12);
    CHECK(std::count(region.begin(), region.end(), 7) ==
          static_cast<std::ptrdiff_t>(mesh.triangles.size()));
    CHECK(read.values("curve-edge:curve-edge").at(3) == 2);
    CHECK(read.values("curve-edge:curve-tag") == std::vector<double>(8, 3));
  }

  TEST_CASE("A mesh of one region has no array of regions") {
    Mesh mesh = graded_mesh();
    mesh.quad_regions.assign(mesh.quads.size(), 7);
    CHECK_FALSE(BlobReader(mesh_blob({mesh, {}, {}}, {})).has("element:region"));
  }

  TEST_CASE("Fields of a mesh blob keep twelve bits of their largest value") {
    const Mesh mesh = graded_mesh();
    for (const double size : {1e-12, 1., 3e7}) {
      const std::vector<double> u = wave(mesh, size);
      const BlobReader read(mesh_blob({mesh, {{"u", 1, u}}, {}}, {}));
      CHECK(read.scale("vertex:u") == "linear");
      CHECK(largest_difference(read.values("vertex:u"), u) <= size * std::exp2(-12));
      CHECK(largest_difference(read.values("vertex:u"), u) > 0);
    }
  }

  TEST_CASE("Positive numbers of elements keep their ratios") {
    const Mesh mesh = graded_mesh();
    std::vector<double> indicator;
    for (std::size_t e = 0; e < mesh.triangles.size() + mesh.quads.size(); ++e)
      indicator.push_back(std::pow(10, -12 + 0.1 * static_cast<double>(e)));
    indicator[5] = 0;
    const BlobReader read(mesh_blob({mesh, {}, {{"indicator", 1, indicator}}}, {}));
    CHECK(read.scale("element:indicator") == "log2");
    const std::vector<double> values = read.values("element:indicator");
    CHECK(values[5] == 0);
    for (std::size_t e = 0; e < values.size(); ++e)
      CHECK(std::fabs(values[e] - indicator[e]) <= 7e-4 * indicator[e]);
  }

  TEST_CASE("Positive fields over many decades keep their ratios") {
    const Mesh mesh = graded_mesh();
    std::vector<double> u;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      u.push_back(std::exp(-0.3 * static_cast<double>(v)));
    const BlobReader read(mesh_blob({mesh, {{"u", 1, u}}, {}}, {}));
    CHECK(read.scale("vertex:u") == "log2");
    for (std::size_t v = 0; v < u.size(); ++v)
      CHECK(std::fabs(read.values("vertex:u")[v] - u[v]) <= 7e-4 * u[v]);
  }

  TEST_CASE("What is no number stays so and what is constant stays constant") {
    const Mesh mesh = graded_mesh();
    std::vector<double> holes = wave(mesh, 1), zeros(holes.size(), 0), none(holes.size(), kNaN);
    holes[0] = holes[17] = kNaN;
    holes[40] = std::numeric_limits<double>::infinity();
    const BlobReader read(
        mesh_blob({mesh, {{"holes", 1, holes}, {"zeros", 1, zeros}, {"none", 1, none}}, {}}, {}));
    const std::vector<double> values = read.values("vertex:holes");
    for (std::size_t v = 0; v < values.size(); ++v)
      CHECK(std::isnan(values[v]) == !std::isfinite(holes[v]));
    CHECK(std::fabs(values[1] - holes[1]) < std::exp2(-12));
    CHECK(read.values("vertex:zeros") == zeros);
    for (const double value : read.values("vertex:none")) CHECK(std::isnan(value));
  }

  TEST_CASE("Vectors come as sizes and moments as their three entries") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.triangle_regions = {1};
    const BlobReader read(mesh_blob({mesh,
                                     {{"shear", 3, {3, 4, 0, 0, 0, 0, -5, 12, 0}},
                                      {"moments", 3, {1, 2, 4, 0, 0, 0, 0, 0, 8}},
                                      {"stress", 9, std::vector<double>(27, 0.5)},
                                      {"metric", 9, std::vector<double>(27, 1)}},
                                     {}},
                                    {}));
    CHECK(read.values("vertex:|shear|") == std::vector<double>{5, 0, 13});
    CHECK(read.values("vertex:moments xx") == std::vector<double>{1, 0, 0});
    CHECK(read.values("vertex:moments yy") == std::vector<double>{2, 0, 0});
    CHECK(read.values("vertex:moments xy") == std::vector<double>{4, 0, 8});
    CHECK(read.values("vertex:stress xy") == std::vector<double>(3, 0.5));
    CHECK_FALSE(read.has("vertex:metric"));
  }

  TEST_CASE("Lengths and qualities of a mesh blob are those of the statistics") {
    const Mesh mesh = graded_mesh();
    const BlobReader read(mesh_blob({mesh, {}, {}}, stretched_metric()));
    const MeshStatistics expected = mesh_statistics(mesh, stretched_metric());
    const std::vector<double> lengths = read.values("edge:edge-length");
    REQUIRE(lengths.size() == static_cast<std::size_t>(expected.edges));
    const auto fits = [](double l) { return l >= std::sqrt(0.5) && l <= std::sqrt(2.); };
    const auto in_band = std::count_if(lengths.begin(), lengths.end(), fits);
    CHECK(in_band > 3);
    CHECK(100. * static_cast<double>(in_band) / expected.edges ==
          doctest::Approx(expected.percent_unit).epsilon(1e-12));
    CHECK(*std::max_element(lengths.begin(), lengths.end()) ==
          doctest::Approx(expected.length_max).epsilon(0.006));
    const std::vector<double> quality = read.values("element:quality");
    CHECK(*std::min_element(quality.begin(), quality.end()) ==
          doctest::Approx(expected.quality_min).epsilon(1e-3).scale(1));
  }

  TEST_CASE("Edges on the bounds of the unit band belong to it in a mesh blob") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.triangle_regions = {1, 1};
    for (const double h : {1., std::sqrt(2.)}) {  // edges 1 and sqrt 2, then 1 / sqrt 2 and 1
      const MetricFunction metric = [h](Point) { return metric_from_size(h); };
      const BlobReader read(mesh_blob({mesh, {}, {}}, metric));
      CHECK(mesh_statistics(mesh, metric).percent_unit == 100);
      for (const double length : read.values("edge:edge-length"))
        CHECK((length > std::sqrt(0.5) && length < std::sqrt(2.)));
    }
  }

  TEST_CASE("The metric of a mesh blob has the sizes and directions of the function") {
    const Mesh mesh = graded_mesh();
    const BlobReader read(mesh_blob({mesh, {}, {}}, stretched_metric()));
    const std::vector<double> xx = read.values("vertex:metric", 0),
                              xy = read.values("vertex:metric", 1),
                              yy = read.values("vertex:metric", 2);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const PrincipalAxes axes = principal_axes(stretched_metric()(mesh.points[v]));
      const double middle = 0.5 * (xx[v] + yy[v]);
      const double radius = std::hypot(0.5 * (xx[v] - yy[v]), xy[v]);
      CHECK(std::exp2(middle - radius) == doctest::Approx(axes.h1).epsilon(0.005));
      CHECK(std::exp2(middle + radius) == doctest::Approx(axes.h2).epsilon(0.005));
      const double turn = 0.5 * std::atan2(xy[v], 0.5 * (xx[v] - yy[v]));
      CHECK(std::fabs(cross(axes.e2, {std::cos(turn), std::sin(turn)})) < 0.01);
    }
  }

  TEST_CASE("Equal meshes make equal blobs") {
    const Mesh mesh = graded_mesh();
    const MeshFile file{mesh, {{"u", 1, wave(mesh, 1)}}, {}};
    CHECK(mesh_blob(file, stretched_metric()) == mesh_blob(file, stretched_metric()));
  }

  TEST_CASE("A mesh blob of nothing can be read") {
    CHECK(BlobReader(mesh_blob({}, stretched_metric())).mesh.points.empty());
    Mesh points_only;
    points_only.points = {{1, 2}, {1, 2}};
    const BlobReader read(mesh_blob({points_only, {}, {}}, stretched_metric()));
    CHECK(read.mesh.points.size() == 2);
    CHECK_FALSE(read.has("edge:edge-length"));
  }

  TEST_CASE("Names in a mesh blob may hold anything") {
    Mesh mesh = graded_mesh();
    mesh.groups[2].name = "</script><b>\"\xff";
    const BlobReader read(mesh_blob({mesh, {}, {}}, {}, "a note"));
    CHECK(read.header["curves"]["3"].get<std::string>().starts_with("</script><b>\""));
    CHECK(read.header["note"] == "a note");
  }
}

}  // namespace
}  // namespace anisofront
