#include "drivers/problem/line_reference.hpp"

#include <cmath>

#include "tests/drivers/problem_studies.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const std::string kLine =
    "[output]\nlines = [{ name = \"cut\", from = [0, 0.5], to = [1, 0.5], "
    "points = 3, reference = ";

/// The reference of the first line of a study beside the file ref.csv, if that is given.
struct Lines {
  TemporaryFolder folder;
  Study study;

  Lines(const std::string& problem, const std::string& output, const std::string& csv = {}) {
    if (!csv.empty()) folder.write("ref.csv", csv);
    study = parse_study(toml::parse(square_study(problem, output)), folder.path() / "s.toml");
  }
  std::optional<NumberTable> reference() const {
    const LineRequest& request = study.output.lines.front();
    return line_reference(study, request, line_points(request, study.domain));
  }
  template <class Error = UsageError>
  std::string failure() const {
    return message_of<Error>([this] { reference(); });
  }
};

NumberTable from_file(const std::string& csv) {
  return Lines("source = 1", kLine + "\"ref.csv\" }]", csv).reference().value();
}
std::string file_failure(const std::string& csv) {
  return Lines("source = 1", kLine + "\"ref.csv\" }]", csv).failure();
}
std::string formula_failure(const std::string& reference, const std::string& problem = {}) {
  return Lines("source = 1\n" + problem, kLine + reference + " }]").failure();
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a line without a reference in a problem without a known solution has none") {
  const std::string plain = "[output]\nlines = [{ name = \"cut\", curve = \"left\" }]";
  CHECK_FALSE(Lines("source = 1", plain).reference().has_value());
}

TEST_CASE("the known solution is the reference of every line of its problem") {
  const std::string problem =
      "exact = \"product-layer\"\ndiffusion = 0.01\nreaction = 1\nboundary.left = { value = 0 }";
  const NumberTable table =
      Lines(problem,
            "[output]\nlines = [{ name = \"cut\", from = [0.5, 0], to = [0.5, 1], points "
            "= 3 }]")
          .reference()
          .value();
  CHECK(table.columns == std::vector<std::string>{"s", "u", "u_x", "u_y", "u_n", "u_s"});
  REQUIRE(table.rows.size() == 3);
  // g(s) = 1 - cosh((s - 1/2) / 0.1) / cosh(5), g' = -10 sinh((s - 1/2) / 0.1) / cosh(5).
  const double top = 1 - 1 / std::cosh(5.), slope = 10 * std::tanh(5.);
  CHECK(table.rows[1][0] == 0.5);
  CHECK(table.rows[1][1] == doctest::Approx(top * top));
  CHECK(std::abs(table.rows[0][1]) < 1e-14);
  CHECK(table.rows[0][3] == doctest::Approx(top * slope));
  CHECK(table.rows[0][5] == doctest::Approx(top * slope));  // up the line
  CHECK(table.rows[2][5] == doctest::Approx(-top * slope));
  CHECK(std::abs(table.rows[0][4]) < 1e-12);
}

TEST_CASE("an expression knows x y s and the names of the problem") {
  const std::string problem =
      "exact = \"sine-product\"\nconstants = { a = 3 }\nwhere = { r = \"x^2 + y^2\" }\n"
      "boundary.left = { value = 0 }";
  const NumberTable table =
      Lines(problem, kLine + "{ u_n = \"a*s + r\", u = 7 } }]").reference().value();
  CHECK(table.columns == std::vector<std::string>{"s", "u_n", "u"});  // instead of the known one
  CHECK(table.rows == std::vector<std::vector<double>>{{0, 0.25, 7}, {0.5, 2, 7}, {1, 4.25, 7}});
  const std::string plate = "kind = \"mindlin\"\nthickness = 1\nyoung = 1\npoisson_ratio = 0.3";
  CHECK(Lines(plate, kLine + "{ M_ns = \"x\" } }]").reference()->columns.at(1) == "M_ns");
}

TEST_CASE("mistakes in the expressions of a reference are refused with their place") {
  CHECK(has(formula_failure("{ u_t = 1 }"),
            "s.toml:15:90: output.lines[0].reference.u_t: unknown quantity \"u_t\"; did you mean "
            "\"u_x\"?"));
  CHECK(has(formula_failure("{ u = \"2*z\" }"),
            "s.toml:15:88: output.lines[0].reference.u = \"2*z\": unknown name \"z\" (column 3)"));
  CHECK(has(formula_failure("{ u = \"2*\" }"), "output.lines[0].reference.u = \"2*\": "));
  CHECK(has(formula_failure("{ u = \"r\" }", "where = { s = \"x\", r = \"y\" }"),
            "the name \"s\" is taken"));
  const Lines infinite("source = 1", kLine + "{ u = \"1/s\" } }]");
  CHECK(has(infinite.failure<InputError>(),
            "output.lines[0].reference.u = \"1/s\" is inf at (x, y) = (0, 0.5), s = 0; it must be "
            "finite"));
}

TEST_CASE("a table gives s and the quantities it has in any order") {
  CHECK(from_file("s,u\n0,1\n0.5,2.5e-1\n").rows ==
        std::vector<std::vector<double>>{{0, 1}, {0.5, 0.25}});
  const NumberTable table = from_file(
      "# finer solution\r\n\r\n u_s , x, y,s,u\r\n1, 2,3 ,4, 5 # first\r\n6,7,8,9,-1e3\n");
  CHECK(table.columns == std::vector<std::string>{"s", "u_s", "u"});
  CHECK(table.rows == std::vector<std::vector<double>>{{4, 1, 5}, {9, 6, -1000}});
}

TEST_CASE("a table that is missing or none is refused with its place in study and file") {
  CHECK(has(Lines("source = 1", kLine + "\"ref.csv\" }]").failure(), "ref.csv: no such file"));
  const auto fails = [](const std::string& csv, const std::string& expected) {
    const std::string message = file_failure(csv);
    CAPTURE(message);
    CHECK(has(message, "s.toml:14:82: output.lines[0].reference: "));
    CHECK(has(message, "ref.csv: line " + expected));
  };
  fails("\n", "1: there is no row of numbers");
  fails("s,u\n", "1: there is no row of numbers");
  fails("x,u\n1,2\n", "1: there is no column \"s\"");
  fails("s,x\n1,2\n", "1: expected a quantity beside \"s\": u, u_x, u_y, u_n, u_s");
  fails("s,w\n1,2\n", "1: unknown column \"w\"");
  fails("s,u,u\n1,2,3\n", "1: the column \"u\" stands there twice");
  fails("s,u\n0,1\n1\n", "3: found 1 values, expected 2");
  fails("s,u\n0,1,\n", "2: found 3 values, expected 2");
  fails("s,u\n0,one\n", "2: found \"one\" for u, expected a finite number");
  fails("s,u\n0,\n", "2: found \"\" for u, expected a finite number");
  fails("s,u\n0,nan\n", "2: found \"nan\" for u");
  fails("s,u\n0,1;2\n", "2: found \"1;2\" for u");
  fails("s,u\n\n1,1\n0.5,2\n", "4: s falls");
  fails("\xff\xfe\n", "1: unknown column");
}

TEST_SUITE_END();
