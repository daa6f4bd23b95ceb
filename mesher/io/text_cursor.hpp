#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// Reads numbers and words from text in memory, with every access checked against its end.
/// Blanks, line ends and comments (# to the end of the line) separate them. Lines are counted only
/// when an error occurs: messages start with "NAME:LINE: ". All failures are InputErrors.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::string name)
      : begin_(text.data()), next_(begin_), end_(begin_ + text.size()), name_(std::move(name)) {}

  /// True when only blanks and comments are left.
  bool at_end() {
    skip_blanks();
    return next_ == end_;
  }
  /// The next word, without moving; empty at the end of the text.
  std::string_view peek();

  std::string_view word(const char* what);
  std::int64_t integer(const char* what);
  Index index(const char* what);
  double real(const char* what);
  /// A number that is neither infinite nor NaN.
  double finite_real(const char* what);
  /// A number of things of at least `least_bytes` bytes each: what follows must be long enough for
  /// them and they must be countable by an Index, so that a garbled count allocates nothing.
  Index count(const char* what, std::size_t least_bytes);
  /// Text between double quotes.
  std::string_view quoted(const char* what);
  void expect(std::string_view word);

  // Byte-wise access, for binary sections.
  std::size_t offset() const { return static_cast<std::size_t>(next_ - begin_); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - next_); }
  void move_to(std::size_t offset) { next_ = begin_ + offset; }
  std::string_view rest() const { return {next_, remaining()}; }
  /// Moves behind the end of the current line.
  void skip_line();

  const std::string& name() const { return name_; }
  /// From now on messages name bytes ("NAME: byte OFFSET: ") instead of lines.
  void locate_by_bytes() { by_bytes_ = true; }
  /// Throws InputError "NAME:LINE: message" for the current position, or for that of a byte.
  [[noreturn]] void fail(const std::string& message) const { fail_at(offset(), message); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& message) const;
  [[noreturn]] void fail_expected(const char* what);

 private:
  void skip_blanks() {
    while (next_ < end_ && static_cast<unsigned char>(*next_) <= ' ') ++next_;
    if (next_ < end_ && *next_ == '#') skip_comments();
  }
  void skip_comments();
  bool at_digit() const { return next_ < end_ && static_cast<unsigned>(*next_ - '0') < 10; }
  bool at_separator() const { return next_ == end_ || static_cast<unsigned char>(*next_) <= ' '; }

  const char* begin_;
  const char* next_;
  const char* end_;
  std::string name_;
  bool by_bytes_ = false;
};

}  // namespace anisofront
