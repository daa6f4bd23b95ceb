#pragma once

#include <string>

#include <doctest/doctest.h>

#include "drivers/study/study_file.hpp"
#include "tests/drivers/temporary_folder.hpp"

namespace anisofront::testing {

/// Unit square of the curves bottom, right, top, left and the region "square"; the table [problem]
/// starts on line 11.
inline std::string square_study(const std::string& problem, const std::string& rest = "",
                                const std::string& mesh = "initial_size = 0.25") {
  return R"(title = "square"
[domain]
curves.bottom = { line = [[0, 0], [1, 0]] }
curves.right = { line = [[1, 0], [1, 1]] }
curves.top = { line = [[1, 1], [0, 1]] }
curves.left = { line = [[0, 1], [0, 0]] }
regions.square = { boundary = ["bottom", "right", "top", "left"] }
[mesh]
)" + mesh +
         "\n\n[problem]\n" + problem + "\n" + rest;
}

inline Study parse_text(const std::string& text) {
  return parse_study(toml::parse(text), "s.toml");
}

/// The message of the UsageError that parsing the study throws.
inline std::string parse_failure(const std::string& text) {
  return message_of<UsageError>([&] { parse_text(text); });
}

}  // namespace anisofront::testing
