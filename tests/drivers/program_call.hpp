#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "drivers/base/text.hpp"
#include "drivers/commands/program.hpp"
#include "drivers/history/history_json.hpp"

namespace anisofront::testing {

/// What the program did with its arguments.
struct Result {
  int code;
  std::string out, err;
};

inline Result call(std::vector<std::string> words) {
  words.insert(words.begin(), "anisofront");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  std::ostringstream out, err;
  const int code = run_program(static_cast<int>(arguments.size()), arguments.data(), out, err);
  return {code, out.str(), err.str()};
}

inline Json read_json(const std::filesystem::path& path) {
  return Json::parse(read_text_file(path));
}

}  // namespace anisofront::testing
