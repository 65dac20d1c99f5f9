#include "app/scene_argument.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace actio::app {

using namespace scene;

namespace {

/// What comes from a descriptor up to its end, or a little more than any scene has.
std::string read_to_end(int from, std::string const& name) {
  constexpr std::size_t enough = (4 << 20) + 1;
  std::string text;
  char piece[1 << 16];
  while (text.size() < enough) {
    ssize_t const n = ::read(from, piece, sizeof piece);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(name + ": cannot be read: " + std::strerror(errno));
    if (n == 0) break;
    text.append(piece, static_cast<std::size_t>(n));
  }
  return text;
}

/// Whether it is a pipe that is named, as `<(command)` of a shell is.
bool is_pipe(std::string const& argument) {
  std::error_code none;
  return std::filesystem::is_fifo(argument, none);
}

/// What a pipe is called in messages. Files that its scene names are looked for where the command is.
std::string name_of_pipe(std::string const& argument) {
  return "pipe " + std::filesystem::path(argument).filename().string();
}

SceneFile scene_of_pipe(std::string const& argument, std::vector<std::string> const& overrides) {
  std::string const name = name_of_pipe(argument);
  int const from = ::open(argument.c_str(), O_RDONLY | O_CLOEXEC);
  if (from < 0) throw FileError(name + ": cannot be opened: " + std::strerror(errno));
  std::string const text = read_to_end(from, name);
  ::close(from);
  return SceneFile::parse(text, name, overrides);
}

}  // namespace

SceneFile scene_of(std::string const& argument, std::vector<std::string> const& overrides) {
  if (argument == "-")
    return SceneFile::parse(read_to_end(STDIN_FILENO, "standard input"), "standard input", overrides);
  return is_pipe(argument) ? scene_of_pipe(argument, overrides) : SceneFile::read(argument, overrides);
}

std::string folder_beside(std::string const& argument, bool plan) {
  bool const pipe = is_pipe(argument);
  if (argument != "-" && !pipe) return std::filesystem::path(argument).replace_extension().string();
  std::string const of = pipe ? "from a pipe" : "on standard input";
  if (plan) return "none yet: a scene " + of + " has no name, and a run needs --out";
  throw SceneError({pipe ? name_of_pipe(argument) : "-"},
                   "a scene " + of + " has no name; --out names the folder for its run");
}

}  // namespace actio::app
