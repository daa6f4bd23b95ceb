#include "drivers/base/compress.hpp"

#include <new>

#include <zlib.h>

namespace anisofront {
namespace {

std::string next_bytes(z_stream& stream, const std::string& block, int flush) {
  std::string bytes;
  char buffer[1 << 14];
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));
  stream.avail_in = static_cast<uInt>(block.size());
  do {
    stream.next_out = reinterpret_cast<Bytef*>(buffer);
    stream.avail_out = sizeof buffer;
    deflate(&stream, flush);
    bytes.append(buffer, sizeof buffer - stream.avail_out);
  } while (stream.avail_out == 0);
  return bytes;
}

}  // namespace

std::string gzip(std::span<const std::string> blocks) {
  constexpr int kGzip = 16, kLargestWindow = 15, kMostMemory = 9;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kLargestWindow + kGzip, kMostMemory,
                   Z_FILTERED) != Z_OK)
    throw std::bad_alloc();
  std::string result;
  for (const std::string& block : blocks) result += next_bytes(stream, block, Z_BLOCK);
  result += next_bytes(stream, {}, Z_FINISH);
  deflateEnd(&stream);
  return result;
}

}  // namespace anisofront
