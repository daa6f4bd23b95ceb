#include "drivers/base/process.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace anisofront {
namespace {

/// In the child: never returns. Only calls that are safe after fork() in a program with threads.
[[noreturn]] void become(const char* directory, char* const* arguments, int messages) {
  const int nowhere = open("/dev/null", O_RDWR);
  if (nowhere < 0 || chdir(directory) != 0) _exit(126);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  execvp(arguments[0], arguments);
  _exit(kProgramNotFound);
}

std::string read_all(int descriptor) {
  constexpr std::size_t kMost = 1u << 16;
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), std::min(static_cast<std::size_t>(count), kMost - text.size()));
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

ProgramRun run_program_in(const std::filesystem::path& folder,
                          const std::vector<std::string>& words) {
  const std::string directory = folder.string();
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return {kProgramNotFound, {}};
  const pid_t child = fork();
  if (child == 0) become(directory.c_str(), arguments.data(), pipe_ends[1]);
  close(pipe_ends[1]);
  ProgramRun run{kProgramNotFound, {}};
  if (child > 0) {
    run.messages = read_all(pipe_ends[0]);
    run.status = wait_for(child);
  }
  close(pipe_ends[0]);
  return run;
}

std::vector<ProgramRun> run_programs_in(const std::filesystem::path& folder,
                                        const std::vector<std::vector<std::string>>& commands) {
  constexpr unsigned kMost = 4;
  std::vector<ProgramRun> runs(commands.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < commands.size(); i = next++)
      runs[i] = run_program_in(folder, commands[i]);
  };
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < std::min(std::thread::hardware_concurrency(), kMost); ++i)
    helpers.emplace_back(work);
  work();
  helpers.clear();
  return runs;
}

}  // namespace anisofront
