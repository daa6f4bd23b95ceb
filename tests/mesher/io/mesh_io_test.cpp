#include "mesher/io/mesh_io.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "io_support.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

MeshFile with_field(FileField field) {
  MeshFile file = small_file();
  file.vertex_fields.push_back(std::move(field));
  return file;
}

FileField repeated(const std::string& name, int components, const std::vector<double>& entry) {
  FileField field{name, components, {}, 0, 0};
  for (int v = 0; v < 6; ++v) field.values.insert(field.values.end(), entry.begin(), entry.end());
  return field;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the suffix chooses the format") {
    const Scratch scratch;
    for (const char* name : {"m.msh", "m.mesh"}) {
      write_mesh_file(scratch / name, small_file());
      CHECK(read_mesh_file(scratch / name).mesh.triangles == small_file().mesh.triangles);
    }
    write_mesh_file(scratch / "m.vtu", small_file());
    CHECK(contents(scratch / "m.vtu").starts_with("<?xml"));
    write_mesh_file(scratch / "m.svg", small_file());
    CHECK(contents(scratch / "m.svg").starts_with("<svg"));
    CHECK(contains(message_of([&] { write_mesh_file(scratch / "m.stl", small_file()); }),
                   "the suffix '.stl' names no known format, expected .msh (Gmsh)"));
    CHECK(contains(message_of([&] { read_mesh_file(scratch / "m.vtu"); }),
                   "expected .msh (Gmsh) or .mesh (Medit)"));
    CHECK_THROWS_AS(read_mesh_file(scratch / "none.mesh"), UsageError);
  }

  TEST_CASE("the metric goes beside a Medit mesh") {
    const Scratch scratch;
    const MetricField field{{1, 0, 1}, {2, 0.5, 2}, {3, -1, 4}, {4, 0, 1}, {1, 0, 5}, {7, 1, 8}};
    write_mesh_file(scratch / "m.mesh", with_field(metric_file_field(field)));
    CHECK(read_metric_file(scratch / "m.sol", 6) == field);
    write_mesh_file(scratch / "n.mesh", with_field(repeated("metric", 3, {2, 1, 3})));
    CHECK(read_metric_file(scratch / "n.sol", 6) == MetricField(6, Metric{2, 1, 3}));
    write_mesh_file(scratch / "p.mesh", small_file());
    CHECK(!std::filesystem::exists(scratch / "p.sol"));
  }

  TEST_CASE("a metric is a symmetric tensor of nine row-major components") {
    const FileField field = metric_file_field({{2, 1, 3}});
    CHECK(field.name == "metric");
    CHECK(field.components == 9);
    CHECK(field.values == std::vector<double>{2, 1, 0, 1, 3, 0, 0, 0, 0});
  }

  TEST_CASE("a metric is read from Gmsh node data") {
    const Scratch scratch;
    MeshFile file = with_field(repeated("temperature", 1, {0.5}));
    write_gmsh(scratch / "size.msh", file);
    CHECK(read_metric_file(scratch / "size.msh", 6) == MetricField(6, Metric{4, 0, 4}));
    file.vertex_fields.push_back(metric_file_field(MetricField(6, Metric{2, 1, 3})));
    write_gmsh(scratch / "tensor.msh", file);
    CHECK(read_metric_file(scratch / "tensor.msh", 6) == MetricField(6, Metric{2, 1, 3}));
  }

  TEST_CASE("bad metrics in Gmsh files are refused with the vertex and its place") {
    const Scratch scratch;
    const auto error = [&](const MeshFile& file, Index count = 6) {
      write_gmsh(scratch / "m.msh", file);
      return message_of([&] { read_metric_file(scratch / "m.msh", count); });
    };
    MeshFile file = with_field(metric_file_field(MetricField(6, Metric{2, 1, 3})));
    CHECK(contains(error(file, 7), "metrics of 6 vertices, but the mesh has 7"));
    file.vertex_fields[0].values[9 * 4] = -1;
    CHECK(contains(error(file), "the metric of vertex 5 at (2.000000, 0.000000) is not positive"));
    file.vertex_fields[0].values[9 * 2 + 4] = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(error(file), "the metric of vertex 3 at (1.000000, 1.000000) is not finite"));
    file.vertex_fields[0].values[1] = 0.5;
    CHECK(contains(error(file), "the metric of vertex 1 at (0.000000, 0.000000) is not symmetric"));
    CHECK(contains(error(with_field(repeated("v", 3, {1, 0, 1}))), "field 'v' is a vector"));
    CHECK(contains(error(small_file()), "no node data, expected a field 'metric'"));
    CHECK(contains(message_of([] { read_metric_file("m.txt", 1); }), ".sol (Medit) or .msh"));
  }
}
