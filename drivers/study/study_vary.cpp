#include "drivers/study/study_vary.hpp"

#include <algorithm>
#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/study/toml_table.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

constexpr std::size_t kMaxVariants = 1000;

std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> parts;
  std::istringstream stream(key);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

/// `v = value` as TOML, or the bare word as a text.
toml::table parse_value(const std::string& value) {
  try {
    return toml::parse("v = " + value);
  } catch (const toml::parse_error&) {
    return toml::table{{"v", value}};
  }
}

/// vary.NAME = "alternative": of a [vary] entry with named alternatives only this one is run.
/// False when the override is none of that kind.
bool choose_alternative(toml::table& root, const Override& change, const std::string& file) {
  const std::vector<std::string> parts = split_key(change.key);
  if (parts.size() != 2 || parts[0] != "vary") return false;
  const toml::node_view entry = root["vary"][parts[1]];
  const toml::table value = parse_value(change.value);
  if (!entry.is_table() || !value["v"].is_string()) return false;
  const std::string name = *value["v"].value<std::string>();
  std::vector<std::string> known;
  for (const auto& [key, node] : *entry.as_table()) known.emplace_back(key.str());
  if (!entry.as_table()->contains(name))
    throw UsageError(fmt::format("{}: {} {}: no alternative is called \"{}\"{}", file,
                                 change.origin, change.key, name, name_proposal(name, known)));
  for (const std::string& other : known)
    if (other != name) entry.as_table()->erase(other);
  return true;
}

/// Erases the key and those below it: "adapt.target" takes "adapt.target.nodes" along; and tables
/// that become empty. Keys of nested tables are joined by dots.
void erase_within(toml::table& table, const std::string& prefix, const std::string& key) {
  std::vector<std::string> gone;
  for (auto&& [name, node] : table) {
    const std::string full = prefix + std::string(name.str());
    toml::table* below = node.as_table();
    if (below != nullptr) erase_within(*below, full + ".", key);
    if (full == key || full.starts_with(key + ".") || (below != nullptr && below->empty()))
      gone.emplace_back(name.str());
  }
  for (const std::string& name : gone) table.erase(name);
}

/// The same in all named alternatives of an entry; true when nothing is left in any of them.
bool erase_in_alternatives(toml::table& entry, const std::string& key) {
  bool is_empty = true;
  for (auto&& [name, alternative] : entry) {
    if (!alternative.is_table()) return false;
    erase_within(*alternative.as_table(), {}, key);
    is_empty = is_empty && alternative.as_table()->empty();
  }
  return is_empty;
}

/// Numbers as short as they can be: 0.1, not 0.10000000000000001.
std::string as_toml(const toml::node& node) {
  if (node.is_floating_point()) {
    const std::string text = fmt::format("{}", *node.value<double>());
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
  }
  std::ostringstream stream;
  node.visit([&](const auto& value) { stream << value; });
  return stream.str();
}

/// Value as a part of a folder name: letters, digits and dots, the rest becomes "_".
std::string as_name(const toml::node& node) {
  std::string name = node.is_string() ? *node.value<std::string>() : as_toml(node);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '+')
      c = '_';
  return name;
}

/// The alternatives that one key of [vary] offers.
using VaryEntry = std::vector<VariantChanges>;

void add_alternative(const TomlTable& table, const std::string& key, VariantChanges next,
                     VaryEntry& entry) {
  for (const VariantChanges& earlier : entry)
    if (earlier.name == next.name) table.fail(key, fmt::format("{} stands there twice", next.name));
  entry.push_back(std::move(next));
}

/// key = [value, value, ...]
VaryEntry listed_values(const TomlTable& table, const toml::array& values, const std::string& key) {
  VaryEntry entry;
  for (const toml::node& value : values)
    add_alternative(table, key, {as_name(value), {{key, as_toml(value), "[vary]"}}}, entry);
  return entry;
}

/// Values of a table and those below it, their full keys joined by dots.
void add_values(const toml::table& table, const std::string& prefix,
                std::vector<Override>& values) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    if (const toml::table* below = node.as_table())
      add_values(*below, key + ".", values);
    else
      values.push_back({key, as_toml(node), "[vary]"});
  }
}

/// ANY = { name = { keys with their values }, ... }
VaryEntry named_alternatives(TomlTable table, const toml::table& alternatives) {
  VaryEntry entry;
  for (const std::string& name : table.keys()) {
    const toml::table* values = alternatives.get_as<toml::table>(name);
    if (values == nullptr)
      table.fail(name,
                 "expected a table of the keys that this alternative sets; where a list of values "
                 "is meant, a key with dots needs \"quotes\"");
    VariantChanges next{as_name(toml::value<std::string>(name)), {}};
    add_values(*values, {}, next.values);
    add_alternative(table, name, std::move(next), entry);
  }
  return entry;
}

VaryEntry vary_entry(TomlTable& table, const toml::table& vary, const std::string& key) {
  VaryEntry entry;
  if (const toml::array* values = vary.get_as<toml::array>(key))
    entry = listed_values(table, *values, key);
  else if (const toml::table* alternatives = vary.get_as<toml::table>(key))
    entry = named_alternatives(*table.table(key), *alternatives);
  if (entry.empty())
    table.fail(key,
               "expected a list of values, one per variant, or a table of alternatives; a key with "
               "dots needs \"quotes\"");
  return entry;
}

std::vector<VaryEntry> vary_entries(const toml::table& root, const std::string& file) {
  std::vector<VaryEntry> entries;
  const toml::table* vary = root.get_as<toml::table>("vary");
  if (vary == nullptr) return entries;
  TomlTable table(*vary, "vary", file);
  for (const std::string& key : table.keys()) entries.push_back(vary_entry(table, *vary, key));
  std::size_t count = 1;
  for (const VaryEntry& entry : entries) count *= std::min(entry.size(), kMaxVariants + 1);
  if (count > kMaxVariants) table.fail({}, fmt::format("more than {} combinations", kMaxVariants));
  return entries;
}

}  // namespace

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const std::vector<std::string> parts = split_key(key);
  const bool has_gap = parts.empty() || key.back() == '.' ||
                       std::find(parts.begin(), parts.end(), "") != parts.end();
  if (equals == std::string::npos || has_gap)
    throw UsageError("--set " + text + ": expected key=value such as mesh.preset=paper");
  return {key, text.substr(equals + 1), "--set"};
}

std::vector<Override> parse_overrides(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) overrides.push_back(parse_override(text));
  return overrides;
}

void apply_override(toml::table& root, const Override& change, const std::string& file) {
  if (choose_alternative(root, change, file)) return;
  toml::table* table = &root;
  const std::vector<std::string> parts = split_key(change.key);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    toml::node* node = table->get(parts[i]);
    if (node == nullptr) node = &table->insert(parts[i], toml::table{}).first->second;
    if (!node->is_table())
      throw UsageError(fmt::format("{}: {} {}: \"{}\" is not a table", file, change.origin,
                                   change.key, parts[i]));
    table = node->as_table();
  }
  toml::table value = parse_value(change.value);
  table->insert_or_assign(parts.back(), std::move(*value.get("v")));
}

void stop_varying(toml::table& root, const std::vector<Override>& overrides) {
  toml::table* vary = root.get_as<toml::table>("vary");
  if (vary == nullptr) return;
  for (const Override& change : overrides) {
    std::vector<std::string> gone;
    for (auto&& [name, entry] : *vary) {
      const std::string key(name.str());
      const bool is_named = entry.is_table();
      if (is_named ? erase_in_alternatives(*entry.as_table(), change.key)
                   : key == change.key || key.starts_with(change.key + "."))
        gone.push_back(key);
    }
    for (const std::string& key : gone) vary->erase(key);
  }
}

std::vector<VariantChanges> variant_changes(const toml::table& root, const std::string& file) {
  std::vector<VariantChanges> variants(1);
  for (const VaryEntry& entry : vary_entries(root, file)) {
    std::vector<VariantChanges> longer;
    for (const VariantChanges& variant : variants)
      for (const VariantChanges& alternative : entry) {
        longer.push_back(variant);
        longer.back().name += (variant.name.empty() ? "" : "-") + alternative.name;
        longer.back().values.insert(longer.back().values.end(), alternative.values.begin(),
                                    alternative.values.end());
      }
    variants = std::move(longer);
  }
  return variants;
}

}  // namespace anisofront
