#include "drivers/study_file.hpp"

#include <algorithm>
#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxStudyBytes = 16u << 20;
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

void apply(toml::table& root, const Override& change, const std::string& file) {
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

/// Erases the key and those below it: "adapt.target" takes "adapt.target.nodes" along.
void erase_within(toml::table& vary, const std::string& key) {
  std::vector<std::string> gone;
  for (const auto& [name, value] : vary)
    if (name.str() == key || name.str().substr(0, key.size() + 1) == key + ".")
      gone.emplace_back(name.str());
  for (const std::string& name : gone) vary.erase(name);
}

/// A value from the command line holds in all variants: its key varies no longer.
void stop_varying(toml::table& root, const std::vector<Override>& overrides) {
  if (toml::table* vary = root.get_as<toml::table>("vary"))
    for (const Override& change : overrides) erase_within(*vary, change.key);
}

toml::table parse_with(const std::string& text, const std::string& file,
                       const std::vector<Override>& changes) {
  toml::table root = parse_toml(text, file);
  for (const Override& change : changes) apply(root, change, file);
  return root;
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

struct VaryEntry {
  std::string key;
  std::vector<Override> values;
  std::vector<std::string> names;
};

VaryEntry vary_entry(const TomlTable& table, const toml::table& vary, const std::string& key) {
  VaryEntry entry{key, {}, {}};
  const toml::array* values = vary.get(key)->as_array();
  if (values == nullptr || values->empty())
    table.fail(key,
               "expected a list of values, one per variant, and \"quotes\" around a key with dots");
  for (const toml::node& value : *values) {
    entry.values.push_back({key, as_toml(value), "[vary]"});
    entry.names.push_back(as_name(value));
    if (std::count(entry.names.begin(), entry.names.end(), entry.names.back()) > 1)
      table.fail(key, fmt::format("the value {} stands there twice", entry.values.back().value));
  }
  return entry;
}

std::vector<VaryEntry> vary_entries(const toml::table& root, const std::string& file) {
  std::vector<VaryEntry> entries;
  const toml::table* vary = root.get_as<toml::table>("vary");
  if (vary == nullptr) return entries;
  TomlTable table(*vary, "vary", file);
  for (const std::string& key : table.keys()) entries.push_back(vary_entry(table, *vary, key));
  std::size_t count = 1;
  for (const VaryEntry& entry : entries) count *= std::min(entry.values.size(), kMaxVariants + 1);
  if (count > kMaxVariants) table.fail({}, fmt::format("more than {} combinations", kMaxVariants));
  return entries;
}

/// The cartesian product, the last entry varying fastest.
std::vector<Variant> combinations(const std::vector<VaryEntry>& entries) {
  std::vector<Variant> variants(1);
  for (const VaryEntry& entry : entries) {
    std::vector<Variant> longer;
    for (const Variant& variant : variants)
      for (std::size_t i = 0; i < entry.values.size(); ++i) {
        longer.push_back(variant);
        longer.back().values.push_back(entry.values[i]);
        longer.back().name += (variant.name.empty() ? "" : "-") + entry.names[i];
      }
    variants = std::move(longer);
  }
  if (entries.empty()) variants.front().name = "main";
  return variants;
}

std::string overridden_by(const std::vector<Override>& changes) {
  std::vector<std::string> texts;
  for (const Override& change : changes)
    texts.push_back(change.origin + " " + change.key + " = " + change.value);
  return joined(texts);
}

/// Errors in values without a line say which override they come from.
Study parse_variant(const std::string& text, const fs::path& path,
                    const std::vector<Override>& changes) {
  const toml::table root = parse_with(text, path.string(), changes);
  try {
    return parse_study(root, path);
  } catch (const Error& error) {
    if (changes.empty()) throw;
    throw Error(error.kind(), fmt::format("{}\n  (with {})", error.what(), overridden_by(changes)));
  }
}

void make_absolute(toml::table& root, const char* section, const char* key, const fs::path& study) {
  toml::table* table = root.get_as<toml::table>(section);
  if (table == nullptr) return;
  if (const auto name = (*table)[key].value<std::string>())
    table->insert_or_assign(key,
                            fs::absolute(study.parent_path() / *name).lexically_normal().string());
}

std::string resolved_text(toml::table root, const fs::path& path) {
  make_absolute(root, "domain", "mesh", path);
  make_absolute(root, "mesh", "initial", path);
  std::ostringstream stream;
  stream << toml::toml_formatter{root} << '\n';
  return stream.str();
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

StudyFile read_study_file(const fs::path& path, const std::vector<Override>& overrides) {
  const std::string text = read_text_file(path, kMaxStudyBytes);
  toml::table root = parse_with(text, path.string(), overrides);
  stop_varying(root, overrides);
  StudyFile file;
  file.path = path;
  file.variants = combinations(vary_entries(root, path.string()));
  for (Variant& variant : file.variants) {
    std::vector<Override> changes = overrides;
    changes.insert(changes.end(), variant.values.begin(), variant.values.end());
    variant.study = parse_variant(text, path, changes);
  }
  file.title = file.variants.front().study.title;
  file.resolved = resolved_text(std::move(root), path);
  return file;
}

}  // namespace anisofront
