#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace anisofront::testing {

/// A folder of its own for one test, removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("anisofront-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name) << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// The message of the error that `action` throws, empty when it throws none.
template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Unit square, sizes 0.5, one cycle: a study that runs in milliseconds.
inline const char* const kTinyStudy = R"(title = "tiny"
[domain]
curves.around = { polyline = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]] }
regions.square = { boundary = ["around"] }
[mesh]
initial_size = 0.5
[metric]
prescribed = [{ h1 = "0.2 + 0.1*x", h2 = "h1" }]
[adapt]
cycles = 2
)";

}  // namespace anisofront::testing
