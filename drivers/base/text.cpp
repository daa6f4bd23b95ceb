#include "drivers/base/text.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include "mesher/geometry/error.hpp"
#include "mesher/io/atomic_file.hpp"

namespace anisofront {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({replaced, d[i - 1][j] + 1, d[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongestWord = 64;
  if (name.size() > kLongestWord) return {};
  std::string best;
  int best_distance = std::max(2, static_cast<int>(name.size()) / 3) + 1;
  for (const std::string& candidate : known) {
    const int distance = edit_distance(name, candidate);
    if (distance >= best_distance || distance >= static_cast<int>(candidate.size())) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

std::string name_proposal(std::string_view name, const std::vector<std::string>& known) {
  if (known.empty()) return {};
  const std::string nearest = nearest_name(name, known);
  if (nearest.empty()) return "; known: " + joined(known);
  return "; did you mean \"" + nearest + "\"?";
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw UsageError(path.string() + ": no such file");
  if (std::filesystem::file_size(path, error) > max_bytes)
    throw InputError(path.string() + ": larger than " + std::to_string(max_bytes) +
                     " bytes, which no file of this kind needs; is it the right one?");
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw UsageError(path.string() + ": cannot be read; check its permissions");
  return content.str();
}

void write_text_file(const std::filesystem::path& path, std::string_view content) {
  AtomicFile file(path);
  file.text(content);
  file.commit();
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw InputError(path.string() + ": cannot create this folder: " + error.message());
}

}  // namespace anisofront
