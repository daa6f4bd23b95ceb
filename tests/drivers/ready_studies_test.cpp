#include <cmath>

#include <doctest/doctest.h>

#include "drivers/problem/loop_input.hpp"
#include "drivers/study/study_file.hpp"

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

/// One variant of the study of boundary layers.
VariantHistory run_layer(double eps, int order, const std::string& mesh) {
  return run_variant("reaction-diffusion-layer.toml",
                     {"problem.constants.eps=" + std::to_string(eps),
                      "problem.order=" + std::to_string(order), "vary.mesh=" + mesh});
}

double value_of(const CycleRecord& record, const std::string& name) {
  for (const NamedValue& value : record.values)
    if (value.name == name) return value.value;
  return std::nan("");
}

/// Pure convex quadrilaterals, their number within 5 percent of the wanted one.
void check_quads(const MeshStatistics& s) {
  CHECK(s.triangles == 0);
  CHECK(s.quads == s.elements);
  CHECK(s.quality_min > 0);
  CHECK(s.angle_max < 180);
  CHECK(s.quads > 0.95 * s.complexity);
  CHECK(s.quads < 1.05 * s.complexity);
}

VariantHistory run_quads(const std::string& study, const std::vector<std::string>& settings) {
  std::vector<std::string> all(settings);
  all.emplace_back("mesh.elements=quadrilateral");
  return run_variant(study, all);
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

  TEST_CASE("quadrilaterals are perfect along a wall") {
    const VariantHistory history = run_quads("wall-layer.toml", {});
    const MeshStatistics& s = history.cycles.back().exact.value();
    check_quads(s);
    check_floor(s, {0.985, 0.9, 100, 100, 0.9, 1.1});
  }

  TEST_CASE("quadrilaterals follow a curved layer") {
    const VariantHistory history = run_quads("curved-layer.toml", {"adapt.cycles=3"});
    const MeshStatistics& s = history.cycles.back().exact.value();
    check_quads(s);
    check_floor(s, {0.81, 0.25, 98, 99.5, 0.6, 1.7});
  }

  TEST_CASE("quadrilaterals follow the anisotropic layers of Example 2") {
    const VariantHistory history = run_quads(
        "paper/example-2.toml", {"mesh.preset=best", "adapt.mode=anisotropic", "adapt.cycles=3"});
    const MeshStatistics& s = history.cycles.back().exact.value();
    check_quads(s);
    check_floor(s, {0.86, 0.33, 99.3, 99.5, 0.6, 1.6});
  }

  TEST_CASE("edge-length distributions settle by cycle 3") {
    const VariantHistory history = run_example("example-2", "anisotropic");
    CHECK(distribution_change(history.cycles[0], history.cycles[1]) > 0.5);
    CHECK(distribution_change(history.cycles[3], history.cycles[4]) < 0.15);
    CHECK(distribution_change(history.cycles[4], history.cycles[5]) < 0.15);
  }

  TEST_CASE("a thousand anisotropic vertices find the boundary layers") {
    const CycleRecord last = run_layer(0.01, 1, "fine").cycles.back();
    CHECK(last.background.vertices <= 1100);
    CHECK(last.error.relative_energy.value() <= 5.5e-3);
    CHECK(last.error.effectivity.value() > 0.95);
    CHECK(last.error.effectivity.value() < 1.05);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("quadrilaterals follow the intersected layers of Example 1") {
    const MeshStatistics& s =
        run_quads("paper/example-1.toml", {"mesh.preset=best"}).cycles.back().exact.value();
    check_quads(s);
    check_floor(s, {0.88, 0.33, 99.3, 99.9, 0.6, 1.6});
  }

  TEST_CASE("quadrilaterals follow Examples 2 and 4 isotropic") {
    for (const auto& [name, mean] : {std::pair{"example-2", 0.80}, std::pair{"example-4", 0.84}}) {
      CAPTURE(name);
      const VariantHistory history = run_quads("paper/" + std::string(name) + ".toml",
                                               {"mesh.preset=best", "adapt.mode=isotropic"});
      const MeshStatistics& s = history.cycles.back().exact.value();
      check_quads(s);
      check_floor(s, {mean, 0.28, 99, 99.85, 0.55, 1.65});
    }
  }

  // Against the background, whose gradation is limited. The toe of the dam has 13 degrees.
  TEST_CASE("quadrilaterals follow the background metric of Examples 3 and 4") {
    struct Row {
      std::string study, mode;
      Floor floor;
    };
    for (const Row& row : {Row{"example-4", "anisotropic", {0.72, 0.20, 90, 97, 0.4, 1.8}},
                           Row{"example-3", "isotropic", {0.71, 0.23, 97, 99, 0.4, 1.8}},
                           Row{"example-3", "anisotropic", {0.70, 0.08, 93, 97, 0.3, 1.9}}}) {
      CAPTURE(row.study);
      const VariantHistory history =
          run_quads("paper/" + row.study + ".toml", {"mesh.preset=best", "adapt.mode=" + row.mode});
      const MeshStatistics& s = history.cycles.back().background;
      CHECK(s.triangles == 0);
      check_floor(s, row.floor);
    }
  }

  // The table of the issue: FreeFem++ reaches 6.5e-3, 2.0e-3, 4.1e-4 and 7.3e-5 with 1460, 7035,
  // 1092 and 4645 vertices.
  TEST_CASE("anisotropic meshes of boundary layers need fewer vertices than those of FreeFem++") {
    struct Row {
      double eps;
      int order;
      std::string mesh;
      Index vertices;
      double error;
    };
    for (const Row& row :
         {Row{0.01, 1, "fine", 1600, 6.5e-3}, Row{0.001, 1, "finest", 7500, 2.0e-3},
          Row{0.01, 2, "fine", 1100, 4.1e-4}, Row{0.001, 2, "finest", 4700, 7.3e-5}}) {
      CAPTURE(row.eps);
      CAPTURE(row.order);
      const VariantHistory history = run_layer(row.eps, row.order, row.mesh);
      const CycleRecord& last = history.cycles.back();
      CHECK(last.background.vertices <= row.vertices);
      CHECK(last.error.relative_energy.value() <= row.error);
      CHECK(last.background.percent_unit >= 99);
    }
  }

  TEST_CASE("isotropic meshes of boundary layers need twenty times the vertices") {
    for (const double eps : {0.01, 0.001}) {
      CAPTURE(eps);
      const CycleRecord isotropic = run_layer(eps, 1, "isotropic").cycles.back();
      const CycleRecord anisotropic = run_layer(eps, 1, "fine").cycles.back();
      CHECK(isotropic.error.relative_energy.value() > anisotropic.error.relative_energy.value());
      CHECK(isotropic.background.vertices > 20 * anisotropic.background.vertices);
    }
  }

  TEST_CASE("adapted meshes of the L shape keep the order of the elements") {
    for (const auto& [order, least_slope] : {std::pair{1, 0.47}, std::pair{2, 0.80}}) {
      CAPTURE(order);
      CycleRecord ends[2];
      for (int i = 0; i < 2; ++i)
        ends[i] = run_variant("l-shape.toml",
                              {"problem.order=" + std::to_string(order),
                               std::string("adapt.target.nodes=") + (i == 0 ? "400" : "25000")})
                      .cycles.back();
      const double slope =
          std::log(ends[0].error.relative_energy.value() / ends[1].error.relative_energy.value()) /
          std::log(static_cast<double>(ends[1].dofs) / ends[0].dofs);
      CHECK(slope >= least_slope);
      if (order == 1) CHECK(ends[1].error.relative_energy.value() <= 6.4e-3);
    }
  }

  // References: FE.md 3.3; peers 1.43e-3 with 945 and 2.07e-3 with 1024 vertices.
  TEST_CASE("anisotropic meshes of plates resolve the layers of soft supports") {
    struct Row {
      std::string t;
      double error, centre, centre_tolerance, shear, shear_tolerance;
    };
    for (const Row& row : {Row{"0.01", 1.6e-3, 4.09930380787e-3, 1e-4, 10.3693, 0.01},
                           Row{"0.001", 2.5e-3, 4.065849943e-3, 1e-5, 103.265, 0.01}}) {
      CAPTURE(row.t);
      const VariantHistory history = run_variant(
          "plate-boundary-layer.toml", {"problem.constants.t=" + row.t, "vary.mesh=fine"});
      const CycleRecord& last = history.cycles.back();
      CHECK(last.background.vertices <= 1100);
      CHECK(last.error.relative_energy.value() <= row.error);
      CHECK(std::abs(value_of(last, "centre") / row.centre - 1) < row.centre_tolerance);
      CHECK(std::abs(value_of(last, "largest shear") / row.shear - 1) < row.shear_tolerance);
      for (std::size_t cycle = 3; cycle <= 5; ++cycle) {
        CHECK(history.cycles[cycle].error.effectivity.value() > 0.85);
        CHECK(history.cycles[cycle].error.effectivity.value() < 1.2);
      }
    }
  }

  TEST_CASE("the metric of Example 2 drives a plate on triangles and quadrilaterals") {
    for (const char* elements : {"triangle", "quadrilateral"}) {
      CAPTURE(elements);
      CycleRecord ends[2];
      for (int i = 0; i < 2; ++i)
        ends[i] = run_variant("paper-example-2-plate.toml",
                              {std::string("mesh.elements=") + elements,
                               std::string("adapt.mode=") + (i == 0 ? "isotropic" : "anisotropic")})
                      .cycles.back();
      const double ratio = static_cast<double>(ends[1].background.vertices) /
                           static_cast<double>(ends[0].background.vertices);
      CHECK(ratio > 0.15);
      CHECK(ratio < 0.22);
      for (const CycleRecord& end : ends) CHECK(end.error.relative_energy.value() < 0.12);
    }
  }
}
