#include "drivers/study/expression.hpp"

#include <atomic>
#include <cmath>
#include <thread>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

ExpressionText at(const std::string& text) { return {text, "s.toml:3:1: metric.h1"}; }

std::string failure(const std::string& text) {
  return message_of<UsageError>([&] { scalar_function(at(text)); });
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("an expression is a function of x and y") {
  const auto f = scalar_function(at("2*x - y^2 + max(1, k) + sqrt(4)"), {{{"k", 3.}}, {}});
  CHECK(f({5, 2}) == doctest::Approx(11));
  CHECK(f({0, 0}) == doctest::Approx(5));
  CHECK(scalar_function(at("cos(pi) + log(exp(2)) + (x > 1 ? 10 : 20)"))({2, 0}) ==
        doctest::Approx(11));
}

TEST_CASE("expressions may use each other in any order") {
  ExpressionProgram program({"x"}, {}, {{"h1", at("8*h2")}, {"h2", at("r + 1")}, {"r", at("x*x")}});
  CHECK(program.evaluate({3}) == std::vector<double>{80, 10, 9});
  CHECK(program.evaluate({0}) == std::vector<double>{8, 1, 0});
}

TEST_CASE("an unknown name is reported with its column and the nearest known one") {
  const std::string message = message_of<UsageError>([] {
    ExpressionProgram({"x", "y"}, {}, {{"radius", at("x")}, {"h1", at("0.1 + raduis")}});
  });
  CHECK(message ==
        "s.toml:3:1: metric.h1 = \"0.1 + raduis\": unknown name \"raduis\" (column 7)"
        "; did you mean \"radius\"?");
}

TEST_CASE("syntax errors name the key and the column") {
  CHECK(has(failure("0.1 + * x"), "s.toml:3:1: metric.h1 = \"0.1 + * x\": "));
  CHECK(has(failure("0.1 + * x"), "column 7"));
  CHECK_FALSE(failure("").empty());
  CHECK_FALSE(failure("(x").empty());
}

TEST_CASE("expressions in a circle and names used twice are refused") {
  CHECK(has(message_of<UsageError>([] {
              ExpressionProgram({"x"}, {}, {{"h1", at("h2")}, {"h2", at("h1")}});
            }),
            "refers to itself"));
  CHECK(has(message_of<UsageError>([] {
              ExpressionProgram({"x"}, {{"x", 1.}}, {{"x", at("1")}});
            }),
            "\"x\" is taken"));
}

TEST_CASE("a value that is not finite is reported with the coordinates") {
  const auto f = scalar_function(at("1/x"));
  CHECK(f({2, 0}) == 0.5);
  const std::string message = message_of<InputError>([&] { f({0, 7}); });
  CHECK(has(message, "(x, y) = (0, 7)"));
  CHECK(has(message, "metric.h1 = \"1/x\""));
  CHECK_THROWS_AS(scalar_function(at("sqrt(x)"))({-1, 0}), InputError);
}

TEST_CASE("an expression without x and y is a number") {
  CHECK(constant_value(at("2*k"), {{{"k", 3.}}, {}}) == 6.);
  CHECK_FALSE(constant_value(at("2*x")).has_value());
  // Through another name, too.
  const ExpressionNames names{{}, {{"r", at("s + 1")}, {"s", at("y")}, {"k", at("7")}}};
  CHECK_FALSE(constant_value(at("r"), names).has_value());
  CHECK(constant_value(at("k"), names) == 7.);
  CHECK(coefficient(at("0"), names).is_zero());
  CHECK_FALSE(coefficient(at("0*x")).is_constant());
  CHECK(coefficient(at("r"), names)({0, 4}) == 5.);
  CHECK_THROWS_AS(coefficient(at("sqrt(-1)")), InputError);
}

TEST_CASE("a function of x and y may be called from several threads at once") {
  const ExpressionNames names{{{"k", 2.}}, {{"r", at("k*x + y")}}};
  const ScalarFunction f = scalar_function(at("r^2 - x"), names);
  constexpr int kThreads = 8, kCalls = 20000;
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < kThreads; ++thread)
      threads.emplace_back([&, thread] {
        for (int i = 0; i < kCalls; ++i) {
          const double x = thread, y = i, r = 2 * x + y;
          if (f({x, y}) != r * r - x) ++wrong;
        }
      });
  }
  CHECK(wrong == 0);
}

TEST_CASE("an error in one thread leaves the function usable") {
  const ScalarFunction f = scalar_function(at("1/x"));
  for (int i = 0; i < 100; ++i) CHECK_THROWS_AS(f({0, 0}), InputError);
  CHECK(f({4, 0}) == 0.25);
}

TEST_SUITE_END();
