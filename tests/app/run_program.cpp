#include "tests/app/run_program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace stemwise::testing {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void become_stemwise(const std::vector<std::string>& arguments, const std::string& environment, int out, int err) {
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  setenv("XDG_CACHE_HOME", "/dev/null", 1);  // no folder: nothing of a run is left in the home of who tests
  if (!environment.empty()) putenv(const_cast<char*>(environment.c_str()));
  std::vector<char*> argv{const_cast<char*>("stemwise")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(STEMWISE_EXECUTABLE, argv.data());
  _exit(127);
}

int exit_code(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

int open_for_writing(const std::string& path) { return open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600); }

}  // namespace

ProgramRun run_stemwise(const std::vector<std::string>& arguments, const std::string& environment) {
  const Folder folder;
  const int out = open_for_writing(folder / "out"), err = open_for_writing(folder / "err");
  const pid_t child = fork();
  if (child == 0) become_stemwise(arguments, environment, out, err);
  close(out);
  close(err);
  const int code = exit_code(child);
  return {code, text_of(folder / "out"), text_of(folder / "err")};
}

ProgramRun interrupt_stemwise(const std::vector<std::string>& arguments) {
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) become_stemwise(arguments, "", ends[1], ends[1]);
  close(ends[1]);
  ProgramRun run;
  char letter = 0;
  bool sent = false;
  while (read(ends[0], &letter, 1) == 1) {
    run.err += letter;
    if (letter == '\n' && !sent) {
      kill(child, SIGINT);
      sent = true;
    }
  }
  close(ends[0]);
  run.code = exit_code(child);
  return run;
}

Folder::Folder() {
  std::string pattern = (fs::temp_directory_path() / "stemwise_test_XXXXXX").string();
  path_ = mkdtemp(pattern.data());
}
Folder::~Folder() {
  std::error_code code;
  fs::remove_all(path_, code);
}
std::string Folder::file(const std::string& name, const std::string& text) const {
  const std::string path = *this / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

}  // namespace stemwise::testing
