// The program on a pseudo-terminal, as users see it.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <regex>

#include <doctest/doctest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "drivers/commands/program.hpp"
#include "tests/drivers/working_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

struct Session {
  std::string bytes;
  int code = -1;
  double seconds = 0;
};

/// Runs the program in a child on a terminal with so many columns; `setting`: NAME=VALUE of its
/// environment. The mesher uses one thread, so that a fork is safe.
Session on_terminal(std::vector<std::string> words, unsigned short columns, std::string setting) {
  words.insert(words.begin(), "anisofront");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  winsize size{24, columns, 0, 0};
  int terminal = -1;
  std::cout << std::flush;  // or the child would say it again
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    setenv("TERM", "xterm", 1);
    unsetenv("NO_COLOR");
    putenv(setting.data());
    _exit(run_program(static_cast<int>(arguments.size()), arguments.data()));
  }
  Session session;
  char buffer[4096];
  for (ssize_t n = read(terminal, buffer, sizeof buffer); n > 0;
       n = read(terminal, buffer, sizeof buffer))
    session.bytes.append(buffer, static_cast<std::size_t>(n));
  int status = 0;
  waitpid(child, &status, 0);
  close(terminal);
  session.code = WEXITSTATUS(status);
  session.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return session;
}

/// A mesh that takes long enough to be watched.
std::vector<std::string> long_work(const WorkingFolder& folder) {
  folder.write("s.toml", kTinyStudy);
  return {"mesh", "s.toml", "--size", "0.003", "-o", "o.msh"};
}

const std::string kErase = "\r\033[K";

/// The lines that were drawn over each other.
std::vector<std::string> drawn_lines(const std::string& bytes) {
  std::vector<std::string> lines;
  for (std::size_t at = bytes.find(kErase); at != std::string::npos;) {
    const std::size_t next = bytes.find(kErase, at + 1);
    if (next != std::string::npos)
      lines.push_back(bytes.substr(at + kErase.size(), next - at - kErase.size()));
    at = next;
  }
  return lines;
}

std::string without_colours(const std::string& line) {
  return std::regex_replace(line, std::regex("\033\\[[0-9;]*m"), "");
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a terminal shows a bar that fits and leaves nothing behind") {
  const WorkingFolder folder;
  const Session session = on_terminal(long_work(folder), 60, "LANG=C");
  CHECK(session.code == 0);
  const auto lines = drawn_lines(session.bytes);
  REQUIRE(!lines.empty());
  CHECK(static_cast<double>(lines.size()) <= 10 * session.seconds + 1);
  for (const std::string& line : lines) {
    CHECK(without_colours(line).size() < 60);
    CHECK(has(line, "mesh: "));
    CHECK(has(line, "\033[32m"));
    CHECK_FALSE(has(line, "\n"));
  }
  // The last thing done to the line is to erase it.
  const std::string rest = session.bytes.substr(session.bytes.rfind(kErase) + kErase.size());
  CHECK(rest.starts_with("wrote o.msh: "));
}

TEST_CASE("NO_COLOR takes the colours and TERM=dumb the bar") {
  const WorkingFolder folder;
  const Session plain = on_terminal(long_work(folder), 80, "NO_COLOR=1");
  CHECK(has(plain.bytes, kErase + "["));
  CHECK_FALSE(has(plain.bytes, "\033[3"));
  const Session dumb = on_terminal(long_work(folder), 80, "TERM=dumb");
  CHECK(dumb.bytes.starts_with("wrote o.msh: "));
  CHECK_FALSE(has(dumb.bytes, "\033"));
}

TEST_CASE("quiet and json are without a bar on a terminal too") {
  const WorkingFolder folder;
  auto words = long_work(folder);
  words.push_back("-q");
  CHECK(on_terminal(words, 80, "LANG=C").bytes.empty());
  words.back() = "--log-format=json";
  CHECK_FALSE(has(on_terminal(words, 80, "LANG=C").bytes, "\033"));
}

TEST_CASE("errors are red on a terminal") {
  const Session session = on_terminal({"check", "missing.msh"}, 80, "LANG=C");
  CHECK(session.code == 3);
  CHECK(has(session.bytes, "\033[1;31merror:\033[0m cannot open missing.msh"));
}

TEST_SUITE_END();
