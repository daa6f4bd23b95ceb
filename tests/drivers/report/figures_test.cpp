#include "drivers/report/figures.hpp"

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "drivers/base/process.hpp"
#include "drivers/base/text.hpp"
#include "drivers/history/history_json.hpp"
#include "drivers/report/figure_style.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

CycleRecord cycle_record(int cycle, Index vertices, double error) {
  CycleRecord record;
  record.cycle = cycle;
  record.dofs = 3 * vertices;
  record.background.vertices = vertices;
  record.background.edges = 8;
  record.background.percent_unit = 75;
  record.background.histogram[3] = 1;
  record.background.histogram[10] = 6;
  record.background.histogram[kLengthBins - 1] = 1;
  record.error = {1.25 * error, error, 1.25};
  record.seconds = {0.5, 1, 0.25, 0, 2, 0.125};
  return record;
}

VariantHistory variant_of(const std::string& name, const std::string& mode, Index vertices) {
  VariantHistory variant;
  variant.name = name;
  variant.settings = {{"adapt.mode", mode}, {"mesh.elements", "triangle"}};
  const double rate = mode == "isotropic" ? 1 : 0.6;
  for (int k = 0; k < 3; ++k)
    variant.cycles.push_back(cycle_record(k, vertices << (2 * k), rate / (1 << k)));
  return variant;
}

Json two_modes() {
  return history_json(
      "A plate", {variant_of("iso", "isotropic", 100), variant_of("aniso", "anisotropic", 90)});
}

bool has_gnuplot() { return run_program_in(".", {"gnuplot", "--version"}).status == 0; }

/// Nothing is found on the PATH while this lives.
class EmptyPath {
 public:
  EmptyPath() : path_(std::getenv("PATH")) { setenv("PATH", "/nonexistent", 1); }
  ~EmptyPath() { setenv("PATH", path_.c_str(), 1); }
  EmptyPath(const EmptyPath&) = delete;
  EmptyPath& operator=(const EmptyPath&) = delete;

 private:
  std::string path_;
};

/// The rows of numbers of a data file; texts at the end of a line are left out.
std::vector<std::vector<double>> numbers(const fs::path& path) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(read_text_file(path));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    rows.emplace_back();
    std::istringstream words(line);
    for (double value; words >> value;) rows.back().push_back(value);
  }
  return rows;
}

const Figure* figure_of(const FigureList& list, const std::string& file) {
  for (const Figure& figure : list.figures)
    if (figure.file == file) return &figure;
  return nullptr;
}

void check_drawings(const fs::path& folder, const std::string& stem) {
  CAPTURE(stem);
  CHECK(read_text_file(folder / (stem + ".svg")).starts_with("<?xml"));
  CHECK(has(read_text_file(folder / (stem + ".svg")), "</svg>"));
  CHECK(read_text_file(folder / (stem + ".pdf")).starts_with("%PDF-"));
  CHECK(read_text_file(folder / (stem + ".png")).starts_with("\x89PNG\r\n"));
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("every figure of a study has drawings data and script") {
  REQUIRE(has_gnuplot());
  const TemporaryFolder folder;
  const FigureList list = draw_figures(two_modes(), folder.path());
  CHECK(list.problems.empty());
  const fs::path figures = folder.path() / "figures";
  for (const char* stem :
       {"error", "effectivity", "comparison", "unit-band", "timings", "iso-edge-lengths"}) {
    check_drawings(figures, stem);
    const std::string s = stem;
    const Figure* figure = figure_of(list, s + ".svg");
    REQUIRE(figure != nullptr);
    CHECK(figure->files ==
          std::vector<std::string>{s + ".svg", s + ".pdf", s + ".png", s + ".dat", s + ".gp"});
    for (const std::string& file : figure->files) CHECK(fs::file_size(figures / file) > 0);
  }
  CHECK(figure_of(list, "iso-edge-lengths.svg")->variant == "iso");
  CHECK(figure_of(list, "error.svg")->variant.empty());
  CHECK(read_text_file(figures / "style.gp") == figure_style());
}

TEST_CASE("a script run by hand draws its figure again in the style of the folder") {
  REQUIRE(has_gnuplot());
  const TemporaryFolder folder;
  draw_figures(two_modes(), folder.path());
  const fs::path figures = folder.path() / "figures";
  for (const char* suffix : {".svg", ".pdf", ".png"})
    fs::remove(figures / ("error" + std::string(suffix)));
  std::ofstream(figures / "style.gp", std::ios::app) << "wanted = 'svg'\nwidth = 17.2\n";
  CHECK(run_program_in(figures, {"gnuplot", "error.gp"}).status == 0);
  CHECK(has(read_text_file(figures / "error.svg"), "width=\"650\""));  // 17.2 cm at 96 per inch
  CHECK_FALSE(fs::exists(figures / "error.pdf"));
  CHECK(run_program_in(figures, {"gnuplot", "make-all.gp"}).status == 0);
  CHECK(has(read_text_file(figures / "timings.svg"), "width=\"650\""));
}

TEST_CASE("the numbers beside the figures are those of the history") {
  const TemporaryFolder folder;
  const Json history = two_modes();
  draw_figures(history, folder.path());
  const fs::path figures = folder.path() / "figures";

  const auto errors = numbers(figures / "error.dat");
  for (std::size_t v = 0; v < 2; ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      const Json& cycle = history["variants"][v]["cycles"][k];
      // Three cycles of a curve, then a line of NaN: none on the way. NaN is not read as a number.
      const std::vector<double>& row = errors.at(4 * v + k);
      CHECK(row == std::vector<double>{cycle["dofs"], cycle["error"]["relative_energy"],
                                       cycle["error"]["estimate"], cycle["error"]["effectivity"],
                                       cycle["cycle"]});
    }
  const auto lengths = numbers(figures / "iso-edge-lengths.dat");
  REQUIRE(lengths.size() == kLengthBins);
  CHECK(lengths[3] == std::vector<double>{0.35, 12.5, 12.5, 12.5});
  CHECK(lengths[10] == std::vector<double>{1.05, 75, 75, 75});
  CHECK(lengths.back() == std::vector<double>{3.05, 12.5, 12.5, 12.5});
  CHECK(numbers(figures / "timings.dat")[1] == std::vector<double>{-2, 1.5, 3, 0.75, 0, 6, 0.375});
  CHECK(numbers(figures / "unit-band.dat").at(2) == std::vector<double>{2, 75});
  const Json& comparison = history["comparison"][0];
  const std::vector<double> row = numbers(figures / "comparison.dat").at(0);
  CHECK(row[1] == comparison["isotropic"]["vertices"].get<double>());
  CHECK(row[7] == comparison["error"].get<double>());
}

TEST_CASE("variants that differ in their target make one curve with its slope") {
  std::vector<VariantHistory> variants;
  for (int k = 0; k < 3; ++k) {
    variants.push_back(variant_of("n" + std::to_string(k), "anisotropic", 100));
    variants.back().settings.emplace_back("adapt.target.nodes", std::to_string(100 << k));
    variants.back().cycles[2] = cycle_record(2, 1000 << k, 0.1 / (1 << k));  // order 1
  }
  const TemporaryFolder folder;
  draw_figures(history_json("t", variants), folder.path());
  const auto rows = numbers(folder.path() / "figures/error.dat");
  CHECK(rows.at(0)[0] == 3000);
  CHECK(rows.at(2)[0] == 12000);
  CHECK(rows.at(3)[4] == 1);  // on the way: cycle 1 of the first
  REQUIRE(rows.size() == 8);
  const double slope = std::log(rows[7][1] / rows[6][1]) / std::log(rows[7][0] / rows[6][0]);
  CHECK(slope == doctest::Approx(-1));
  CHECK(has(read_text_file(folder.path() / "figures/error.gp"), "set label '−1'"));
}

TEST_CASE("cycles at one size have no slope and growing ones have") {
  VariantHistory growing = variant_of("v", "isotropic", 100), fixed = growing;
  for (CycleRecord& cycle : fixed.cycles) cycle.dofs = cycle.cycle == 0 ? 10 : 1000;
  const TemporaryFolder folder;
  draw_figures(history_json("t", {fixed}), folder.path());
  CHECK_FALSE(has(read_text_file(folder.path() / "figures/error.gp"), "set label"));
  draw_figures(history_json("t", {growing}), folder.path());
  // The error is halved and the unknowns are four times as many.
  CHECK(has(read_text_file(folder.path() / "figures/error.gp"), "set label '−1/2'"));
}

TEST_CASE("a mode without an error as large has no bar") {
  REQUIRE(has_gnuplot());
  std::vector<VariantHistory> variants{variant_of("iso", "isotropic", 100),
                                       variant_of("aniso", "anisotropic", 90)};
  for (CycleRecord& cycle : variants[1].cycles) *cycle.error.relative_energy /= 10;
  const TemporaryFolder folder;
  const FigureList list = draw_figures(history_json("t", variants), folder.path());
  CHECK(list.problems.empty());
  CHECK(numbers(folder.path() / "figures/comparison.dat").at(0)[2] == 0);
  CHECK(has(read_text_file(folder.path() / "figures/comparison.svg"), "no mesh with so large"));
}

TEST_CASE("names with any characters do no harm") {
  REQUIRE(has_gnuplot());
  const TemporaryFolder folder;
  const std::string name =
      "`touch pwned` \"; system('touch pwned2'); '\\\n$x @y {/:Bold z}#_^ é/..";
  std::vector<VariantHistory> variants{variant_of(name, "isotropic", 100),
                                       variant_of("_touch_pwned_", "anisotropic", 90)};
  const FigureList list = draw_figures(history_json(name, variants), folder.path());
  CHECK(list.problems.empty());
  const fs::path figures = folder.path() / "figures";
  std::set<std::string> others;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (has(entry.path().filename().string(), "pwned") && !has(entry.path().string(), "_touch"))
      others.insert(entry.path().string());
  CHECK(others.empty());
  CHECK_FALSE(fs::exists("pwned"));
  const std::string svg = read_text_file(figures / "unit-band.svg");
  CHECK(has(svg, "`touch pwned` \"; system('touch pwned2'); '\\ $x @y {/:Bold z}#_^ é/.."));
}

TEST_CASE("names that are alike as file names keep figures of their own") {
  const TemporaryFolder folder;
  draw_figures(
      history_json("t", {variant_of("a b", "isotropic", 9), variant_of("a_b", "isotropic", 9)}),
      folder.path());
  CHECK(has(read_text_file(folder.path() / "figures/a_b-edge-lengths.gp"), ": a b"));
  CHECK(has(read_text_file(folder.path() / "figures/a_b-edge-lengths-2.gp"), ": a_b"));
}

TEST_CASE("without gnuplot data and scripts are left with one warning") {
  const TemporaryFolder folder;
  FigureList list;
  {
    const EmptyPath nothing;
    list = draw_figures(two_modes(), folder.path());
  }
  REQUIRE(list.problems.size() == 1);
  CHECK(has(list.problems[0], "gnuplot is not installed"));
  CHECK(list.figures.empty());
  for (const char* file : {"error.dat", "error.gp", "iso-edge-lengths.gp", "style.gp", "formats.gp",
                           "make-all.gp", "README.txt"})
    CHECK(fs::exists(folder.path() / "figures" / file));
  CHECK_FALSE(fs::exists(folder.path() / "figures/error.svg"));
}

TEST_CASE("a style that gnuplot does not understand is kept and reported") {
  REQUIRE(has_gnuplot());
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "figures");
  folder.write("figures/style.gp", "set nonsense\n");
  const FigureList list = draw_figures(two_modes(), folder.path());
  REQUIRE_FALSE(list.problems.empty());
  CHECK(has(list.problems[0], "style.gp\" line 1"));
  CHECK(list.problems.size() <= 3);
  CHECK(read_text_file(folder.path() / "figures/style.gp") == "set nonsense\n");
}

TEST_CASE("a script that fails keeps no other from being drawn") {
  REQUIRE(has_gnuplot());
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "figures");
  folder.write("figures/style.gp", "if (name eq 'unit-band') { set nonsense }\n");
  const FigureList list = draw_figures(two_modes(), folder.path());
  CHECK(list.problems.size() == 1);
  CHECK(figure_of(list, "unit-band.svg") == nullptr);
  CHECK(figure_of(list, "error.svg") != nullptr);
  CHECK(figure_of(list, "aniso-edge-lengths.svg") != nullptr);
}

TEST_CASE("a script that makes gnuplot crash is found") {
  REQUIRE(has_gnuplot());
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "figures");
  folder.write("figures/style.gp", "if (name eq 'comparison') { system 'kill -9 $PPID' }\n");
  const FigureList list = draw_figures(two_modes(), folder.path());
  REQUIRE(list.problems.size() == 1);
  CHECK(has(list.problems[0], "comparison.gp: it ended with status 128"));
  CHECK(figure_of(list, "error.svg") != nullptr);
  CHECK(figure_of(list, "timings.svg") != nullptr);
}

TEST_CASE("figures of an earlier run go and files of the user stay") {
  const TemporaryFolder folder;
  const fs::path figures = folder.path() / "figures";
  draw_figures(two_modes(), folder.path());
  REQUIRE(fs::exists(figures / "aniso-edge-lengths.dat"));
  folder.write("outside", "kept");
  folder.write("figures/my-error.gp", "kept");
  std::ofstream(figures / "made.txt", std::ios::app) << "../outside\n\n.\n";
  draw_figures(history_json("t", {variant_of("iso", "isotropic", 100)}), folder.path());
  CHECK_FALSE(fs::exists(figures / "aniso-edge-lengths.dat"));
  CHECK_FALSE(fs::exists(figures / "comparison.gp"));
  CHECK(fs::exists(figures / "iso-edge-lengths.dat"));
  CHECK(fs::exists(folder.path() / "outside"));
  CHECK(read_text_file(figures / "my-error.gp") == "kept");
}

TEST_CASE("equal histories leave equal figures") {
  const TemporaryFolder one, two;
  draw_figures(two_modes(), one.path());
  draw_figures(two_modes(), two.path());
  for (const auto& entry : fs::directory_iterator(one.path() / "figures"))
    CHECK_MESSAGE(read_text_file(entry.path()) ==
                      read_text_file(two.path() / "figures" / entry.path().filename()),
                  entry.path());
}

TEST_CASE("of many variants only the common figures are drawn") {
  REQUIRE(has_gnuplot());
  std::vector<VariantHistory> variants;
  for (int k = 0; k < 13; ++k)
    variants.push_back(variant_of("v" + std::to_string(k), "isotropic", 9));
  const TemporaryFolder folder;
  const FigureList list = draw_figures(history_json("t", variants), folder.path());
  CHECK(figure_of(list, "unit-band.svg") != nullptr);
  CHECK(figure_of(list, "v3-edge-lengths.svg") == nullptr);
  const fs::path figures = folder.path() / "figures";
  CHECK(fs::exists(figures / "v3-edge-lengths.gp"));
  CHECK(run_program_in(figures, {"gnuplot", "make-all.gp"}).status == 0);
  CHECK(fs::exists(figures / "v12-edge-lengths.pdf"));
}

TEST_CASE("qualities are drawn where the history has them") {
  Json history = two_modes();
  for (Json& cycle : history["variants"][0]["cycles"])
    cycle["quality"]["histogram"] = {{"bounds", {0.5, 1.0}}, {"counts", {1, 3}}};
  // Those of older versions.
  for (Json& cycle : history["variants"][1]["cycles"]) cycle["quality"].erase("histogram");
  const TemporaryFolder folder;
  draw_figures(history, folder.path());
  CHECK(numbers(folder.path() / "figures/iso-quality.dat") ==
        std::vector<std::vector<double>>{{0.25, 25, 25, 25}, {0.75, 75, 75, 75}});
  CHECK(has(read_text_file(folder.path() / "figures/iso-quality.gp"), "set xrange [0:1]"));
  CHECK_FALSE(fs::exists(folder.path() / "figures/aniso-quality.gp"));
}

TEST_CASE("profiles have a figure per line and quantity with the reference") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "iso/lines");
  folder.write("iso/lines/cycle-0-cut.csv",
               "s,x,y,w,theta_x,M_ns\n0,0,0,0,9,5e-5\n1,1,0,2,9,6e-5\n");
  folder.write("iso/lines/cycle-12-cut.csv",
               "s,x,y,w,theta_x,M_ns\n0,0,0,1e-20,9,7e-5\n1,1,0,3,9,8e-5\n");
  folder.write("iso/lines/reference-cut.csv", "s,theta_x,M_ns,unknown\n0.5,9,7.5e-5,1\n");
  folder.write("iso/lines/cycle-0-rim.csv", "s,x,y,w,Q_n\n0,0,0,0,1\n1,1,0,1e-17,1\n");
  const FigureList list = draw_figures(two_modes(), folder.path());
  CHECK(list.problems.empty());
  const fs::path figures = folder.path() / "figures";
  CHECK(
      numbers(figures / "iso-profile-cut-M_ns.dat") ==
      std::vector<std::vector<double>>{{0, 5e-5}, {1, 6e-5}, {0, 7e-5}, {1, 8e-5}, {0.5, 7.5e-5}});
  const std::string script = read_text_file(figures / "iso-profile-cut-M_ns.gp");
  CHECK(has(script, "set ylabel 'M_{ns} / 10^{-5}'"));
  CHECK(has(script, "($2*1e5)"));
  CHECK(has(script, "'cycle 12'"));
  CHECK(has(script, "'reference'"));
  CHECK_FALSE(fs::exists(figures / "iso-profile-cut-w.gp"));        // not in the reference
  CHECK_FALSE(fs::exists(figures / "iso-profile-cut-theta_x.gp"));  // without layers
  CHECK(fs::exists(figures / "iso-profile-rim-Q_n.gp"));
  CHECK_FALSE(fs::exists(figures / "iso-profile-rim-w.gp"));  // 0 but for rounding
}

TEST_CASE("variants without cycles or errors have fewer figures") {
  VariantHistory bare = variant_of("bare", "isotropic", 9), failed;
  for (CycleRecord& cycle : bare.cycles) cycle.error = {};
  failed.name = "failed";
  const TemporaryFolder folder;
  const FigureList list = draw_figures(history_json("t", {bare, failed}), folder.path());
  CHECK(list.problems.empty());
  CHECK(figure_of(list, "error.svg") == nullptr);
  CHECK_FALSE(fs::exists(folder.path() / "figures/effectivity.gp"));
  CHECK_FALSE(fs::exists(folder.path() / "figures/failed-edge-lengths.gp"));
  CHECK(fs::exists(folder.path() / "figures/unit-band.gp"));
}

TEST_CASE("a damaged history is refused") {
  const TemporaryFolder folder;
  Json history = two_modes();
  history["variants"][0]["cycles"][0].erase("edge_length");
  CHECK(has(message_of<InputError>([&] { draw_figures(history, folder.path()); }),
            "not a history of schema 1"));
  CHECK_THROWS_AS(draw_figures(Json::object(), folder.path()), InputError);
}

TEST_SUITE_END();
