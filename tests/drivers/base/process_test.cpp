#include "drivers/base/process.hpp"

#include <doctest/doctest.h>

#include "drivers/base/text.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE_BEGIN("unit");

TEST_CASE("a program runs in its folder and tells its status and messages") {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program_in(folder.path(), {"sh", "-c", "pwd > here; echo no >&2; echo yes; exit 3"});
  CHECK(run.status == 3);
  CHECK(run.messages == "no\n");
  CHECK(has(read_text_file(folder.path() / "here"), folder.path().filename().string()));
}

TEST_CASE("a program that is not there or is killed has a status of its own") {
  const TemporaryFolder folder;
  CHECK(run_program_in(folder.path(), {"anisofront-no-such-program"}).status == kProgramNotFound);
  CHECK(run_program_in(folder.path(), {"sh", "-c", "kill -9 $$"}).status == 128);
  CHECK(run_program_in(folder.path() / "missing", {"true"}).status == 126);
}

TEST_CASE("words reach a program as they are and its input is empty") {
  const TemporaryFolder folder;
  const std::string word = "a `b` $HOME \"c\" '*'";
  const ProgramRun run = run_program_in(
      folder.path(),
      {"sh", "-c", "cat; printf %s \"$1\" >&2; head -c 100000 /dev/zero >&2", "sh", word});
  CHECK(run.status == 0);
  CHECK(run.messages.starts_with(word));
  CHECK(run.messages.size() == 65536);
}

TEST_CASE("programs side by side leave their results in order") {
  const TemporaryFolder folder;
  std::vector<std::vector<std::string>> commands;
  for (int k = 0; k < 9; ++k) commands.push_back({"sh", "-c", "exit " + std::to_string(k)});
  const std::vector<ProgramRun> runs = run_programs_in(folder.path(), commands);
  REQUIRE(runs.size() == 9);
  for (int k = 0; k < 9; ++k) CHECK(runs[static_cast<std::size_t>(k)].status == k);
  CHECK(run_programs_in(folder.path(), {}).empty());
}

TEST_SUITE_END();
