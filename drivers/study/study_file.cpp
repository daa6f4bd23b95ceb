#include "drivers/study/study_file.hpp"

#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxStudyBytes = 16u << 20;

toml::table parse_with(const std::string& text, const std::string& file,
                       const std::vector<Override>& changes) {
  toml::table root = parse_toml(text, file);
  for (const Override& change : changes) apply_override(root, change, file);
  return root;
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
  change_reference_files(root, [&](const std::string& name) {
    return fs::absolute(beside_study(path, name)).string();
  });
  std::ostringstream stream;
  stream << toml::toml_formatter{root} << '\n';
  return stream.str();
}

}  // namespace

StudyFile read_study_file(const fs::path& path, const std::vector<Override>& overrides) {
  const std::string text = read_text_file(path, kMaxStudyBytes);
  toml::table root = parse_with(text, path.string(), overrides);
  stop_varying(root, overrides);
  StudyFile file;
  file.path = path;
  for (const VariantChanges& variant : variant_changes(root, path.string())) {
    std::vector<Override> changes = overrides;
    changes.insert(changes.end(), variant.values.begin(), variant.values.end());
    file.variants.push_back({variant.name.empty() ? "main" : variant.name, variant.values,
                             parse_variant(text, path, changes)});
  }
  file.title = file.variants.front().study.title;
  file.resolved = resolved_text(std::move(root), path);
  return file;
}

}  // namespace anisofront
