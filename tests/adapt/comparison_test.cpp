#include "adapt/comparison.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

CycleRecord cycle(int number, Index vertices, std::optional<double> truth,
                  std::optional<double> estimate = {}) {
  CycleRecord record;
  record.cycle = number;
  record.background.vertices = vertices;
  record.dofs = 3 * vertices;
  record.error.relative_energy = truth;
  record.error.estimate = estimate;
  return record;
}

VariantHistory variant(const std::string& mode, std::vector<CycleRecord> cycles,
                       std::vector<std::pair<std::string, std::string>> more = {}) {
  VariantHistory history;
  history.settings = {{"adapt.mode", mode}, {"problem.thickness", "0.1"}};
  history.settings.insert(history.settings.end(), more.begin(), more.end());
  history.cycles = std::move(cycles);
  return history;
}

ModeComparison only(const std::vector<VariantHistory>& variants) {
  const auto comparisons = compare_modes(variants);
  REQUIRE(comparisons.size() == 1);
  return comparisons[0];
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("modes are compared at the smallest error that both have reached") {
  // Isotropic errors 10 / sqrt(N), anisotropic 1 / sqrt(N): at equal error N differs by 100.
  const ModeComparison found =
      only({variant("isotropic", {cycle(0, 9, 5.), cycle(1, 100, 1.), cycle(2, 10000, 0.1)}),
            variant("anisotropic", {cycle(0, 9, 5.), cycle(1, 25, 0.2), cycle(2, 2500, 0.02)})});
  CHECK(found.is_true_error);
  CHECK(found.error == 0.1);
  CHECK(*found.isotropic.vertices == 10000);
  CHECK(*found.isotropic.dofs == 30000);
  CHECK(*found.anisotropic.vertices == doctest::Approx(100));
  CHECK(*found.anisotropic.dofs == doctest::Approx(300));
  CHECK(*size_ratio(found.anisotropic.vertices, found.isotropic.vertices) == doctest::Approx(0.01));
  using Settings = std::vector<std::pair<std::string, std::string>>;
  CHECK(found.settings == Settings{{"problem.thickness", "0.1"}});
}

TEST_CASE("the targets of a mode add up to one curve and beaten meshes do not count") {
  const ModeComparison found = only(
      {variant("isotropic", {cycle(1, 1000, 0.5), cycle(2, 1000, 0.04)},
               {{"adapt.target.nodes", "1"}}),
       variant("isotropic", {cycle(1, 4000, 0.02), cycle(2, 4100, 0.021)},
               {{"adapt.target.nodes", "2"}}),
       variant("anisotropic", {cycle(1, 10, 0.4), cycle(2, 50, 0.03)}, {{"adapt.target", "3"}})});
  CHECK(found.error == 0.03);
  // Of the isotropic meshes only (1000, 0.04) and (4000, 0.02) are left: slope -1/2.
  CHECK(*found.isotropic.vertices == doctest::Approx(1000 * 16. / 9));
  CHECK(*found.anisotropic.vertices == 50);
}

TEST_CASE("other settings make other groups and the cycle of a single mode none") {
  const auto iso = [](const char* t) {
    return variant("isotropic", {cycle(1, 100, 0.1)}, {{"t", t}});
  };
  const auto aniso = [](const char* t) {
    return variant("anisotropic", {cycle(1, 10, 0.1)}, {{"t", t}});
  };
  const std::vector<VariantHistory> variants{iso("1"), iso("2"), aniso("2"), aniso("1"), iso("3")};
  const auto comparisons = compare_modes(variants);
  REQUIRE(comparisons.size() == 2);
  CHECK(comparisons[0].settings.back().second == "1");
  CHECK(comparisons[1].settings.back().second == "2");
  CHECK(*comparisons[0].isotropic.vertices == 100);
  CHECK(*comparisons[0].anisotropic.vertices == 10);
}

TEST_CASE("estimates are compared unless both modes know true errors") {
  const ModeComparison found =
      only({variant("isotropic", {cycle(1, 100, 0.1, 0.2)}),
            variant("anisotropic", {cycle(1, 10, {}, 0.4), cycle(2, 40, {}, 0.1)})});
  CHECK_FALSE(found.is_true_error);
  CHECK(found.error == 0.2);
  CHECK(*found.anisotropic.vertices == doctest::Approx(20));
}

TEST_CASE("nothing is extrapolated to errors that a mode never had") {
  const ModeComparison found =
      only({variant("isotropic", {cycle(1, 100, 0.5)}),
            variant("anisotropic", {cycle(1, 10, 0.3), cycle(2, 40, 0.1)})});
  CHECK(found.error == 0.5);
  CHECK(*found.isotropic.vertices == 100);
  CHECK_FALSE(found.anisotropic.vertices);
  CHECK_FALSE(found.anisotropic.dofs);
  CHECK_FALSE(size_ratio(found.anisotropic.vertices, found.isotropic.vertices));
}

TEST_CASE("initial meshes and errors that are no positive numbers are no points") {
  const double nan = std::nan("");
  const auto aniso = variant("anisotropic", {cycle(1, 10, 0.3)});
  CHECK(compare_modes(std::vector{variant("isotropic", {cycle(0, 9, 0.1)}), aniso}).empty());
  CHECK(compare_modes(std::vector{variant("isotropic", {cycle(1, 9, 0.), cycle(2, 9, nan)}), aniso})
            .empty());
  CHECK(compare_modes(std::vector{variant("isotropic", {cycle(1, 9, {})}), aniso}).empty());
  CHECK(compare_modes({}).empty());
}

TEST_SUITE_END();
