#include "app/child.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "program/base/error.hpp"

namespace actio::app {
namespace {

[[noreturn]] void fail(std::string const& what) {
  throw scene::FileError(what + ": " + std::strerror(errno));
}

/// All that comes out of a pipe until its other end is closed.
std::string drain(int pipe) {
  std::string out;
  char piece[1 << 14];
  for (;;) {
    ssize_t const n = ::read(pipe, piece, sizeof piece);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return out;
    out.append(piece, static_cast<std::size_t>(n));
  }
}

}  // namespace

ChildOutcome run_child(std::vector<std::string> const& words) {
  std::vector<char*> arguments;
  for (auto const& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail(words[0] + ": cannot be started");
  auto const before = std::signal(SIGINT, SIG_IGN);
  pid_t const child = ::fork();
  if (child == 0) {
    std::signal(SIGINT, before);
    ::dup2(ends[1], STDOUT_FILENO), ::dup2(ends[1], STDERR_FILENO);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  std::string output = child > 0 ? drain(ends[0]) : "";
  ::close(ends[0]);
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  std::signal(SIGINT, before);
  if (child < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 127))
    throw scene::FileError(words[0] + ": cannot be started");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), std::move(output)};
}

PassingFolder::PassingFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "actio_XXXXXX").string();
  if (!::mkdtemp(name.data())) fail(name + ": cannot be made");
  path_ = name;
}
PassingFolder::~PassingFolder() {
  std::error_code none;
  std::filesystem::remove_all(path_, none);
}

std::filesystem::path folder_of_this_program() {
  std::error_code error;
  auto const program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw scene::FileError("/proc/self/exe: " + error.message());
  return program.parent_path();
}

}  // namespace actio::app
