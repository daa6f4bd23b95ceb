#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "drivers/study/expression.hpp"
#include "mesher/geometry/point.hpp"

namespace anisofront {

/// A table of a study file that knows which of its keys were asked for, so that finish() can refuse
/// the others. All functions throw UsageError with file:line:column, the full key, what was found
/// and what was expected. The toml::table must outlive the reader.
class TomlTable {
 public:
  /// `key`: full name of the table ("" for the file itself); `file`: starts every message.
  TomlTable(const toml::table& table, std::string key, std::string file);

  bool has(const std::string& key);
  bool is_table(const std::string& key);
  bool is_boolean(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::optional<double> number(const std::string& key);
  std::optional<double> positive(const std::string& key);
  std::optional<Index> integer(const std::string& key);
  std::optional<Point> point(const std::string& key);
  std::vector<Point> points(const std::string& key);
  std::vector<double> numbers(const std::string& key);
  std::vector<std::string> texts(const std::string& key);
  std::vector<std::vector<std::string>> lists_of_texts(const std::string& key);
  std::optional<TomlTable> table(const std::string& key);
  std::vector<TomlTable> tables(const std::string& key);
  /// A string or a number.
  std::optional<ExpressionText> expression(const std::string& key);
  /// A list of strings and numbers.
  std::vector<ExpressionText> expressions(const std::string& key);
  std::optional<bool> boolean(const std::string& key);
  /// One of `choices`; `fallback` when the key is absent.
  std::string choice(const std::string& key, const std::vector<std::string>& choices,
                     const std::string& fallback);

  /// All keys, in the order of the file; they count as known.
  std::vector<std::string> keys();

  /// Throws when a required value is missing.
  template <class Value>
  Value required(std::optional<Value> value, const std::string& key) const {
    if (!value) fail_missing(key);
    return *std::move(value);
  }

  /// Refuses keys nobody asked for and proposes the nearest known one.
  void finish() const;

  /// "file:line:column: full.key" of an entry, or of the table when there is no such entry.
  std::string place(const std::string& key = {}) const;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  const toml::node* find(const std::string& key);
  const toml::array* array(const std::string& key, const char* expected);
  bool is_known(std::string_view key) const;
  [[noreturn]] void fail_missing(const std::string& key) const;
  [[noreturn]] void fail_unknown(const toml::key& key, const std::string& proposal) const;
  std::string full_key(const std::string& key) const;

  const toml::table* table_;
  std::string key_;
  std::string file_;
  std::vector<std::string> known_;
};

/// Parses TOML text. Throws UsageError with file:line:column.
toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace anisofront
