#include "mesher/io/gmsh_stream.hpp"

#include <limits>

namespace anisofront {

std::int64_t GmshStream::size(const char* what) {
  const std::int64_t value = binary_ ? raw<std::int64_t>(what) : text.integer(what);
  if (value < 0) fail("expected " + std::string(what) + ", found " + std::to_string(value));
  return value;
}

std::size_t GmshStream::checked_count(const char* what, std::int64_t found, std::size_t numbers,
                                      std::size_t bytes) const {
  const std::string number = std::string(what) + " is " + std::to_string(found);
  if (found < 0) fail(number + ", expected at least 0");
  const std::size_t least = binary_ ? bytes : 2 * numbers;
  if (static_cast<std::uint64_t>(found) > (text.remaining() + 1) / least)
    fail(number + ", but the file ends before that many can follow; is it truncated?");
  if (found > std::numeric_limits<Index>::max())
    fail(number + ", more than the 2147483647 that can be numbered");
  return static_cast<std::size_t>(found);
}

}  // namespace anisofront
