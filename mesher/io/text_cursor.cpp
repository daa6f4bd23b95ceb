#include "mesher/io/text_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "mesher/geometry/error.hpp"

namespace anisofront {

namespace {

/// A word as it is quoted in messages: short and printable.
std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c >= 127; }, '?');
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

}  // namespace

std::string_view TextCursor::peek() {
  skip_blanks();
  const char* last = next_;
  while (last<end_&& static_cast<unsigned char>(*last)> ' ') ++last;
  return {next_, static_cast<std::size_t>(last - next_)};
}

std::string_view TextCursor::word(const char* what) {
  const std::string_view found = peek();
  if (found.empty()) fail_expected(what);
  next_ += found.size();
  return found;
}

std::int64_t TextCursor::integer(const char* what) {
  constexpr std::ptrdiff_t kMostDigits = 18;  // 10^18 - 1 fits 64 bits
  skip_blanks();
  const char* const first = next_;
  const bool negative = next_ < end_ && *next_ == '-';
  if (negative) ++next_;
  const char* const digits = next_;
  std::int64_t value = 0;
  while (at_digit() && next_ - digits < kMostDigits) value = 10 * value + (*next_++ - '0');
  if (next_ == digits || !at_separator()) {
    next_ = first;
    fail_expected(what);
  }
  return negative ? -value : value;
}

Index TextCursor::index(const char* what) {
  skip_blanks();
  const std::size_t first = offset();
  const std::int64_t value = integer(what);
  if (value != static_cast<Index>(value)) {
    move_to(first);
    fail_expected(what);
  }
  return static_cast<Index>(value);
}

double TextCursor::real(const char* what) {
  skip_blanks();
  const char* const first = next_;
  const char* const start = next_ < end_ && *next_ == '+' ? next_ + 1 : next_;
  double value = 0;
  const auto [last, error] = std::from_chars(start, end_, value);
  next_ = last;
  if (error == std::errc() && at_separator()) return value;
  // from_chars refuses numbers too small for a double; like strtod, take them for zero.
  const std::string_view number(first, static_cast<std::size_t>(last - first));
  if (error == std::errc::result_out_of_range && at_separator() &&
      (number.find("e-") != number.npos || number.find("E-") != number.npos))
    return number.front() == '-' ? -0.0 : 0.0;
  next_ = first;
  fail_expected(what);
}

double TextCursor::finite_real(const char* what) {
  skip_blanks();
  const std::size_t first = offset();
  const double value = real(what);
  if (!std::isfinite(value)) {
    move_to(first);
    fail_expected(what);
  }
  return value;
}

Index TextCursor::count(const char* what, std::size_t least_bytes) {
  skip_blanks();
  const std::size_t first = offset();
  const std::int64_t value = integer(what);
  if (value < 0) {
    move_to(first);
    fail_expected(what);
  }
  // The last line end may be missing.
  if (static_cast<std::uint64_t>(value) > (remaining() + 1) / least_bytes)
    fail_at(first, std::string(what) + " is " + std::to_string(value) +
                       ", but the file ends before that many can follow; is it truncated?");
  if (value > std::numeric_limits<Index>::max())
    fail_at(first, std::string(what) + " is " + std::to_string(value) +
                       ", more than the 2147483647 that can be numbered");
  return static_cast<Index>(value);
}

std::string_view TextCursor::quoted(const char* what) {
  skip_blanks();
  if (next_ == end_ || *next_ != '"') fail_expected(what);
  const char* const first = next_ + 1;
  const char* const last = std::find(first, end_, '"');
  if (last == end_) fail("the quotation mark of " + std::string(what) + " is not closed");
  next_ = last + 1;
  return {first, static_cast<std::size_t>(last - first)};
}

void TextCursor::expect(std::string_view expected) {
  const std::string_view found = peek();
  if (found != expected) fail_expected(std::string(expected).c_str());
  next_ += found.size();
}

void TextCursor::skip_line() {
  const char* const line_end = std::find(next_, end_, '\n');
  next_ = line_end == end_ ? end_ : line_end + 1;
}

void TextCursor::skip_comments() {
  while (next_ < end_ && *next_ == '#') {
    skip_line();
    while (next_ < end_ && static_cast<unsigned char>(*next_) <= ' ') ++next_;
  }
}

void TextCursor::fail_at(std::size_t offset, const std::string& message) const {
  if (by_bytes_) throw InputError(name_ + ": byte " + std::to_string(offset) + ": " + message);
  const auto line = 1 + std::count(begin_, begin_ + offset, '\n');
  throw InputError(name_ + ":" + std::to_string(line) + ": " + message);
}

void TextCursor::fail_expected(const char* what) {
  const std::string_view found = peek();
  fail("expected " + std::string(what) + ", found " +
       (found.empty() ? std::string("the end of the file") : shown(found)));
}

}  // namespace anisofront
