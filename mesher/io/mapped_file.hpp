#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace anisofront {

/// The bytes of a whole file: mapped into memory, or read when it is not a regular file (a pipe).
class MappedFile {
 public:
  /// Throws UsageError when there is no such file and InputError when it cannot be read.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }

 private:
  void* mapping_ = nullptr;
  std::string contents_;
  std::string_view bytes_;
};

}  // namespace anisofront
