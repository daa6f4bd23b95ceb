#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "mesher/io/text_cursor.hpp"

namespace anisofront {

/// The numbers of a .msh file, ASCII or binary: after set_binary() the numeric functions read
/// native binary values, so that one parser serves both. Section headers are text in either case.
/// Failures are InputErrors that start with "NAME:LINE: " or "NAME: byte OFFSET: ".
class GmshStream {
 public:
  GmshStream(std::string_view bytes, const std::string& name) : text(bytes, name) {}

  TextCursor text;

  void set_binary(bool swap_bytes) {
    binary_ = true;
    text.locate_by_bytes();
    swap_ = swap_bytes;
  }
  bool binary() const { return binary_; }

  /// Offset of the next number, for messages about it.
  std::size_t next_offset() {
    if (!binary_) text.at_end();
    return text.offset();
  }

  /// A 4-byte integer.
  Index integer(const char* what) { return binary_ ? raw<Index>(what) : text.index(what); }
  /// An 8-byte number of something (format 4.1); not negative.
  std::int64_t size(const char* what);
  double real(const char* what) { return binary_ ? raw<double>(what) : text.real(what); }

  /// Fails unless `found` things fit into the rest of the file, each of at least `numbers` numbers
  /// in ASCII or `bytes` bytes in binary; call it right after reading `found`.
  std::size_t checked_count(const char* what, std::int64_t found, std::size_t numbers,
                            std::size_t bytes) const;

  /// Throws InputError at the current position, or at an earlier offset().
  [[noreturn]] void fail(const std::string& message) const { fail_at(text.offset(), message); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& message) const {
    text.fail_at(offset, message);
  }

 private:
  template <class Number>
  Number raw(const char* what);

  bool binary_ = false;
  bool swap_ = false;
};

template <class Number>
Number GmshStream::raw(const char* what) {
  std::array<char, sizeof(Number)> bytes;
  if (text.remaining() < bytes.size())
    fail("expected " + std::string(what) + ", found the end of the file");
  std::memcpy(bytes.data(), text.rest().data(), bytes.size());
  if (swap_) std::reverse(bytes.begin(), bytes.end());
  text.move_to(text.offset() + bytes.size());
  return std::bit_cast<Number>(bytes);
}

}  // namespace anisofront
