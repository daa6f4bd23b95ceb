#include "drivers/report/figure_label.hpp"

#include <algorithm>
#include <map>

namespace anisofront {
namespace {

std::vector<std::string> keys_of(const std::vector<Json>& settings) {
  std::vector<std::string> keys;
  for (const Json& one : settings)
    for (const auto& [key, value] : one.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

/// A setting in words: "isotropic", "triangles", "t = 0.01".
std::string setting_words(const std::string& key, const Json& value) {
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (key == "mesh.elements" && text != "mixed") return text + "s";
  if (key == "adapt.mode" || key == "mesh.elements") return text;
  return key.substr(key.rfind('.') + 1) + " = " + text;
}

/// Whether a setting differs between some that have the same label so far.
bool tells_apart(const std::string& key, const std::vector<Json>& settings,
                 const std::vector<std::string>& labels) {
  std::map<std::string, Json> first;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Json value = settings[i].value(key, Json());
    if (first.try_emplace(labels[i], value).first->second != value) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> distinguishing_labels(const std::vector<Json>& settings) {
  std::vector<std::string> labels(settings.size());
  for (const std::string& key : keys_of(settings)) {
    if (!tells_apart(key, settings, labels)) continue;
    for (std::size_t i = 0; i < settings.size(); ++i)
      if (settings[i].contains(key))
        labels[i] += (labels[i].empty() ? "" : ", ") + setting_words(key, settings[i].at(key));
  }
  return labels;
}

}  // namespace anisofront
