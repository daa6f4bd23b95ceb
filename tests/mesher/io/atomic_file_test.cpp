#include "mesher/io/atomic_file.hpp"

#include <doctest/doctest.h>

#include "io_support.hpp"
#include "mesher/io/medit.hpp"
#include "mesher/io/svg.hpp"
#include "mesher/io/vtu.hpp"

using namespace anisofront;
using namespace anisofront::test;

TEST_SUITE("unit") {
  TEST_CASE("a file appears only when it is committed") {
    const Scratch scratch;
    AtomicFile out(scratch / "a.txt");
    out.text("x ");
    out.integer(-12);
    out.byte(' ');
    out.real(0.1);
    CHECK(!std::filesystem::exists(scratch / "a.txt"));
    CHECK(scratch.file_count() == 1);
    out.commit();
    CHECK(contents(scratch / "a.txt") == "x -12 0.1");
    CHECK(scratch.file_count() == 1);
  }

  TEST_CASE("an abandoned file leaves the old one and nothing else") {
    const Scratch scratch;
    write_text(scratch / "a.txt", "old");
    {
      AtomicFile out(scratch / "a.txt");
      out.text(std::string(3'000'000, 'x'));
    }
    CHECK(contents(scratch / "a.txt") == "old");
    CHECK(scratch.file_count() == 1);
  }

  TEST_CASE("output longer than the buffer is complete") {
    const Scratch scratch;
    std::string expected;
    AtomicFile out(scratch / "a.txt");
    for (int i = 0; i < 300'000; ++i) {
      out.integer(i);
      out.byte('\n');
      expected += std::to_string(i) + "\n";
    }
    out.commit();
    CHECK(contents(scratch / "a.txt") == expected);
  }

  TEST_CASE("a link keeps pointing to the file that is replaced") {
    const Scratch scratch;
    write_text(scratch / "target", "old");
    std::filesystem::create_symlink("target", scratch / "link");
    AtomicFile out(scratch / "link");
    out.text("new");
    out.commit();
    CHECK(std::filesystem::is_symlink(scratch / "link"));
    CHECK(contents(scratch / "target") == "new");
  }

  TEST_CASE("the permissions of a replaced file are kept") {
    namespace fs = std::filesystem;
    const Scratch scratch;
    write_text(scratch / "a.txt", "old");
    fs::permissions(scratch / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
    AtomicFile out(scratch / "a.txt");
    out.commit();
    CHECK(fs::status(scratch / "a.txt").permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write));
  }

  TEST_CASE("a directory that does not exist is an input error") {
    CHECK(message_of([] { AtomicFile out("/nowhere/a.txt"); }) ==
          "cannot write /nowhere/a.txt: No such file or directory");
  }

  TEST_CASE("a full disc is an input error of every writer") {
    const std::string expected = "cannot write /dev/full: No space left on device";
    const MeshFile file = small_file();
    for (const GmshFormat format : kFlavours)
      CHECK(message_of([&] { write_gmsh("/dev/full", file, format); }) == expected);
    CHECK(message_of([&] { write_medit("/dev/full", file.mesh); }) == expected);
    CHECK(message_of([] { write_medit_metric("/dev/full", MetricField(5)); }) == expected);
    CHECK(message_of([&] { write_vtu("/dev/full", file); }) == expected);
    CHECK(message_of([&] { write_svg("/dev/full", file.mesh); }) == expected);
    CHECK(std::filesystem::is_character_file("/dev/full"));
  }
}
