#pragma once

#include <bit>
#include <cstring>
#include <string_view>

#include "mesher/geometry/point.hpp"
#include "mesher/io/atomic_file.hpp"

namespace anisofront {

/// The numbers of a .msh file, as text or as native (little-endian) binary values, so that one
/// writer serves both: the counterpart of GmshStream.
struct GmshSink {
  AtomicFile& out;
  bool binary = false;

  void text(std::string_view bytes) { out.text(bytes); }
  /// A 4-byte integer.
  void integer(Index value) { binary ? raw(value) : out.integer(value), separate(); }
  /// An 8-byte number of something.
  void size(std::size_t value) {
    const auto number = static_cast<std::int64_t>(value);
    binary ? raw(number) : out.integer(number), separate();
  }
  void real(double value) { binary ? raw(value) : out.real(value), separate(); }
  /// Ends a line of text; nothing in binary.
  void end_line() {
    if (!binary) out.byte('\n');
  }
  /// A number that is text in either case, on a line of its own.
  void text_line(std::int64_t value) {
    out.integer(value);
    out.byte('\n');
  }

 private:
  void separate() {
    if (!binary) out.byte(' ');
  }
  template <class Number>
  void raw(Number value) {
    static_assert(std::endian::native == std::endian::little);
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &value, sizeof(Number));
    out.text({bytes, sizeof(Number)});
  }
};

}  // namespace anisofront
