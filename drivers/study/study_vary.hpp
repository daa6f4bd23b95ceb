#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

namespace anisofront {

/// One value put in place of what a study file says: a dotted key and a value in TOML syntax.
struct Override {
  std::string key;
  std::string value;
  std::string origin;  ///< "--set" or "[vary]", for messages
};

/// Parses "key=value". Throws UsageError without "=" or with an empty key.
Override parse_override(const std::string& text);
std::vector<Override> parse_overrides(const std::vector<std::string>& texts);

/// Puts the value into the study. vary.NAME = "alternative" leaves only this one of a [vary] entry
/// with named alternatives. Throws UsageError when the key leads through something that is not a
/// table, and for an unknown alternative.
void apply_override(toml::table& root, const Override& change, const std::string& file);

/// A value from the command line holds in all variants: takes its key (and those below it) out of
/// [vary], also out of named alternatives.
void stop_varying(toml::table& root, const std::vector<Override>& overrides);

/// What one variant changes.
struct VariantChanges {
  std::string name;  ///< usable as a folder name; empty when nothing varies
  std::vector<Override> values;
};

/// The cartesian product of the entries of [vary], in the order of the file, the last entry varying
/// fastest. An entry is a list of values of one key ("adapt.mode" = [...]), or a table of named
/// alternatives, each of which sets the keys it holds (supports = { clamped = { ... }, ... }).
/// Throws UsageError with file:line:column.
std::vector<VariantChanges> variant_changes(const toml::table& root, const std::string& file);

}  // namespace anisofront
