#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mesher/geometry/point.hpp"
#include "solver/scalar_problem.hpp"

namespace anisofront {

/// An expression as the user wrote it. `place` starts every message about it:
/// "plate.toml:12:9: metric.prescribed[0].h1".
struct ExpressionText {
  std::string text;
  std::string place;
};

struct NamedExpression {
  std::string name;  ///< empty: cannot be referred to
  ExpressionText expression;
};

using Constants = std::vector<std::pair<std::string, double>>;

/// Expressions that may use one another by name, compiled once. Syntax of muParser: + - * / ^,
/// comparisons, c ? a : b, sqrt abs min max exp log (natural) log10 sin cos tan atan2 ..., and
/// pi. Not for use by several threads at once.
class ExpressionProgram {
 public:
  /// `inputs`: names of the values given to evaluate(). The order of the expressions is free.
  /// Throws UsageError with the place, the column in the expression and the nearest known name for
  /// syntax errors and unknown names, and for names that are used twice or refer to each other in
  /// a circle. `hint` ends the message about an unknown name.
  ExpressionProgram(std::vector<std::string> inputs, const Constants& constants,
                    std::vector<NamedExpression> expressions, const std::string& hint = {});
  ~ExpressionProgram();
  ExpressionProgram(ExpressionProgram&&) noexcept;

  /// inputs[i] belongs to the i-th input name. The results stay valid until the next call.
  const std::vector<double>& evaluate(std::initializer_list<double> inputs);

  /// The i-th expression as given to the constructor.
  const NamedExpression& expression(std::size_t i) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

/// A function of x and y. It throws InputError with the coordinates where it is not finite.
ScalarFunction scalar_function(const ExpressionText& text, const Constants& constants = {});

/// "(x, y) = (1, 2)", for messages.
std::string coordinates(Point p);

}  // namespace anisofront
