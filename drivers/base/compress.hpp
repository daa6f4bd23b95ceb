#pragma once

#include <span>
#include <string>

namespace anisofront {

/// The blocks, one after the other, as one gzip file (RFC 1952) without name and time. A block
/// holds numbers of one kind: it gets a Huffman code of its own, which makes the file smaller.
std::string gzip(std::span<const std::string> blocks);

}  // namespace anisofront
