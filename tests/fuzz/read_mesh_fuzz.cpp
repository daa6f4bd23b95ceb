#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesher/geometry/error.hpp"
#include "mesher/io/gmsh.hpp"
#include "mesher/io/medit.hpp"

// libFuzzer target: whatever the bytes, the readers return a mesh or throw InputError. The start of
// the input chooses the reader, as the suffix of a file would.

namespace {

void read(std::string_view bytes) {
  using namespace anisofront;
  constexpr Index kVertices = 4;
  if (bytes.starts_with("$"))
    parse_gmsh(bytes, "fuzz.msh");
  else if (bytes.find("SolAtVertices") != std::string_view::npos)
    parse_medit_metric(bytes, "fuzz.sol", kVertices);
  else
    parse_medit(bytes, "fuzz.mesh");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read({reinterpret_cast<const char*>(data), size});
  } catch (const anisofront::InputError&) {
    return 0;
  }
  return 0;
}
