#include "drivers/study/toml_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "the text \"" + node.ref<std::string>() + "\"";
    case toml::node_type::integer:
      return "the number " + std::to_string(node.ref<int64_t>());
    case toml::node_type::floating_point:
      return fmt::format("the number {}", node.ref<double>());
    case toml::node_type::boolean:
      return node.ref<bool>() ? "true" : "false";
    default:
      return "a date or time";
  }
}

std::optional<double> finite_number(const toml::node& node) {
  if (!node.is_number()) return {};
  const double value = *node.value<double>();
  if (!std::isfinite(value)) return {};
  return value;
}

std::optional<Point> as_point(const toml::node& node) {
  const toml::array* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2) return {};
  const auto x = finite_number((*pair)[0]), y = finite_number((*pair)[1]);
  if (!x || !y) return {};
  return Point{*x, *y};
}

}  // namespace

TomlTable::TomlTable(const toml::table& table, std::string key, std::string file)
    : table_(&table), key_(std::move(key)), file_(std::move(file)) {}

const toml::node* TomlTable::find(const std::string& key) {
  if (!is_known(key)) known_.push_back(key);
  return table_->get(key);
}

bool TomlTable::has(const std::string& key) { return find(key) != nullptr; }

bool TomlTable::is_table(const std::string& key) {
  const toml::node* node = find(key);
  return node != nullptr && node->is_table();
}

bool TomlTable::is_boolean(const std::string& key) {
  const toml::node* node = find(key);
  return node != nullptr && node->is_boolean();
}

std::string TomlTable::full_key(const std::string& key) const {
  if (key.empty()) return key_;
  return key_.empty() ? key : key_ + "." + key;
}

std::string TomlTable::place(const std::string& key) const {
  const toml::node* node = key.empty() ? nullptr : table_->get(key);
  const toml::source_position at = (node != nullptr ? node : table_)->source().begin;
  // Values from --set and [vary] have no line of their own.
  const std::string line = at.line > 0 ? fmt::format(":{}:{}", at.line, at.column) : "";
  return fmt::format("{}{}: {}", file_, line, full_key(key));
}

void TomlTable::fail(const std::string& key, const std::string& what) const {
  throw UsageError(place(key) + ": " + what);
}

void TomlTable::fail_missing(const std::string& key) const {
  for (const auto& [found, node] : *table_)  // misspelt rather than missing?
    if (!is_known(found.str()) && nearest_name(found.str(), {key}) == key)
      fail_unknown(found, name_proposal(found.str(), {key}));
  throw UsageError(fmt::format("{}: the key \"{}\" is missing", place(), full_key(key)));
}

bool TomlTable::is_known(std::string_view key) const {
  return std::find(known_.begin(), known_.end(), key) != known_.end();
}

void TomlTable::fail_unknown(const toml::key& key, const std::string& proposal) const {
  const toml::source_position at = key.source().begin;
  const std::string line = at.line > 0 ? fmt::format(":{}:{}", at.line, at.column) : "";
  throw UsageError(fmt::format("{}{}: unknown key \"{}\"{}", file_, line,
                               full_key(std::string(key.str())), proposal));
}

std::optional<std::string> TomlTable::text(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (!node->is_string()) fail(key, "expected a text in quotes, found " + type_name(*node));
  return node->value<std::string>();
}

std::optional<double> TomlTable::number(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const auto value = finite_number(*node);
  if (!value) fail(key, "expected a finite number, found " + type_name(*node));
  return value;
}

std::optional<double> TomlTable::positive(const std::string& key) {
  const auto value = number(key);
  if (value && *value <= 0) fail(key, fmt::format("must be positive, found {}", *value));
  return value;
}

std::optional<Index> TomlTable::integer(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const auto value = node->is_integer() ? node->value<int64_t>() : std::nullopt;
  if (!value || *value < 0 || *value > 2'000'000'000)
    fail(key, "expected a whole number, 0 to 2000000000, found " + type_name(*node));
  return static_cast<Index>(*value);
}

std::optional<Point> TomlTable::point(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const auto p = as_point(*node);
  if (!p) fail(key, "expected a point [x, y], found " + type_name(*node));
  return p;
}

const toml::array* TomlTable::array(const std::string& key, const char* expected) {
  const toml::node* node = find(key);
  if (node == nullptr) return nullptr;
  if (!node->is_array())
    fail(key, fmt::format("expected a list of {}, found {}", expected, type_name(*node)));
  return node->as_array();
}

std::vector<Point> TomlTable::points(const std::string& key) {
  std::vector<Point> list;
  const toml::array* values = array(key, "points [[x, y], ...]");
  if (values == nullptr) return list;
  for (const toml::node& node : *values) {
    const auto p = as_point(node);
    if (!p)
      fail(key, fmt::format("point {} of the list: expected [x, y] with finite numbers, found {}",
                            list.size() + 1, type_name(node)));
    list.push_back(*p);
  }
  return list;
}

std::vector<double> TomlTable::numbers(const std::string& key) {
  std::vector<double> list;
  const toml::array* values = array(key, "numbers");
  if (values == nullptr) return list;
  for (const toml::node& node : *values) {
    const auto value = finite_number(node);
    if (!value) fail(key, "expected finite numbers, found " + type_name(node));
    list.push_back(*value);
  }
  return list;
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  std::vector<std::string> list;
  const toml::array* values = array(key, "texts");
  if (values == nullptr) return list;
  for (const toml::node& node : *values) {
    if (!node.is_string()) fail(key, "expected texts in quotes, found " + type_name(node));
    list.push_back(*node.value<std::string>());
  }
  return list;
}

std::vector<std::vector<std::string>> TomlTable::lists_of_texts(const std::string& key) {
  std::vector<std::vector<std::string>> lists;
  const toml::array* values = array(key, "lists of texts [[\"...\"], ...]");
  if (values == nullptr) return lists;
  for (const toml::node& node : *values) {
    if (!node.is_array())
      fail(key, "expected a list of lists such as [[\"hole\"]], found " + type_name(node));
    lists.emplace_back();
    for (const toml::node& item : *node.as_array()) {
      if (!item.is_string()) fail(key, "expected texts in quotes, found " + type_name(item));
      lists.back().push_back(*item.value<std::string>());
    }
  }
  return lists;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (!node->is_table()) fail(key, "expected a table, found " + type_name(*node));
  return TomlTable(*node->as_table(), full_key(key), file_);
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  std::vector<TomlTable> list;
  const toml::array* values = array(key, "tables [{ ... }, ...]");
  if (values == nullptr) return list;
  for (const toml::node& node : *values) {
    if (!node.is_table()) fail(key, "expected tables { ... }, found " + type_name(node));
    list.emplace_back(*node.as_table(), fmt::format("{}[{}]", full_key(key), list.size()), file_);
  }
  return list;
}

std::optional<ExpressionText> TomlTable::expression(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (const auto value = finite_number(*node))
    return ExpressionText{fmt::format("{}", *value), place(key)};
  if (!node->is_string())
    fail(key, "expected an expression in quotes or a number, found " + type_name(*node));
  return ExpressionText{*node->value<std::string>(), place(key)};
}

std::vector<ExpressionText> TomlTable::expressions(const std::string& key) {
  std::vector<ExpressionText> list;
  const toml::array* values = array(key, "expressions or numbers");
  if (values == nullptr) return list;
  for (const toml::node& node : *values) {
    const auto number = finite_number(node);
    if (!number && !node.is_string())
      fail(key, "expected expressions in quotes or numbers, found " + type_name(node));
    list.push_back({number ? fmt::format("{}", *number) : *node.value<std::string>(),
                    fmt::format("{}[{}]", place(key), list.size())});
  }
  return list;
}

std::optional<bool> TomlTable::boolean(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (!node->is_boolean()) fail(key, "expected true or false, found " + type_name(*node));
  return node->value<bool>();
}

std::string TomlTable::choice(const std::string& key, const std::vector<std::string>& choices,
                              const std::string& fallback) {
  const std::string value = text(key).value_or(fallback);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  fail(key, fmt::format("found \"{}\", expected one of: {}{}", value, joined(choices),
                        nearest_name(value, choices).empty() ? "" : name_proposal(value, choices)));
}

std::vector<std::string> TomlTable::keys() {
  std::vector<std::string> names;
  for (const auto& [key, node] : *table_) names.emplace_back(key.str());
  const auto position = [this](const std::string& name) {
    const toml::source_position at = table_->get(name)->source().begin;
    return std::make_tuple(at.line, at.column);
  };
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return position(a) < position(b);
  });
  known_.insert(known_.end(), names.begin(), names.end());
  return names;
}

void TomlTable::finish() const {
  for (const auto& [key, node] : *table_)
    if (!is_known(key.str())) fail_unknown(key, name_proposal(key.str(), known_));
}

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw UsageError(
        fmt::format("{}:{}:{}: not valid TOML: {}", file, at.line, at.column, error.description()));
  }
}

}  // namespace anisofront
