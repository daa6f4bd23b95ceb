#include "drivers/study/expression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <muParser.h>
#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/study/shared_program.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {

struct ExpressionProgram::Compiled {
  struct Step {
    mu::Parser parser;
    std::size_t expression;
  };
  std::vector<NamedExpression> expressions;
  std::vector<double> inputs;
  std::vector<double> results;
  std::vector<Step> steps;   ///< in an order in which every name is known when it is used
  std::vector<bool> varies;  ///< per expression: depends on an input
};

namespace {

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void fail(const ExpressionText& at, const std::string& what) {
  throw UsageError(fmt::format("{} = \"{}\": {}", at.place, at.text, what));
}

std::string parser_message(const mu::Parser::exception_type& error) {
  std::string message = error.GetMsg();
  if (!message.empty() && message.back() == '.') message.pop_back();
  return error.GetPos() >= 0 ? fmt::format("{} (column {})", message, error.GetPos() + 1) : message;
}

template <class Action>
auto translating_errors(const ExpressionText& at, Action action) {
  try {
    return action();
  } catch (const mu::Parser::exception_type& error) {
    fail(at, parser_message(error));
  }
}

Names used_names(mu::Parser& parser, const ExpressionText& at) {
  return translating_errors(at, [&] {
    Names names;
    for (const auto& [name, address] : parser.GetUsedVar()) names.push_back(name);
    return names;
  });
}

/// Column of the first place where the name stands as a word of its own.
std::size_t column_of(const std::string& name, const std::string& text) {
  const auto is_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end])))
      return at + 1;
  }
  return 1;
}

void define_constants(mu::Parser& parser, const Constants& constants, const ExpressionText& at) {
  translating_errors(at, [&] {
    parser.DefineConst("pi", std::numbers::pi);
    for (const auto& [name, value] : constants) parser.DefineConst(name, value);
  });
}

/// Every name must mean one thing.
void check_names(const Names& inputs, const Constants& constants,
                 const std::vector<NamedExpression>& expressions) {
  Names taken = inputs;
  for (const auto& [name, value] : constants) taken.push_back(name);
  for (const NamedExpression& e : expressions) {
    if (e.name.empty()) continue;
    if (contains(taken, e.name))
      fail(e.expression, fmt::format("the name \"{}\" is taken; choose another", e.name));
    taken.push_back(e.name);
  }
}

/// The parsers of all expressions, with the names each of them uses.
struct Parsed {
  std::vector<mu::Parser> parsers;
  std::vector<Names> needs;
};

Parsed parse_all(const Names& inputs, const Constants& constants,
                 const std::vector<NamedExpression>& expressions, const std::string& hint) {
  Names known = inputs;
  for (const NamedExpression& e : expressions)
    if (!e.name.empty()) known.push_back(e.name);
  Names proposed = known;
  for (const auto& [name, value] : constants) proposed.push_back(name);
  Parsed parsed{std::vector<mu::Parser>(expressions.size()),
                std::vector<Names>(expressions.size())};
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    const ExpressionText& at = expressions[i].expression;
    define_constants(parsed.parsers[i], constants, at);
    parsed.parsers[i].SetExpr(at.text);
    parsed.needs[i] = used_names(parsed.parsers[i], at);
    for (const std::string& name : parsed.needs[i])
      if (!contains(known, name))
        fail(at, fmt::format("unknown name \"{}\" (column {}){}{}", name, column_of(name, at.text),
                             name_proposal(name, proposed), hint));
  }
  return parsed;
}

/// An order in which every expression follows those it uses.
std::vector<std::size_t> evaluation_order(const Names& inputs,
                                          const std::vector<NamedExpression>& expressions,
                                          const std::vector<Names>& needs) {
  Names ready = inputs;
  const auto is_ready = [&](const std::string& name) { return contains(ready, name); };
  std::vector<std::size_t> order;
  std::vector<bool> done(expressions.size(), false);
  while (order.size() < expressions.size()) {
    const std::size_t before = order.size();
    for (std::size_t i = 0; i < expressions.size(); ++i) {
      if (done[i] || !std::all_of(needs[i].begin(), needs[i].end(), is_ready)) continue;
      order.push_back(i);
      ready.push_back(expressions[i].name);
      done[i] = true;
    }
    if (order.size() > before) continue;
    const auto stuck = std::find(done.begin(), done.end(), false) - done.begin();
    fail(expressions[static_cast<std::size_t>(stuck)].expression,
         "refers to itself, directly or through others; break the circle");
  }
  return order;
}

/// Whether one of the names is an input or an expression known to vary.
bool any_varies(const Names& needs, const Names& inputs,
                const std::vector<NamedExpression>& expressions, const std::vector<bool>& varies) {
  for (const std::string& name : needs) {
    if (contains(inputs, name)) return true;
    for (std::size_t k = 0; k < expressions.size(); ++k)
      if (varies[k] && expressions[k].name == name) return true;
  }
  return false;
}

}  // namespace

ExpressionProgram::ExpressionProgram(std::vector<std::string> inputs, const Constants& constants,
                                     std::vector<NamedExpression> expressions,
                                     const std::string& hint)
    : compiled_(std::make_unique<Compiled>()) {
  check_names(inputs, constants, expressions);
  Compiled& c = *compiled_;
  c.inputs.resize(inputs.size());
  c.results.resize(expressions.size());
  c.varies.resize(expressions.size());
  c.expressions = std::move(expressions);
  Parsed parsed = parse_all(inputs, constants, c.expressions, hint);
  for (const std::size_t i : evaluation_order(inputs, c.expressions, parsed.needs)) {
    mu::Parser& parser = parsed.parsers[i];
    translating_errors(c.expressions[i].expression, [&] {
      for (std::size_t k = 0; k < inputs.size(); ++k) parser.DefineVar(inputs[k], &c.inputs[k]);
      for (std::size_t k = 0; k < c.expressions.size(); ++k)
        if (!c.expressions[k].name.empty()) parser.DefineVar(c.expressions[k].name, &c.results[k]);
      parser.Eval();
    });
    c.steps.push_back({parser, i});
    c.varies[i] = any_varies(parsed.needs[i], inputs, c.expressions, c.varies);
  }
}

ExpressionProgram::~ExpressionProgram() = default;
ExpressionProgram::ExpressionProgram(ExpressionProgram&&) noexcept = default;

const std::vector<double>& ExpressionProgram::evaluate(std::initializer_list<double> inputs) {
  std::copy(inputs.begin(), inputs.end(), compiled_->inputs.begin());
  for (Compiled::Step& step : compiled_->steps)
    compiled_->results[step.expression] = step.parser.Eval();
  return compiled_->results;
}

const NamedExpression& ExpressionProgram::expression(std::size_t i) const {
  return compiled_->expressions[i];
}

bool ExpressionProgram::depends_on_inputs(std::size_t i) const { return compiled_->varies[i]; }

std::string coordinates(Point p) { return fmt::format("(x, y) = ({:.9g}, {:.9g})", p.x, p.y); }

namespace {

ExpressionProgram program_of(const ExpressionText& text, const ExpressionNames& names) {
  std::vector<NamedExpression> all{{{}, text}};
  all.insert(all.end(), names.where.begin(), names.where.end());
  return ExpressionProgram({"x", "y"}, names.constants, std::move(all));
}

double finite(double value, const ExpressionText& at, const std::string& where) {
  if (std::isfinite(value)) return value;
  throw InputError(fmt::format("{} = \"{}\" is {}{}; it must be finite everywhere", at.place,
                               at.text, value, where));
}

}  // namespace

ScalarFunction scalar_function(const ExpressionText& text, const ExpressionNames& names) {
  const auto programs = std::make_shared<SharedProgram>([=] { return program_of(text, names); });
  return [programs, text](Point p) {
    const double value = programs->evaluate(p);
    return std::isfinite(value) ? value : finite(value, text, " at " + coordinates(p));
  };
}

std::optional<double> constant_value(const ExpressionText& text, const ExpressionNames& names) {
  ExpressionProgram program = program_of(text, names);
  if (program.depends_on_inputs(0)) return {};
  return finite(program.evaluate({0, 0}).front(), text, "");
}

Coefficient coefficient(const ExpressionText& text, const ExpressionNames& names) {
  if (const auto value = constant_value(text, names)) return *value;
  return scalar_function(text, names);
}

}  // namespace anisofront
