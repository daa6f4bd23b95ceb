#include "mesher/io/vtu.hpp"

#include <doctest/doctest.h>

#include "io_support.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// The numbers of the data array of that name, blanks for line ends.
std::string array_of(const std::string& xml, const std::string& name) {
  const std::size_t at = xml.find("Name=\"" + name + "\"");
  if (at == std::string::npos) return "no such array";
  const std::size_t first = xml.find(">\n", at) + 2;
  std::istringstream in(xml.substr(first, xml.find('<', first) - first));
  std::string numbers, number;
  while (in >> number) numbers += (numbers.empty() ? "" : " ") + number;
  return numbers;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a vtu file holds lines then triangles then quads with tags and fields") {
    const Scratch scratch;
    MeshFile file = small_file();
    file.mesh.vertex_tags = {0, 0, 4, 0, 0, 0};
    file.vertex_fields = {{"u", 1, {1, 2, 3, 4, 5, 0.5}, 0, 1}, {"u", 1, {0, 0, 0, 0, 0, 9}, 1, 2}};
    file.element_fields = {{"e & <f>", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}, 0, 0}};
    write_vtu(scratch / "m.vtu", file);
    const std::string xml = contents(scratch / "m.vtu");
    CHECK(contains(xml, "NumberOfPoints=\"6\" NumberOfCells=\"6\""));
    CHECK(array_of(xml, "points") == "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0");
    CHECK(array_of(xml, "connectivity") == "0 1 1 4 3 0 0 1 2 0 2 3 1 4 5 2");
    CHECK(array_of(xml, "offsets") == "2 4 6 9 12 16");
    CHECK(array_of(xml, "types") == "3 3 3 5 5 9");
    CHECK(array_of(xml, "tag") == "10 10 11 0 0 0");
    CHECK(array_of(xml, "region") == "0 0 0 1 2 2");
    CHECK(array_of(xml, "vertex_tag") == "0 0 4 0 0 0");
    CHECK(array_of(xml, "u (step 1)") == "1 2 3 4 5 0.5");
    CHECK(array_of(xml, "u (step 2)") == "0 0 0 0 0 9");
    CHECK(array_of(xml, "e &amp; &lt;f&gt;") == "0 0 0 0 0 0 0 0 0 1 2 3 4 5 6 7 8 9");
  }
}
