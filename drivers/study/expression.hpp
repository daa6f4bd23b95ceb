#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/geometry/point.hpp"
#include "solver/space/coefficient.hpp"

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

  /// Whether the value of the i-th expression depends on an input, directly or through others.
  bool depends_on_inputs(std::size_t i) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

/// What the expressions of one table of a study may use beside x and y.
struct ExpressionNames {
  Constants constants;
  std::vector<NamedExpression> where;
};

/// A function of x and y that several threads may call at once. It throws InputError with the
/// coordinates where it is not finite.
ScalarFunction scalar_function(const ExpressionText& text, const ExpressionNames& names = {});

/// The same; a number when neither x nor y is in it. Throws InputError when that is not finite.
Coefficient coefficient(const ExpressionText& text, const ExpressionNames& names = {});

/// The value of an expression that uses neither x nor y; empty when it does. Throws as
/// coefficient() does.
std::optional<double> constant_value(const ExpressionText& text, const ExpressionNames& names = {});

/// "(x, y) = (1, 2)", for messages.
std::string coordinates(Point p);

}  // namespace anisofront
