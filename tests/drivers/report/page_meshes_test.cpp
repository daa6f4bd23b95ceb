#include "drivers/report/page_meshes.hpp"

#include <map>
#include <mutex>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/drivers/report/page_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Two variants of three and two cycles in one run.
Json two_variants() {
  const Json history = history_json("t", {plain_variant("a", 3), plain_variant("b", 2)});
  return Json::array({{{"variants", history["variants"]}}});
}

std::vector<std::string> ids(const std::vector<PageMesh>& meshes) {
  std::vector<std::string> names;
  for (const PageMesh& mesh : meshes) names.push_back(mesh.id);
  return names;
}

/// Three bytes for each vertex of the cycle's number: 4 characters of base64 for cycle 0, ...
std::string small_blob(const std::filesystem::path&, int cycle, Interpolation) {
  return std::string(3 * static_cast<std::size_t>(cycle + 1), 'x');
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the meshes of the last cycles come first") {
  Json runs = two_variants();
  const auto meshes = add_meshes(runs, {"results"}, 1000, small_blob);
  CHECK(ids(meshes) == std::vector<std::string>{"mesh-0-0-2", "mesh-0-1-1", "mesh-0-0-0",
                                                "mesh-0-0-1", "mesh-0-1-0"});
  CHECK(meshes[0].text == "eHh4eHh4eHh4");
  CHECK(runs[0]["variants"][0]["meshes"][1] == Json{{"cycle", 1}, {"id", "mesh-0-0-1"}});
}

TEST_CASE("a mesh that does not fit is passed over and says where it lies") {
  Json runs = two_variants();
  // 12 and 8 characters for the last cycles; of the 6 left, 4 go to each cycle 0 but one.
  const auto meshes = add_meshes(runs, {"results"}, 26, small_blob);
  CHECK(ids(meshes) == std::vector<std::string>{"mesh-0-0-2", "mesh-0-1-1", "mesh-0-0-0"});
  const Json& left_out = runs[0]["variants"][0]["meshes"][1];
  CHECK(left_out["id"].is_null());
  CHECK(left_out["note"] == "left out to keep the page small; it lies in a/cycle-1.msh");
  CHECK(runs[0]["variants"][1]["meshes"][0]["id"].is_null());
}

TEST_CASE("a smaller mesh follows one that is too large") {
  Json runs = two_variants();
  const auto meshes = add_meshes(runs, {"results"}, 9, small_blob);
  CHECK(ids(meshes) == std::vector<std::string>{"mesh-0-1-1"});
}

TEST_CASE("a mesh that cannot fit is not even read") {
  Json runs = two_variants();
  const auto never = [](const std::filesystem::path&, int, Interpolation) -> std::string {
    throw InputError("was read");
  };
  CHECK(add_meshes(runs, {"results"}, 1, never).empty());
  CHECK(has(runs[0]["variants"][0]["meshes"][0]["note"], "left out"));
}

TEST_CASE("a mesh that cannot be read says why and the others follow") {
  Json runs = two_variants();
  const auto encode = [](const std::filesystem::path& folder, int, Interpolation) {
    if (folder.filename() == "a") throw UsageError("no such file");
    return std::string("xyz");
  };
  CHECK(add_meshes(runs, {"results"}, 1000, encode).size() == 2);
  CHECK(runs[0]["variants"][0]["meshes"][0] ==
        Json{{"cycle", 0}, {"id", nullptr}, {"note", "no such file"}});
  CHECK_FALSE(runs[0]["variants"][1]["meshes"][1].contains("note"));
}

TEST_CASE("metrics are interpolated as the study says for variant or all or preset") {
  std::map<std::string, Interpolation> asked;
  std::mutex mutex;
  const auto encode = [&](const std::filesystem::path& folder, int, Interpolation interpolation) {
    const std::lock_guard lock(mutex);
    asked[folder.filename().string()] = interpolation;
    return std::string("x");
  };
  VariantHistory paper = plain_variant("paper", 1), own = plain_variant("own", 1);
  paper.settings = {{"mesh.preset", "paper"}};
  own.settings = {{"mesh.preset", "paper"}, {"mesh.interpolation", "log-euclidean"}};
  const Json history = history_json("t", {plain_variant("best", 1), paper, own});
  Json runs = Json::array({{{"interpolation", nullptr}, {"variants", history["variants"]}}});
  add_meshes(runs, {"results"}, 1000, encode);
  CHECK(asked["best"] == Interpolation::linear_size);
  CHECK(asked["paper"] == Interpolation::simultaneous_reduction);
  CHECK(asked["own"] == Interpolation::log_euclidean);
  runs[0]["interpolation"] = "log-euclidean";
  add_meshes(runs, {"results"}, 1000, encode);
  CHECK(asked["best"] == Interpolation::log_euclidean);
  CHECK(asked["paper"] == Interpolation::log_euclidean);
}

TEST_CASE("a variant that failed before its first mesh has none") {
  VariantHistory failed = plain_variant("failed", 0);
  Json runs = Json::array({{{"variants", history_json("t", {failed})["variants"]}}});
  CHECK(add_meshes(runs, {"results"}, 1000, small_blob).empty());
  CHECK(runs[0]["variants"][0]["meshes"] == Json::array());
}
