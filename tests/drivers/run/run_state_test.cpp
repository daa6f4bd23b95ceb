#include "drivers/run/run_state.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "drivers/history/history_json.hpp"
#include "drivers/run/cycle_files.hpp"
#include "tests/drivers/result_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

/// Numbers that lose bits in fewer than 17 digits, three kinds of tags, marks, both elements.
Mesh delicate_mesh() {
  Mesh mesh;
  mesh.points = {{-0., 0},
                 {1. / 3, std::nextafter(0., 1)},
                 {1 + 0x1p-52, 1. / 7},
                 {0.1 + 0.2, 1},
                 {2, 1e-300},
                 {2.5, 0.7}};
  mesh.triangles = {{3, 0, 1}, {1, 2, 3}};
  mesh.quads = {{2, 1, 4, 5}};
  mesh.triangle_regions = {7, 3};
  mesh.quad_regions = {3};
  mesh.edges = {{{3, 0}, 4, 11, {0.3, 1. / 9}}, {{0, 1}, 0, kNoIndex, {}}, {{1, 4}, 4, 2, {1, 0}}};
  mesh.vertex_tags = {0, 5, 0, 0, 9, 0};
  mesh.corners = {5, 0};
  mesh.required_vertices = {4, 3};
  mesh.groups = {{1, 4, "wall"}, {2, 3, "plate"}, {0, 9, "probe"}};
  return mesh;
}

std::vector<std::uint64_t> bits(const Mesh& mesh) {
  std::vector<std::uint64_t> all;
  for (const Point p : mesh.points)
    all.insert(all.end(), {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y)});
  for (const CurveEdge& edge : mesh.edges)
    for (const double t : edge.parameters) all.push_back(std::bit_cast<std::uint64_t>(t));
  return all;
}

void check_same(const Mesh& a, const Mesh& b) {
  CHECK(bits(a) == bits(b));
  CHECK(a.triangles == b.triangles);
  CHECK(a.quads == b.quads);
  CHECK(a.triangle_regions == b.triangle_regions);
  CHECK(a.quad_regions == b.quad_regions);
  CHECK(a.vertex_tags == b.vertex_tags);
  CHECK(a.corners == b.corners);
  CHECK(a.required_vertices == b.required_vertices);
  CHECK(a.groups == b.groups);
  REQUIRE(a.edges.size() == b.edges.size());
  for (std::size_t e = 0; e < a.edges.size(); ++e) {
    CHECK(a.edges[e].vertices == b.edges[e].vertices);
    CHECK(a.edges[e].tag == b.edges[e].tag);
    CHECK(a.edges[e].curve == b.edges[e].curve);
  }
}

/// Every field differs from its default and from the others.
CycleRecord full_record(int cycle) {
  CycleRecord record;
  record.cycle = cycle;
  record.dofs = 77;
  MeshStatistics s{1,    2,    3,   4,  5,   6,   0.1, 0.2, 1. / 3, 4. / 3,
                   50.5, 60.6, 1e5, 31, 151, 0.7, 8.5, {},  {}};
  s.histogram[30] = 1'000'000'007;
  s.quality_histogram[19] = 1'000'000'009;
  record.background = s;
  s.quality_mean = 0.3;
  s.stretch_max = 9.5;
  s.histogram[0] = 3;
  s.quality_histogram[0] = 5;
  record.exact = s;
  record.error = {0.01, 1. / 7, 1.1};
  record.goal = GoalRecord{-2.5, 1e-9};
  record.values = {{"w \"centre\"", 0.1}, {"a", -1e-300}};
  record.seconds = {1, 2, 3, 4, 5, 6};
  record.warnings = {"first", "second"};
  return record;
}

/// A folder in which three cycles are complete.
struct Variants {
  TemporaryFolder folder;
  RunRecord record;
  Variants() {
    record.key = "k";
    for (int cycle = 0; cycle < 3; ++cycle) {
      Mesh mesh = delicate_mesh();
      mesh.points[5].x += cycle;
      Analysis analysis;
      analysis.metric.assign(mesh.points.size(), Metric{1, 0, 1});
      write_cycle(path(), {"msh"}, cycle, mesh, analysis);
      record.history.cycles.push_back(full_record(cycle));
      record.digests.push_back(file_digest(path() / cycle_mesh_name(cycle)));
    }
    write_record(path(), record);
  }
  const fs::path& path() const { return folder.path(); }
  EarlierRun read() const { return read_earlier_run(path(), "k"); }
};

void replace_in_file(const fs::path& path, std::size_t at, char c) {
  std::string content = read_text_file(path);
  content.at(at) = c;
  write_text_file(path, content);
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the mesh of a cycle comes back with the very same bits") {
  const Variants left;
  const EarlierRun earlier = left.read();
  CHECK(earlier.state == EarlierRun::State::unfinished);
  CHECK(earlier.damage.empty());
  REQUIRE(earlier.cycles.size() == 3);
  Mesh expected = delicate_mesh();
  expected.points[5].x += 2;
  check_same(earlier.cycles[2].mesh, expected);
}

TEST_CASE("a mesh without tags and marks comes back as it was") {
  const TemporaryFolder folder;
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_regions = {0};
  write_cycle(folder.path(), {"msh"}, 0, mesh, {});
  RunRecord record{"k", false, {}, {file_digest(folder.path() / "cycle-0.msh")}};
  record.history.cycles.resize(1);
  write_record(folder.path(), record);
  const EarlierRun earlier = read_earlier_run(folder.path(), "k");
  REQUIRE(earlier.cycles.size() == 1);
  check_same(earlier.cycles[0].mesh, mesh);
}

TEST_CASE("a record comes back with every number") {
  const Variants left;
  const CycleRecord found = left.read().cycles[1].record;
  const CycleRecord expected = full_record(1);
  CHECK(found.cycle == 1);
  CHECK(found.dofs == 77);
  CHECK(found.background.boundary_edges == 4);
  CHECK(found.background.complexity == 1e5);
  CHECK(found.background.histogram == expected.background.histogram);
  CHECK(found.background.quality_histogram == expected.background.quality_histogram);
  REQUIRE(found.exact.has_value());
  CHECK(found.exact->stretch_max == 9.5);
  CHECK(found.exact->histogram == expected.exact->histogram);
  CHECK(found.exact->quality_histogram == expected.exact->quality_histogram);
  CHECK(found.error.relative_energy == 1. / 7);
  CHECK(found.goal->error == 1e-9);
  CHECK(found.values[1].value == -1e-300);
  CHECK(found.seconds.quads == 4);
  CHECK(found.warnings == expected.warnings);
  const auto text = [](const CycleRecord& record) {
    VariantHistory history;
    history.cycles = {record};
    return variant_json(history, "").dump();
  };
  CHECK(text(found) == text(expected));
}

TEST_CASE("unknown errors and numbers that are not finite come back") {
  VariantHistory history;
  history.cycles.resize(1);
  history.cycles[0].background.length_max = std::numeric_limits<double>::infinity();
  history.target = TargetState::missed;
  const VariantHistory found = variant_history(Json::parse(variant_json(history, "").dump()));
  CHECK(std::isnan(found.cycles[0].background.length_max));
  CHECK_FALSE(found.cycles[0].exact.has_value());
  CHECK_FALSE(found.cycles[0].error.estimate.has_value());
  CHECK_FALSE(found.cycles[0].goal.has_value());
  CHECK(found.target == TargetState::missed);
}

TEST_CASE("an empty folder and other settings are told apart") {
  const TemporaryFolder folder;
  CHECK(read_earlier_run(folder.path(), "k").state == EarlierRun::State::none);
  CHECK(read_earlier_run(folder.path() / "nowhere", "k").state == EarlierRun::State::none);
  const Variants left;
  CHECK(read_earlier_run(left.path(), "other").state == EarlierRun::State::other_settings);
  remove_record(left.path());
  CHECK(left.read().state == EarlierRun::State::none);
}

TEST_CASE("a finished run is finished only while its meshes are intact") {
  Variants left;
  left.record.is_finished = true;
  write_record(left.path(), left.record);
  const EarlierRun finished = left.read();
  CHECK(finished.state == EarlierRun::State::finished);
  CHECK(finished.record.history.cycles.size() == 3);
  fs::remove(left.path() / "cycle-2.msh");
  const EarlierRun damaged = left.read();
  CHECK(damaged.state == EarlierRun::State::unfinished);
  CHECK(damaged.cycles.size() == 2);
  CHECK(damaged.record.digests.size() == 2);
  CHECK_FALSE(damaged.record.is_finished);
  CHECK(has(damaged.damage, "cycle-2.msh is missing"));
}

TEST_CASE("a damaged mesh goes back to the cycle before it") {
  const auto damaged = [](const std::function<void(const fs::path&)>& damage) {
    const Variants left;
    damage(left.path() / "cycle-1.msh");
    const EarlierRun earlier = left.read();
    CHECK(earlier.state == EarlierRun::State::unfinished);
    CHECK(earlier.cycles.size() == 1);
    CHECK(earlier.record.history.cycles.size() == 1);
    CHECK(has(earlier.damage, "cycle-1.msh"));
  };
  damaged([](const fs::path& mesh) { fs::resize_file(mesh, fs::file_size(mesh) / 2); });
  damaged([](const fs::path& mesh) { fs::resize_file(mesh, 0); });
  damaged([](const fs::path& mesh) { replace_in_file(mesh, fs::file_size(mesh) - 60, '#'); });
  damaged([](const fs::path& mesh) { write_text_file(mesh, "garbage"); });
  damaged([](const fs::path& mesh) { fs::remove(mesh); });
}

TEST_CASE("the first mesh damaged means that nothing can be gone on with") {
  const Variants left;
  write_text_file(left.path() / "cycle-0.msh", "");
  const EarlierRun earlier = left.read();
  CHECK(earlier.state == EarlierRun::State::none);
  CHECK(has(earlier.damage, "cycle-0.msh"));
}

TEST_CASE("a damaged record means a new start and no crash") {
  const Variants left;
  const fs::path path = left.path() / "record.json";
  const std::string good = read_text_file(path);
  const auto reads = [&](const std::string& content) {
    write_text_file(path, content);
    const EarlierRun earlier = left.read();
    CHECK(earlier.cycles.empty());
    CHECK(has(earlier.damage, "record.json"));
    return earlier.state;
  };
  for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), std::string("[]"),
                                 std::string("null"), std::string("{}"), std::string("\xff\xfe")})
    CHECK(reads(bad) == EarlierRun::State::none);
  Json json = Json::parse(good);
  json["variant"]["cycles"][1]["quality"] = 3;
  CHECK(reads(json.dump()) == EarlierRun::State::none);
  json = Json::parse(good);
  json["variant"]["cycles"][0]["cycle"] = 4;
  CHECK(reads(json.dump()) == EarlierRun::State::none);
  json = Json::parse(good);
  json["meshes"] = Json::array();
  CHECK(reads(json.dump()) == EarlierRun::State::none);
}

TEST_CASE("the key of a variant follows what decides its results") {
  const TemporaryFolder folder;
  const auto key = [&](const std::string& text, std::vector<Override> overrides = {}) {
    const StudyFile study = read_study_file(folder.write("s.toml", text), overrides);
    return variant_key(study, study.variants.back());
  };
  const std::string plain = kTinyStudy;
  const std::string vary = "[vary]\n\"mesh.preset\" = ";
  const std::string first = key(plain);
  CHECK(first.size() == 16);
  CHECK(key(plain) == first);
  CHECK(key("# comment\n" + plain) == first);
  CHECK(key(std::string(plain).replace(plain.find("tiny"), 4, "none")) == first);  // the title
  CHECK(key(plain, {{"adapt.cycles", "3", "--set"}}) != first);
  CHECK(key(std::string(plain).replace(plain.find("0.1*x"), 5, "0.2*x")) != first);
  // More variants beside it do not matter to a variant, its own value does.
  CHECK(key(plain + vary + "[\"paper\", \"best\"]") == key(plain + vary + "[\"best\"]"));
  CHECK(key(plain + vary + "[\"paper\"]") != key(plain + vary + "[\"best\"]"));
}

TEST_CASE("the key of a variant follows the contents of its mesh files and not their names") {
  const TemporaryFolder folder;
  const std::string mesh =
      "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 1\n1 0 1\n0 1 1\nTriangles\n1\n"
      "1 2 3 5\nEnd\n";
  const auto key = [&](const std::string& name, const std::string& content) {
    folder.write(name, content);
    const StudyFile study = read_study_file(folder.write(
        "s.toml", "title = \"t\"\n[domain]\nmesh = \"" + name + "\"\n[mesh]\ninitial = \"" + name +
                      "\"\n[metric]\nprescribed = [{ h1 = \"1\", h2 = \"h1\" }]\n"));
    return variant_key(study, study.variants.back());
  };
  CHECK(key("a.mesh", mesh) == key("b.mesh", mesh));
  CHECK(key("a.mesh", mesh) != key("a.mesh", "\n" + mesh));
}

TEST_CASE("the key of a variant follows the contents of reference files and not their names") {
  const TemporaryFolder folder;
  const auto key = [&](const std::string& name, const std::string& content) {
    folder.write(name, content);
    const StudyFile study = read_study_file(folder.write(
        "s.toml",
        small_problem("target = { nodes = 50 }",
                      "[output]\nlines = [{ name = \"l\", curve = \"left\", reference = \"" + name +
                          "\" }]\n")));
    return variant_key(study, study.variants.back());
  };
  CHECK(key("a.csv", "s,u\n0,1\n") == key("b.csv", "s,u\n0,1\n"));
  CHECK(key("a.csv", "s,u\n0,1\n") != key("a.csv", "s,u\n0,2\n"));
}

TEST_CASE("digests agree with the vectors of the FNV authors") {
  const TemporaryFolder folder;
  CHECK(file_digest(folder.write("empty", "")) == "cbf29ce484222325");
  CHECK(file_digest(folder.write("a", "a")) == "af63dc4c8601ec8c");
  CHECK(file_digest(folder.write("foobar", "foobar")) == "85944171f73967e8");
}

TEST_SUITE_END();
