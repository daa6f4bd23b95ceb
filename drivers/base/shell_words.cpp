#include "drivers/base/shell_words.hpp"

#include "drivers/base/text.hpp"

namespace anisofront {

std::string shell_quoted(const std::string& word) {
  // POSIX.1-2017, Shell Command Language, 2.2: everything else may mean something to a shell.
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string shell_line(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(shell_quoted(word));
  return joined(quoted, " ");
}

}  // namespace anisofront
