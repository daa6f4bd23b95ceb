#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace anisofront {

/// Buffered output that appears under its name only when it is complete: it is written under a
/// temporary name in the same directory and renamed by commit(). Without commit() (an exception,
/// say) it is removed and the old file stays. Devices and pipes are written directly.
/// All functions throw InputError "cannot write NAME: reason".
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void text(std::string_view bytes);
  void byte(char c) { *room(1) = c, ++used_; }
  void integer(std::int64_t value) { used_ = to_chars(value); }
  /// The shortest decimal number that reads back to the same bits.
  void real(double value) { used_ = to_chars(value); }

  /// Gives the file its name.
  void commit();

 private:
  static constexpr std::size_t kCapacity = 1 << 20;
  static constexpr std::size_t kLongestNumber = 32;

  char* room(std::size_t n) {
    if (kCapacity - used_ < n) flush();
    return buffer_.data() + used_;
  }
  template <class Number>
  std::size_t to_chars(Number value) {
    char* begin = room(kLongestNumber);
    return static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr -
                                    buffer_.data());
  }
  void flush();
  void write_fully(std::string_view bytes);
  [[noreturn]] void fail() const;

  std::filesystem::path path_;       ///< the final name, symbolic links resolved
  std::filesystem::path temporary_;  ///< empty when written directly or committed
  int descriptor_ = -1;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace anisofront
