#include "drivers/commands/program.hpp"

#include <csignal>
#include <sstream>

#include <doctest/doctest.h>

#include "drivers/base/text.hpp"
#include "drivers/report/html.hpp"
#include "drivers/run/cycle_files.hpp"
#include "drivers/run/run_study.hpp"
#include "mesher/io/mesh_io.hpp"
#include "tests/drivers/program_call.hpp"
#include "tests/drivers/result_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const std::string kSquareMesh =
    "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "Edges\n4\n1 2 7\n2 3 8\n3 4 7\n4 1 8\nTriangles\n2\n1 2 3 5\n1 3 4 5\nEnd\n";

/// Two quadrilaterals on [0, 2] x [0, 1]; the vertex given second is (1, y).
std::string quad_mesh(const std::string& y) {
  return "MeshVersionFormatted 2\nDimension 2\nVertices\n6\n0 0 1\n1 " + y +
         " 1\n2 0 1\n2 1 1\n1 1 1\n0 1 1\nQuadrilaterals\n2\n1 2 5 6 5\n2 3 4 5 5\nEnd\n";
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("help and version are successes") {
  CHECK(call({"--version"}).code == 0);
  CHECK(has(call({"--version"}).out, "anisofront"));
  CHECK(call({"--help"}).code == 0);
  CHECK(call({"run", "--help"}).code == 0);
}

TEST_CASE("mistakes on the command line are code 3 and propose the nearest name") {
  CHECK(call({}).code == 3);
  const Result option = call({"check", "a.msh", "--metrc", "b.sol"});
  CHECK(option.code == 3);
  CHECK(has(option.err, "did you mean \"--metric\"?"));
  CHECK(has(call({"chekc", "a.msh"}).err, "did you mean \"check\"?"));
  CHECK(has(call({"metric", "explian"}).err, "did you mean \"explain\"?"));
  CHECK(has(call({"metric", "explain", "s.toml", "--att", "1,2"}).err, "did you mean \"--at\"?"));
  CHECK(has(call({"metric", "explain"}).err, "anisofront metric explain --help"));
  CHECK(has(call({"run", "s.toml", "-o"}).err, "--output needs a value"));
  CHECK(call({"run", "missing.toml"}).code == 3);
  CHECK(call({"check", "missing.msh"}).code == 3);
  CHECK(call({"convert", "a.msh", "b.xyz"}).code == 3);
  CHECK(call({"report", "/nowhere"}).code == 3);
}

TEST_CASE("bad files are code 4 and leave nothing behind") {
  const TemporaryFolder folder;
  const auto mesh =
      folder.write("bad.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0");
  const auto out = folder.path() / "out.mesh";
  CHECK(call({"mesh", mesh.string(), "--size", "1", "-o", out.string()}).code == 4);
  CHECK_FALSE(std::filesystem::exists(out));
  const auto study = folder.write("s.toml", kTinyStudy);
  const auto results = folder.path() / "r";
  const Result bad = call({"run", study.string(), "-o", results.string(), "--set",
                           "metric.prescribed=[{ h1 = \"x-0.3\", h2 = \"1\" }]"});
  CHECK(bad.code == 4);
  CHECK(has(bad.err, "it must be positive and finite"));
  CHECK_FALSE(std::filesystem::exists(results));
}

TEST_CASE("a study with an unknown key is code 3") {
  const TemporaryFolder folder;
  const auto study = folder.write("s.toml", std::string(kTinyStudy) + "cicles = 3\n");
  const Result result = call({"run", study.string()});
  CHECK(result.code == 3);
  CHECK(has(result.err, "s.toml:11:1: unknown key \"adapt.cicles\"; did you mean \"cycles\"?"));
}

TEST_CASE("a metric beyond the budget is code 5") {
  const TemporaryFolder folder;
  const auto mesh = folder.write("square.mesh", kSquareMesh);
  CHECK(call({"mesh", mesh.string(), "--size", "0.01", "--max-nodes", "100", "-o",
              (folder.path() / "o.mesh").string()})
            .code == 5);
}

TEST_CASE("mesh keeps references and finds the metric beside the mesh") {
  const TemporaryFolder folder;
  const auto mesh = folder.write("square.mesh", kSquareMesh);
  const auto out = (folder.path() / "out.mesh").string();
  CHECK(call({"mesh", mesh.string(), "-o", out}).code == 3);  // no size, no metric
  folder.write("square.sol",
               "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n4\n1 1\n.2\n.2\n.2\n.2\nEnd\n");
  const Result made = call({"mesh", mesh.string(), "-o", out, "--write-metric"});
  CHECK(made.code == 0);
  CHECK(has(made.out, "metric from"));
  const Json found = Json::parse(
      call({"check", out, "--metric", (folder.path() / "out.sol").string(), "--json"}).out);
  CHECK(found["valid"] == true);
  CHECK(found["area"].get<double>() == doctest::Approx(1));
  CHECK(found["boundary_edges"] == 20);  // sides of length 1, edges of length 0.2
  CHECK(found["edge_length"]["in_0.5_1.5"].get<double>() == doctest::Approx(100));
  CHECK(has(read_text_file(out), "\nEdges\n20\n"));
}

TEST_CASE("mesh makes quadrilaterals from triangles and again from quadrilaterals") {
  const TemporaryFolder folder;
  const auto mesh = folder.write("square.mesh", kSquareMesh);
  const auto first = (folder.path() / "first.mesh").string();
  const auto second = (folder.path() / "second.msh").string();
  const Result made =
      call({"mesh", mesh.string(), "--size", "0.2", "--quad", "-o", first, "--write-metric"});
  CHECK(made.code == 0);
  CHECK(has(made.out, " quadrilaterals"));
  CHECK_FALSE(has(made.out, " triangles"));
  CHECK(has(read_text_file(first), "\nQuadrilaterals\n"));
  // The metric of first.sol lies on a mesh of quadrilaterals.
  const auto metric = (folder.path() / "first.sol").string();
  CHECK(call({"mesh", first, "--metric", metric, "--elements", "quadrilateral", "-o", second,
              "--write-metric"})
            .code == 0);
  const Json found = Json::parse(call({"check", second, "--metric", second, "--json"}).out);
  CHECK(found["valid"] == true);
  CHECK(found["triangles"] == 0);
  CHECK(found["quads"].get<int>() > 15);
  CHECK(found["quads"].get<int>() < 40);
  CHECK(found["area"].get<double>() == doctest::Approx(1));
  CHECK(found["angle"]["max"].get<double>() < 180);
  CHECK(found["scaled_jacobian_min"].get<double>() > 0);
  CHECK(found["quality"]["min"].get<double>() > 0);
}

TEST_CASE("a mesh of quadrilaterals can be the background of triangles") {
  const TemporaryFolder folder;
  const auto mesh = folder.write("quads.mesh", quad_mesh("0"));
  folder.write(
      "quads.sol",
      "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n6\n1 1\n.2\n.2\n.2\n.2\n.2\n.2\n"
      "End\n");
  const auto out = (folder.path() / "out.mesh").string();
  CHECK(call({"mesh", mesh.string(), "-o", out}).code == 0);
  const Json found = Json::parse(call({"check", out, "--json"}).out);
  CHECK(found["quads"] == 0);
  CHECK(found["boundary_edges"] == 30);  // 2 (1 + 2) / 0.2
}

TEST_CASE("elements that contradict each other or are misspelt are code 3") {
  const TemporaryFolder folder;
  const auto mesh = folder.write("square.mesh", kSquareMesh).string();
  const auto out = (folder.path() / "o.mesh").string();
  const auto complaint = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"mesh", mesh, "--size", "0.2", "-o", out});
    const Result result = call(words);
    CHECK(result.code == 3);
    CHECK_FALSE(std::filesystem::exists(out));
    return result.err;
  };
  CHECK(has(complaint({"--quad", "--elements", "triangle"}), "--elements for triangle"));
  CHECK(has(complaint({"--quad", "--elements", "mixed"}), "--elements for mixed"));
  CHECK(has(complaint({"--elements", "quadrilatral"}), "did you mean \"quadrilateral\"?"));
  CHECK(has(complaint({"--quad", "--quad-effort", "fastest"}), "expected one of: best, fast"));
  CHECK(has(complaint({"--quad", "--quad-start", "right-angel"}), "did you mean \"right-angle\"?"));
  CHECK(has(complaint({"--quad-effort", "fast"}), "add --quad"));
  CHECK(has(complaint({"--qaud"}), "did you mean \"--quad\"?"));
}

TEST_CASE("check measures quadrilaterals") {
  const TemporaryFolder folder;
  const auto mesh = folder.write("quads.mesh", quad_mesh("0.5")).string();
  const Json found = Json::parse(call({"check", mesh, "--json"}).out);
  CHECK(found["valid"] == true);
  CHECK(found["quads"] == 2);
  CHECK(found["scaled_jacobian_min"].get<double>() == doctest::Approx(0.8944272));  // sin 116.6
  CHECK(found["angle"]["min"].get<double>() == doctest::Approx(63.43495));
  CHECK(found["angle"]["max"].get<double>() == doctest::Approx(116.56505));
  const Result text = call({"check", mesh});
  CHECK(has(text.out, "0 triangles, 2 quadrilaterals"));
  CHECK(has(text.out, "beta~"));
  CHECK(has(text.out, "least scaled Jacobian of the quadrilaterals: 0.89"));
}

TEST_CASE("a concave quadrilateral is code 4 and named") {
  const TemporaryFolder folder;
  // Quadrilateral 2 is an arrowhead with its notch at (3, 1); all else is in order.
  const auto concave =
      folder
          .write(
              "concave.mesh",
              "MeshVersionFormatted 2\nDimension 2\nVertices\n6\n0 0 1\n2 0 1\n2 2 1\n0 2 1\n"
              "4 1 1\n3 1 1\nTriangles\n1\n6 3 4 5\nQuadrilaterals\n2\n1 2 6 4 5\n2 5 3 6 5\nEnd\n")
          .string();
  const Result checked = call({"check", concave});
  CHECK(checked.code == 4);
  CHECK(has(checked.out, "quad 2 is flat, concave or clockwise at its corner vertex 6 at (3, 1)"));
  CHECK_FALSE(has(checked.out, "quad 1 is"));
  const Result meshed =
      call({"mesh", concave, "--size", "0.5", "-o", (folder.path() / "o.mesh").string()});
  CHECK(meshed.code == 4);
  CHECK(has(meshed.err, "quad 2 is"));
}

TEST_CASE("check is code 4 for a mesh that is not valid") {
  const TemporaryFolder folder;
  // Two triangles that overlap: vertex 4 lies on the same side of the shared edge as vertex 3.
  const auto mesh = folder.write("overlap.mesh",
                                 "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 1\n1 0 1\n"
                                 "0 1 1\n1 1 1\nTriangles\n2\n1 2 3 1\n1 2 4 1\nEnd\n");
  const Result result = call({"check", mesh.string(), "--json"});
  CHECK(result.code == 4);
  CHECK(Json::parse(result.out)["valid"] == false);
}

TEST_CASE("convert carries meshes through all formats") {
  const TemporaryFolder folder;
  const auto first = folder.write("a.mesh", kSquareMesh);
  const auto msh = (folder.path() / "b.msh").string(), back = (folder.path() / "c.mesh").string();
  CHECK(call({"convert", first.string(), msh, "--format", "2.2", "--binary"}).code == 0);
  CHECK(call({"convert", msh, back}).code == 0);
  const Json found = Json::parse(call({"check", back, "--json"}).out);
  CHECK(found["triangles"] == 2);
  CHECK(found["boundary_edges"] == 4);
  CHECK(call({"convert", msh, (folder.path() / "d.vtu").string()}).code == 0);
}

TEST_CASE("a run leaves meshes history figures and a page") {
  const TemporaryFolder folder;
  const auto study = folder.write("tiny.toml", kTinyStudy);
  const auto dir = folder.path() / "r";
  const Result result = call({"run", study.string(), "-o", dir.string(), "--set",
                              "output.formats=[\"msh\", \"vtu\", \"svg\", \"mesh\"]"});
  CHECK(result.code == 0);
  CHECK(has(result.out, "results in"));
  for (const char* file :
       {"study.toml", "history.json", "history.csv", "report.html", "main/cycle-0.msh",
        "main/cycle-2.msh", "main/cycle-2.vtu", "main/cycle-2.svg", "main/cycle-2.mesh",
        "main/cycle-2.sol", "main/cycles.pvd", "figures/main-mesh.svg",
        "figures/main-edge-lengths.dat", "figures/main-edge-lengths.gp"})
    CHECK_MESSAGE(std::filesystem::exists(dir / file), file);
  const Json history = read_json(dir / "history.json");
  CHECK(history["variants"][0]["cycles"].size() == 3);
  // The resolved study runs again, from where it lies, to the same result.
  const auto again = folder.path() / "again";
  CHECK(call({"run", (dir / "study.toml").string(), "-o", again.string()}).code == 0);
  CHECK(timeless(read_json(again / "history.json")) == timeless(history));
  CHECK(call({"report", dir.string()}).code == 0);
}

TEST_CASE("a run on quadrilaterals leaves their quality in history and vtu") {
  const TemporaryFolder folder;
  const auto study = folder.write(
      "tiny.toml",
      std::string(kTinyStudy) + "[vary]\n\"mesh.elements\" = [\"triangle\", \"quadrilateral\"]\n");
  const auto dir = folder.path() / "r";
  const Result result = call(
      {"run", study.string(), "-o", dir.string(), "--set", "output.formats=[\"vtu\", \"svg\"]"});
  CHECK(result.code == 0);
  const Json history = read_json(dir / "history.json");
  CHECK(history["variants"][0]["cycles"][2]["quads"] == 0);
  CHECK(history["variants"][0]["settings"]["mesh.elements"] == "triangle");
  const Json& variant = history["variants"][1];
  CHECK(variant["settings"]["mesh.elements"] == "quadrilateral");
  CHECK(variant["settings"]["mesh.quad_method"] == "best");
  for (const int cycle : {1, 2}) {
    const Json& record = variant["cycles"][static_cast<std::size_t>(cycle)];
    CHECK(record["triangles"] == 0);
    CHECK(record["quads"] == record["elements"]);
    CHECK(record["quads"].get<int>() > 8);  // 16 unit squares
    CHECK(record["quality"]["min"].get<double>() > 0);
    CHECK(record["scaled_jacobian_min"].get<double>() > 0);
    CHECK(record["angle"]["max"].get<double>() < 180);
  }
  const std::string vtu = read_text_file(dir / "quadrilateral/cycle-2.vtu");
  CHECK(has(vtu, "Name=\"quality\""));
  CHECK(has(vtu, "Name=\"scaled_jacobian\""));
  CHECK(std::filesystem::exists(dir / "figures/quadrilateral-mesh.svg"));
}

TEST_CASE("mesh picks the variant of a study that has the elements asked for") {
  const TemporaryFolder folder;
  const auto study = folder.write(
      "tiny.toml",
      std::string(kTinyStudy) + "[vary]\n\"mesh.elements\" = [\"triangle\", \"quadrilateral\"]\n");
  const auto out = (folder.path() / "o.msh").string();
  CHECK(has(call({"mesh", study.string(), "-o", out}).out, "this is triangle"));
  const Result quads = call({"mesh", study.string(), "--quad", "-o", out});
  CHECK(has(quads.out, "this is quadrilateral"));
  CHECK(has(quads.out, " quadrilaterals"));
}

TEST_CASE("variants side by side give the same results") {
  const TemporaryFolder folder;
  const auto study = folder.write("t.toml", std::string(kTinyStudy) +
                                                "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n"
                                                "\"adapt.limits.hmax\" = [0.25, 1]\n");
  const auto one = folder.path() / "one", two = folder.path() / "two";
  CHECK(call({"run", study.string(), "-q", "-o", one.string()}).code == 0);
  CHECK(call({"run", study.string(), "-q", "-j", "2", "-o", two.string()}).code == 0);
  CHECK(timeless(read_json(one / "history.json")) == timeless(read_json(two / "history.json")));
  for (const char* variant : {"best-0.25", "best-1", "paper-0.25", "paper-1"}) {
    const auto mesh = std::filesystem::path(variant) / "cycle-2.msh";
    CHECK(read_text_file(one / mesh) == read_text_file(two / mesh));
  }
}

TEST_CASE("a missed target is code 1 with a valid result") {
  const TemporaryFolder folder;
  const auto study =
      folder.write("s.toml", small_problem("cycles = 1\ntarget = { error = 1e-6 }")).string();
  const auto dir = folder.path() / "r";
  const Result result = call({"run", study, "-o", dir.string()});
  CHECK(result.code == 1);
  CHECK(has(result.out, "target error missed after 1 cycles"));
  const Json variant = read_json(dir / "history.json")["variants"][0];
  CHECK(variant["target"] == "missed");
  CHECK(variant["cycles"].size() == 2);
  CHECK(call({"run", study, "-q", "-o", dir.string()}).code == 1);  // finished before, still missed
}

TEST_CASE("a run that its budget ends is code 5 and keeps its results") {
  const TemporaryFolder folder;
  const auto study =
      folder
          .write("s.toml",
                 small_problem("cycles = 5\ntarget = { error = 1e-6 }\nbudget = { nodes = 50 }"))
          .string();
  const auto dir = folder.path() / "r";
  const Result result = call({"run", study, "-o", dir.string()});
  CHECK(result.code == 5);
  CHECK(has(result.err, "a budget was reached"));
  const Json variant = read_json(dir / "history.json")["variants"][0];
  CHECK(has(variant["stop_reason"], "budget reached after"));
  CHECK(variant["cycles"].size() < 5);
  CHECK(std::filesystem::exists(dir / "main/cycle-0.msh"));
}

TEST_CASE("the files of a cycle hold metric and all fields and the stages have files too") {
  const TemporaryFolder folder;
  const auto study =
      folder.write("s.toml", small_problem("cycles = 1\ntarget = { nodes = 60 }\nstages = true",
                                           "[output]\nformats = [\"msh\", \"vtu\", \"mesh\"]\n"));
  const auto dir = folder.path() / "r";
  REQUIRE(call({"run", study.string(), "-q", "-o", dir.string()}).code == 0);
  const MeshFile file = read_gmsh(dir / "main/cycle-1.msh");
  const auto components = [](const std::vector<FileField>& fields, const std::string& name) {
    for (const FileField& field : fields)
      if (field.name == name) return field.components;
    return 0;
  };
  CHECK(components(file.vertex_fields, "metric") == 9);
  CHECK(components(file.vertex_fields, "u") == 1);
  CHECK(components(file.element_fields, "indicator") == 1);
  const std::string vtu = read_text_file(dir / "main/cycle-1.vtu");
  for (const char* name : {"metric", "u", "indicator", "quality"})
    CHECK_MESSAGE(has(vtu, "Name=\"" + std::string(name) + "\""), name);
  const MeshFile stages = read_gmsh(dir / "main/cycle-1-stages.msh");
  for (const char* name : {"density", "scaled", "size limits", "stretch limit", "gradation"})
    CHECK_MESSAGE(components(stages.vertex_fields, name) == 9, name);
  CHECK(has(read_text_file(dir / "main/cycle-1-stages.vtu"), "Name=\"size limits\""));
  // Medit: one metric beside each mesh; the last is the metric itself.
  CHECK(read_metric_file(dir / "main/cycle-1-gradation.sol",
                         static_cast<Index>(file.mesh.points.size())) ==
        read_metric_file(dir / "main/cycle-1.msh", static_cast<Index>(file.mesh.points.size())));
}

TEST_CASE("plane vectors of a plate are written with three components") {
  const TemporaryFolder folder;
  Analysis analysis;
  analysis.vertex_fields = {{"shear", 2, {1, 2, 3, 4, 5, 6}}};
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_regions = {1};
  write_cycle(folder.path(), {"msh"}, 0, mesh, analysis);
  const MeshFile file = read_gmsh(folder.path() / "cycle-0.msh");
  REQUIRE(file.vertex_fields.size() == 1);
  CHECK(file.vertex_fields[0].values == std::vector<double>{1, 2, 0, 3, 4, 0, 5, 6, 0});
}

TEST_CASE("an interrupted run keeps the finished cycles and is code 130") {
  const TemporaryFolder folder;
  const StudyFile study = read_study_file(folder.write("t.toml", kTinyStudy));
  RunOptions options;
  options.directory = folder.path() / "r";
  options.cancelled = [&] {
    return std::filesystem::exists(options.directory / "main/cycle-1.msh");
  };
  std::ostringstream out, err;
  Console console(out, err);
  CHECK(run_study(study, options, console) == 130);
  const Json history = read_json(options.directory / "history.json");
  CHECK(history["variants"][0]["cycles"].size() == 2);
  CHECK(history["variants"][0]["stop_reason"] == "interrupted");
  CHECK_FALSE(std::filesystem::exists(options.directory / "main/cycle-2.msh"));
}

TEST_CASE("after an interruption no further variant is begun") {
  const TemporaryFolder folder;
  const StudyFile study = read_study_file(folder.write(
      "t.toml", std::string(kTinyStudy) + "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n"));
  RunOptions options;
  options.directory = folder.path() / "r";
  options.cancelled = [&] {
    return std::filesystem::exists(options.directory / "best/cycle-2.msh");
  };
  std::ostringstream out, err;
  Console console(out, err);
  CHECK(run_study(study, options, console) == 130);
  const Json history = read_json(options.directory / "history.json");
  CHECK(history["variants"][0]["cycles"].size() == 3);
  CHECK(history["variants"][1]["cycles"].empty());
  CHECK(history["variants"][1]["stop_reason"] == "interrupted");
  CHECK_FALSE(std::filesystem::exists(options.directory / "paper"));
}

TEST_CASE("what becomes of many earlier results takes one line") {
  const TemporaryFolder folder;
  const auto study = folder.write("t.toml", std::string(kTinyStudy) +
                                                "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n"
                                                "\"adapt.limits.hmax\" = [0.25, 0.5, 1]\n");
  const auto dir = folder.path() / "r";
  CHECK(call({"run", study.string(), "-q", "-o", dir.string()}).code == 0);
  const Result again = call({"run", study.string(), "-o", dir.string()});
  CHECK(again.code == 0);
  CHECK(has(again.out, "6 variants: finished by an earlier run"));
  CHECK_FALSE(has(again.out, "best-1: "));
}

TEST_CASE("Ctrl-C raises the flag instead of ending the program") {
  const InterruptGuard guard;
  CHECK_FALSE(InterruptGuard::requested());
  std::raise(SIGINT);
  CHECK(InterruptGuard::requested());
}

TEST_CASE("base64 agrees with the vectors of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(html_text("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;");
}

TEST_SUITE_END();
