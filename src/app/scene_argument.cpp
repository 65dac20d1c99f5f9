#include "app/scene_argument.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace actio::app {

using namespace scene;

namespace {

/// Standard input up to its end, or a little more than any scene has.
std::string standard_input() {
  constexpr std::size_t enough = (4 << 20) + 1;
  std::string text;
  char piece[1 << 16];
  while (text.size() < enough) {
    ssize_t const n = ::read(STDIN_FILENO, piece, sizeof piece);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(std::string("standard input: cannot be read: ") + std::strerror(errno));
    if (n == 0) break;
    text.append(piece, static_cast<std::size_t>(n));
  }
  return text;
}

}  // namespace

SceneFile scene_of(std::string const& argument, std::vector<std::string> const& overrides) {
  return argument == "-" ? SceneFile::parse(standard_input(), "standard input", overrides)
                         : SceneFile::read(argument, overrides);
}

std::string folder_beside(std::string const& argument, bool plan) {
  if (argument != "-") return std::filesystem::path(argument).replace_extension().string();
  if (plan) return "none yet: a scene on standard input has no name, and a run needs --out";
  throw SceneError({"-"}, "a scene on standard input has no name; --out names the folder for its run");
}

}  // namespace actio::app
