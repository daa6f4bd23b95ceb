#include "drivers/report/figure_text.hpp"

#include <algorithm>
#include <cctype>

namespace anisofront {
namespace {

constexpr double kCharacter = 0.145;  // cm, DejaVu Sans of 8 pt on average

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }

bool is_plain(char c) {
  return static_cast<unsigned char>(c) < 0x80 && std::isalnum(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return line;
}

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (const char c : one_line(text)) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string shortened(const std::string& text, std::size_t most) {
  if (character_count(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t characters = 0; characters < most; ++end)
    if (starts_character(text[end])) ++characters;
  return text.substr(0, end - 1) + "…";
}

std::string file_stem(std::string_view name) {
  constexpr std::size_t kMost = 100;
  std::string stem(name.substr(0, kMost));
  for (char& c : stem)
    if (!is_plain(c) && c != '.' && c != '-') c = '_';
  const bool is_fit = !stem.empty() && is_plain(stem.front());
  return is_fit ? stem : "_" + stem;
}

double text_width(std::string_view text) {
  return kCharacter * static_cast<double>(character_count(text));
}

LegendLayout legend_layout(const std::vector<std::string>& labels, double width) {
  constexpr double kSample = 1;  // cm, of a line before its label
  if (labels.empty()) return {};
  double longest = 0;
  for (const std::string& label : labels) longest = std::max(longest, text_width(label));
  const auto fitting = static_cast<std::size_t>(std::max(width / (longest + kSample), 1.0));
  const std::size_t columns = std::min(fitting, labels.size());
  const double surplus = std::max(0., 0.2 * (longest / kCharacter - 6));
  return {(labels.size() + columns - 1) / columns, surplus};
}

}  // namespace anisofront
