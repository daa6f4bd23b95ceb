#include <cmath>

#include <doctest/doctest.h>

#include "drivers/loop_input.hpp"
#include "drivers/study_file.hpp"

namespace {

using namespace anisofront;

/// What the mesh of the last cycle must reach, against one of the two metrics of the history.
struct Floor {
  double mean, min, percent_unit, percent_half, length_min, length_max;
};

VariantHistory run_variant(const std::string& study, const std::vector<std::string>& settings) {
  std::vector<Override> overrides;
  for (const std::string& text : settings) overrides.push_back(parse_override(text));
  const StudyFile file = read_study_file(ANISOFRONT_DATA "/studies/" + study, overrides);
  REQUIRE(file.variants.size() == 1);
  return adapt_loop(loop_input(file.variants.front().study));
}

VariantHistory run_example(const std::string& name, const std::string& mode) {
  return run_variant("paper/" + name + ".toml",
                     {"mesh.preset=best", "mesh.elements=triangle", "adapt.mode=" + mode});
}

void check_floor(const MeshStatistics& s, const Floor& floor) {
  CHECK(s.quality_mean >= floor.mean);
  CHECK(s.quality_min >= floor.min);
  CHECK(s.percent_unit >= floor.percent_unit);
  CHECK(s.percent_half >= floor.percent_half);
  CHECK(s.length_min >= floor.length_min);
  CHECK(s.length_max <= floor.length_max);
}

/// Relative change of the largest bins of the edge-length distribution between two cycles.
double distribution_change(const CycleRecord& a, const CycleRecord& b) {
  double change = 0;
  for (int k = 0; k < kLengthBins; ++k)
    change += std::fabs(static_cast<double>(a.background.histogram[k]) / a.background.edges -
                        static_cast<double>(b.background.histogram[k]) / b.background.edges);
  return change;
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("Example 4 isotropic on both domains follows the exact metric") {
    for (const char* name : {"example-4", "example-4-rectangle"}) {
      const VariantHistory history = run_example(name, "isotropic");
      REQUIRE(history.cycles.size() == 6);
      const MeshStatistics& s = history.cycles.back().exact.value();
      check_floor(s, {0.975, 0.75, 99.9, 100, 0.68, 1.45});
      const double ideal = 4 / std::sqrt(3.) * s.complexity;
      CHECK(s.elements > 0.95 * ideal);
      CHECK(s.elements < 1.05 * ideal);
    }
  }

  TEST_CASE("Example 4 anisotropic on both domains follows its background metric") {
    for (const char* name : {"example-4", "example-4-rectangle"}) {
      const VariantHistory history = run_example(name, "anisotropic");
      check_floor(history.cycles.back().background, {0.91, 0.46, 97, 99, 0.5, 1.5});
    }
  }

  TEST_CASE("Example 3 isotropic follows its background metric in cycles 4 and 5") {
    const VariantHistory history = run_example("example-3", "isotropic");
    for (const std::size_t cycle : {4u, 5u})
      check_floor(history.cycles[cycle].background, {0.95, 0.60, 98, 99, 0.5, 2});
  }

  // The toe has 13 degrees in the metric; no triangle in such a corner is better than about 0.38.
  TEST_CASE("Example 3 anisotropic follows its background metric but for the toe") {
    const VariantHistory history = run_example("example-3", "anisotropic");
    for (const std::size_t cycle : {4u, 5u})
      check_floor(history.cycles[cycle].background, {0.90, 0.33, 96, 98.5, 0.2, 2});
  }

  // The paper to the letter makes more elements than its tables; its boundary counts are exact.
  TEST_CASE("preset paper has the boundary counts of Tables 1 and 2") {
    struct Row {
      std::string study, mode;
      Index boundary_edges;
      double least_mean;
    };
    for (const Row& row :
         {Row{"example-1-m1", "anisotropic", 96, 0.92}, Row{"example-1", "anisotropic", 140, 0.92},
          Row{"example-2", "isotropic", 434, 0.94}, Row{"example-2", "anisotropic", 98, 0.92}}) {
      CAPTURE(row.study);
      const VariantHistory history = run_variant("paper/" + row.study + ".toml",
                                                 {"mesh.preset=paper", "mesh.elements=triangle",
                                                  "adapt.mode=" + row.mode, "adapt.cycles=3"});
      const MeshStatistics& s = history.cycles.back().exact.value();
      CHECK(s.boundary_edges == row.boundary_edges);
      CHECK(s.quality_mean >= row.least_mean);
      CHECK(s.percent_half >= 97);
    }
  }

  TEST_CASE("edge-length distributions settle by cycle 3") {
    const VariantHistory history = run_example("example-2", "anisotropic");
    CHECK(distribution_change(history.cycles[0], history.cycles[1]) > 0.5);
    CHECK(distribution_change(history.cycles[3], history.cycles[4]) < 0.15);
    CHECK(distribution_change(history.cycles[4], history.cycles[5]) < 0.15);
  }

  TEST_CASE("a thousand anisotropic vertices find the boundary layers") {
    const VariantHistory history = run_variant(
        "reaction-diffusion-layer.toml", {"adapt.mode=anisotropic", "adapt.target.nodes=1000"});
    const CycleRecord& last = history.cycles.back();
    CHECK(last.background.vertices <= 1100);
    CHECK(last.error.relative_energy.value() <= 6.5e-3);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("isotropic meshes need ten times the vertices for the same error") {
    const CycleRecord isotropic = run_variant("reaction-diffusion-layer.toml",
                                              {"adapt.mode=isotropic", "adapt.target.nodes=12000"})
                                      .cycles.back();
    CHECK(isotropic.background.vertices > 10000);
    CHECK(isotropic.error.relative_energy.value() > 6.5e-3);
  }
}
