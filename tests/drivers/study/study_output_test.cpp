#include "drivers/study/study_output.hpp"

#include "tests/drivers/problem_studies.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

Study with(const std::string& tables, const std::string& problem = "source = 1") {
  return parse_text(square_study(problem, tables));
}
std::string failure(const std::string& tables, const std::string& problem = "source = 1") {
  return parse_failure(square_study(problem, tables));
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("values and lines are asked for by name") {
  const OutputRequests output = with(R"([output]
formats = ["svg"]
values = [{ name = "the centre", at = [0.5, 0.5] }]
lines = [
  { name = "edge", curve = "bottom", points = 11 },
  { name = "cut", from = [0, 0.5], to = [1, 0.5] },
]
)")
                                    .output;
  CHECK(output.formats == std::vector<std::string>{"svg"});
  REQUIRE(output.values.size() == 1);
  CHECK(output.values[0].name == "the centre");
  CHECK(output.values[0].at == Point{0.5, 0.5});
  REQUIRE(output.lines.size() == 2);
  CHECK(output.lines[0].curve == "bottom");
  CHECK(output.lines[0].points == 11);
  CHECK(output.lines[1].curve == "");
  CHECK(output.lines[1].to == Point{1, 0.5});
  CHECK(output.lines[1].points == 101);
}

TEST_CASE("mistakes in the output table are refused with their line") {
  CHECK(
      has(failure("[output]\nvalues = [{ name = \"a\" }]"), "\"output.values[0].at\" is missing"));
  CHECK(has(failure("[output]\nvalues = [{ at = [0, 0] }]"), "values[0].name\" is missing"));
  CHECK(has(failure("[output]\nvalues = [{ name = \"a\", at = [0, 0] },\n{ name = \"a\", at = [1, "
                    "0] }]"),
            "s.toml:15:10: output.values[1].name: \"a\" stands there twice"));
  const auto line = [](const std::string& entry) {
    return failure("[output]\nlines = [{ name = \"a\", " + entry + " }]");
  };
  CHECK(has(line("points = 3"), "expected either curve"));
  CHECK(has(line("curve = \"left\", from = [0, 0]"), "expected either curve"));
  CHECK(has(line("from = [0, 0]"), "expected either curve"));
  CHECK(has(line("from = [0, 0], to = [0, 0]"), "is the same point as from"));
  CHECK(has(line("curve = \"left\", points = 1"), "expected 2 to 1000000, found 1"));
  CHECK(has(line("curv = \"left\", from = [0, 0], to = [0, 1]"), "did you mean \"curve\"?"));
  CHECK(has(failure("[output]\nlines = [{ name = \"../a\", curve = \"left\" }]"),
            "becomes the name of a file"));
  CHECK(has(failure("[output]\nformats = [\"png\"]"), "unknown format \"png\""));
}

TEST_CASE("points of a line can stand close together towards its ends") {
  const auto line = [](const std::string& keys) {
    return with("[output]\nlines = [{ name = \"a\", curve = \"left\"" + keys + " }]")
        .output.lines.at(0);
  };
  CHECK(line("").grading == 1);
  CHECK(line(", grading = 4").grading == 4);
  CHECK(line(", grading = 4").towards == LineEnd::start);
  CHECK(line(", grading = 1.5, towards = \"end\"").towards == LineEnd::end);
  CHECK(line(", grading = 2, towards = \"both\"").towards == LineEnd::both);
}

TEST_CASE("a line is compared with a file or with expressions") {
  const OutputRequests output = with(R"([output]
lines = [
  { name = "a", curve = "left", reference = "tables/fine.csv" },
  { name = "b", curve = "left", reference = { u_x = "2*s", u = 1 } },
  { name = "c", curve = "left" },
]
)")
                                    .output;
  REQUIRE(output.lines.size() == 3);
  const LineReference file = output.lines[0].reference.value();
  CHECK(file.file == "tables/fine.csv");
  CHECK(has(file.place, "s.toml:15:45: output.lines[0].reference"));
  CHECK(beside_study("/studies/s.toml", file.file) == "/studies/tables/fine.csv");
  CHECK(beside_study("/studies/s.toml", "/elsewhere/fine.csv") == "/elsewhere/fine.csv");
  const LineReference formulas = output.lines[1].reference.value();
  CHECK(formulas.file.empty());
  REQUIRE(formulas.quantities.size() == 2);
  CHECK(formulas.quantities[0].name == "u_x");
  CHECK(formulas.quantities[0].expression.text == "2*s");
  CHECK(has(formulas.quantities[1].expression.place, "s.toml:16:64: output.lines[1].reference.u"));
  CHECK_FALSE(output.lines[2].reference.has_value());
}

TEST_CASE("mistakes in spacing and references of lines are refused with their line") {
  const auto line = [](const std::string& keys) {
    return failure("[output]\nlines = [{ name = \"a\", curve = \"left\", " + keys + " }]");
  };
  CHECK(has(line("grading = 0.5"),
            "s.toml:14:50: output.lines[0].grading: expected 1 (equal steps) to 20, found 0.5"));
  CHECK(has(line("grading = 21"), "expected 1 (equal steps) to 20, found 21"));
  CHECK(has(line("towards = \"end\""), "write grading = 2 or more too"));
  CHECK(has(line("grading = 2, towards = \"ends\""), "expected one of: start, end, both"));
  CHECK(has(line("reference = 3"), "expected a text in quotes, found the number 3"));
  CHECK(has(line("reference = \"\""), "expected the name of a file"));
  CHECK(has(line("reference = {}"), "output.lines[0].reference: is empty"));
  CHECK(has(line("reference = { u = [1] }"),
            "output.lines[0].reference.u: expected an expression in quotes or a number"));
  CHECK(has(line("referenc = \"a.csv\""), "did you mean \"reference\"?"));
}

TEST_CASE("names of reference files are changed wherever they stand") {
  toml::table study = toml::parse(R"([output]
lines = [{ reference = "a.csv" }, { reference = { u = "s" } }, { name = "c" }, 3]
)");
  std::vector<std::string> seen;
  change_reference_files(study, [&](const std::string& name) {
    seen.push_back(name);
    return "/b/" + name;
  });
  CHECK(seen == std::vector<std::string>{"a.csv"});
  CHECK(study["output"]["lines"][0]["reference"].value<std::string>() == "/b/a.csv");
  CHECK(study["output"]["lines"][1]["reference"]["u"].value<std::string>() == "s");
  for (const char* without : {"", "output = 3", "[output]\nlines = 4"}) {
    toml::table other = toml::parse(without);
    change_reference_files(other, [](const std::string&) -> std::string { throw 1; });
  }
}

TEST_CASE("the solver is chosen by name") {
  const SolverSettings solver =
      with("[solver]\nmethod = \"simplicial\"\nthreads = 2\nmemory = 1.5").solver;
  CHECK(solver.method == LinearMethod::simplicial);
  CHECK(solver.threads == 2);
  CHECK(solver.memory == 1.5);
  CHECK(with("").solver.method == LinearMethod::automatic);
  for (const auto& [word, method] : {std::pair{"supernodal", LinearMethod::supernodal},
                                     std::pair{"multigrid", LinearMethod::multigrid},
                                     std::pair{"general", LinearMethod::general}})
    CHECK(with("[solver]\nmethod = \"" + std::string(word) + "\"").solver.method == method);
}

TEST_CASE("solvers that cannot solve the problem are refused") {
  CHECK(has(failure("[solver]\nmethod = \"direct\""), "expected one of: automatic, simplicial"));
  CHECK(has(failure("[solver]\nmemory = 0"), "must be positive"));
  CHECK(has(failure("[solver]\nthreads = 1000"), "expected at most 256"));
  CHECK(has(failure("[solver]\nmethod = \"multigrid\"",
                    "kind = \"mindlin\"\nthickness = 1\nyoung = 1\npoisson_ratio = 0.3"),
            "multigrid is for kind = \"poisson\" only"));
  CHECK(has(failure("[solver]\nmethod = \"simplicial\"", "velocity = [1, 0]"),
            "a velocity makes the system unsymmetric"));
  CHECK(failure("[solver]\nmethod = \"general\"", "velocity = [1, 0]") == "");
}

TEST_SUITE_END();
