#include "mesher/quads/paper_quads.hpp"

#include <doctest/doctest.h>

#include "mesher/generate.hpp"
#include "mesher/metric/statistics.hpp"
#include "mesher/quads/mixed_quality.hpp"
#include "tests/support/generated.hpp"
#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// A row of the paper's Tables 1 and 2.
struct Row {
  const char* name;
  MetricFunction metric;
  double beta;          ///< mean
  double percent_half;  ///< edges in [0.5, 1.5]
  double quads;
  Index boundary_edges;
};

std::vector<Row> rows() {
  return {{"12e", example_1, 0.714, 97.65, 1582, 136},
          {"13c", example_2_isotropic, 0.720, 98.86, 2584, 432},
          {"13e", example_2_anisotropic, 0.673, 97.32, 422, 96}};
}

GenerateOptions options(QuadStart start = QuadStart::automatic) {
  GenerateOptions options = generate_options(Preset::paper);
  options.elements = Elements::quadrilateral;
  options.quads.start = start;
  return options;
}

/// The mesh after each cycle, the metric sampled on the mesh before.
std::vector<Mesh> cycles(const MetricFunction& metric, int count, const GenerateOptions& options,
                         const Monitor& monitor = {}) {
  const Domain domain = square_domain(10);
  std::vector<Mesh> meshes{crossed_square(2, 10)};
  for (int cycle = 0; cycle < count; ++cycle) {
    const GenerateResult made =
        generate(domain, meshes.back(), sample(meshes.back(), metric), options, monitor);
    CHECK(joined(defects_of(domain, made, 100, 0)) == "");
    CHECK(made.mesh.triangles.empty());
    CHECK(made.quads.levels == 1);
    meshes.push_back(made.mesh);
  }
  return meshes;
}

/// What warn_about_bad_quads() says.
std::string warning_about(const MixedMesh& mesh) {
  std::string said;
  Monitor monitor;
  monitor.warn = [&](const std::string& message) { said += message; };
  warn_about_bad_quads(mesh, monitor);
  return said;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("Example 2 becomes the published quadrilaterals") {
    const Row row = rows()[2];
    for (const QuadStart start : {QuadStart::automatic, QuadStart::systematic}) {
      const std::vector<Mesh> meshes = cycles(row.metric, 3, options(start));
      const MeshStatistics s = mesh_statistics(meshes.back(), row.metric);
      CHECK(s.quality_mean > row.beta - 0.03);
      CHECK(s.percent_half > row.percent_half - 5);
      CHECK(s.boundary_edges == row.boundary_edges);
    }
  }

  TEST_CASE("systematic merging leaves fewer triangles than the order of beta") {
    const Domain domain = square_domain(10);
    const Mesh old = crossed_square(2, 10);
    BackgroundMesh background(old, sample(old, example_1), Interpolation::simultaneous_reduction);
    const auto leftovers = [&](QuadStart start) {
      const GenerateOptions o = options(start);
      const QuadrangulateInput input{domain,  old,       background, o.boundary,
                                     o.front, o.enhance, o.quads,    o.max_elements};
      const LevelMesh made = paper_quads(input, {});
      CHECK(background.size_factor() == 1);
      CHECK(made.statistics.triangles > made.statistics.leftovers);
      for (const MixedFace& face : made.mesh.faces) {
        CHECK(face.is_quad());
        CHECK(is_strictly_convex(made.mesh, face));
      }
      return made.statistics.leftovers;
    };
    CHECK(2 * leftovers(QuadStart::systematic) < leftovers(QuadStart::automatic));
  }

  TEST_CASE("badly shaped quadrilaterals are counted and the worst is named") {
    const auto metric = background([](Point) { return metric_from_size(1); }, {0, 0}, {3, 2});
    MixedMesh mesh = mixed_mesh(
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {3, 0}, {2.005, 0.5025}, {1.01, 1}}, {quad(0, 1, 2, 3)});
    look_up_metrics(*metric, mesh);
    CHECK(warning_about(mesh) == "");
    mesh.faces.push_back(quad(1, 4, 5, 6));  // nearly flat at (2.005, 0.5025)
    REQUIRE(is_strictly_convex(mesh, mesh.faces[1]));
    const std::string said = warning_about(mesh);
    CHECK(said.find("(beta below 0.05): 1,") != std::string::npos);
    CHECK(said.find("near (1.000000, 0.000000)") != std::string::npos);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("Examples 1 and 2 come within 0.03 of the published beta in every later cycle") {
    for (const Row& row : rows()) {
      CAPTURE(row.name);
      std::string said;
      Monitor monitor;
      monitor.warn = [&](const std::string& message) { said += message; };
      const std::vector<Mesh> meshes = cycles(row.metric, 5, options(), monitor);
      CHECK(said == "");
      for (int cycle = 2; cycle <= 5; ++cycle) {
        CAPTURE(cycle);
        const MeshStatistics s = mesh_statistics(meshes[cycle], row.metric);
        CHECK(s.boundary_edges == row.boundary_edges);
        if (cycle < 3) continue;
        CHECK(s.quality_mean > row.beta - 0.03);
        CHECK(s.quality_min > 0.05);
        CHECK(s.percent_half > row.percent_half - 5);
        CHECK(s.quads == doctest::Approx(row.quads).epsilon(0.13));
      }
    }
  }
}
