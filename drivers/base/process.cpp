#include "drivers/base/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace anisofront {

int run_program_in(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  const std::string directory = folder.string();
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) return kProgramNotFound;
  if (child == 0) {
    const int nowhere = open("/dev/null", O_RDWR);
    if (nowhere < 0 || chdir(directory.c_str()) != 0) _exit(126);
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execvp(arguments.front(), arguments.data());
    _exit(kProgramNotFound);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace anisofront
