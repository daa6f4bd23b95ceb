#include "drivers/report/cycle_blob.hpp"

#include <doctest/doctest.h>

#include "drivers/base/text.hpp"
#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/io/mesh_io.hpp"
#include "mesher/metric/statistics.hpp"
#include "tests/drivers/blob_reader.hpp"
#include "tests/drivers/gunzip.hpp"
#include "tests/drivers/temporary_folder.hpp"

namespace anisofront {
namespace {

using testing::BlobReader;
using testing::gunzip;
using testing::TemporaryFolder;

/// The unit square as n x n squares, halved.
Mesh square(Index n) {
  Mesh mesh;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      mesh.points.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  return mesh;
}

MetricField graded_field(const Mesh& mesh, double h) {
  MetricField field;
  for (const Point p : mesh.points)
    field.push_back(metric_from_sizes(h * (0.3 + p.x), h * (1 + p.y), {1, p.y}));
  return field;
}

void write_cycle_mesh(const std::filesystem::path& folder, int cycle, const Mesh& mesh,
                      const MetricField& metric) {
  FileField field = metric_file_field(metric);
  field.name = "metric";
  write_gmsh(folder / ("cycle-" + std::to_string(cycle) + ".msh"), {mesh, {field}, {}});
}

double percent_in_band(const BlobReader& read) {
  double count = 0;
  const std::vector<double> lengths = read.values("edge:edge-length");
  for (const double l : lengths) count += l >= std::sqrt(0.5) && l <= std::sqrt(2.);
  return 100 * count / static_cast<double>(lengths.size());
}

TEST_SUITE("unit") {
  TEST_CASE("A cycle is measured by the metric of the cycle before it") {
    const TemporaryFolder folder;
    const Mesh coarse = square(2), fine = square(6);
    const MetricField on_coarse = graded_field(coarse, 0.2), on_fine = graded_field(fine, 7);
    write_cycle_mesh(folder.path(), 0, coarse, on_coarse);
    write_cycle_mesh(folder.path(), 1, fine, on_fine);
    const BlobReader first(gunzip(cycle_blob(folder.path(), 0)));
    CHECK(percent_in_band(first) ==
          doctest::Approx(
              mesh_statistics(coarse, background_metric(coarse, on_coarse)).percent_unit));
    for (const Interpolation way :
         {Interpolation::linear_size, Interpolation::simultaneous_reduction}) {
      const BlobReader second(gunzip(cycle_blob(folder.path(), 1, way)));
      const MeshStatistics expected =
          mesh_statistics(fine, background_metric(coarse, on_coarse, way));
      REQUIRE(expected.percent_unit > 10);
      REQUIRE(expected.percent_unit < 90);
      CHECK(percent_in_band(second) == doctest::Approx(expected.percent_unit));
      CHECK_FALSE(second.header.contains("note"));
    }
  }

  TEST_CASE("A cycle without the one before it is shown without lengths") {
    const TemporaryFolder folder;
    const Mesh mesh = square(3);
    write_cycle_mesh(folder.path(), 2, mesh, graded_field(mesh, 1));
    const BlobReader alone(gunzip(cycle_blob(folder.path(), 2)));
    CHECK(alone.mesh.triangles == mesh.triangles);
    CHECK_FALSE(alone.has("edge:edge-length"));
    CHECK(alone.header["note"].get<std::string>().find("cycle-1.msh") != std::string::npos);
    write_text_file(folder.path() / "cycle-1.msh", "$MeshFormat\nnonsense\n");
    CHECK(BlobReader(gunzip(cycle_blob(folder.path(), 2))).header.contains("note"));
  }

  TEST_CASE("A cycle without mesh is an error") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(cycle_blob(folder.path(), 0), UsageError);
    write_text_file(folder.path() / "cycle-0.msh", "nonsense");
    CHECK_THROWS_AS(cycle_blob(folder.path(), 0), InputError);
  }
}

}  // namespace
}  // namespace anisofront
