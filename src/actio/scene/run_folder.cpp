#include "actio/scene/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "actio/scene/scene_error.hpp"

namespace actio::scene {
namespace {

namespace fs = std::filesystem;

/// Whether a run leaves it: `series.csv`, `checkpoint.part`, `snapshots`.
bool left_by_a_run(fs::path const& entry) {
  std::string const name = entry.filename().string(), word = name.substr(0, name.find('.'));
  return word == "series" || word == "checkpoint" || word == "summary" || word == "snapshots" || word == "plots" || name == "scene.toml.part";
}

/// `out/` is `out`.
std::string without_slash(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

/// The checkpoint first and the scene last: what is left of it when this is cut short can be resumed, or replaced.
void remove_run(fs::path const& folder) {
  if (!fs::exists(folder / "scene.toml")) return;
  fs::remove(folder / "checkpoint");
  std::vector<fs::path> left;
  for (auto const& entry : fs::directory_iterator(folder))
    if (left_by_a_run(entry.path())) left.push_back(entry.path());
  for (auto const& path : left) fs::remove_all(path);
  fs::remove(folder / "scene.toml");
}

}  // namespace

RunFolder::RunFolder(std::string const& path) : path_(without_slash(path)), handle_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (handle_ < 0) throw FileError(path + ": cannot be opened: " + std::strerror(errno));
  // Some file systems have no locks; then there is none.
  if (::flock(handle_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(handle_);
    throw FileError(path + ": another process of actio runs in this folder");
  }
}
RunFolder::~RunFolder() {
  if (handle_ >= 0) ::close(handle_);
}

RunFolder RunFolder::create(std::string const& path, bool replace) {
  try {
    if (fs::exists(path) && !fs::is_directory(path)) throw SceneError({path}, "a folder for the run is expected, and this is a file; --out names another");
    fs::create_directories(path);
    RunFolder folder(path);
    if (!fs::is_empty(path)) {
      if (!replace) throw SceneError({path}, "the folder is not empty; --force replaces the run in it, --out names another");
      remove_run(path);
    }
    return folder;
  } catch (fs::filesystem_error const& error) {
    throw FileError(path + ": cannot be made ready for a run: " + error.code().message() + "; --out names another place for it");
  }
}

RunFolder RunFolder::open(std::string const& path) { return RunFolder(look(path)); }

bool RunFolder::in_use(std::string const& path) {
  int const handle = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  bool const locked = handle >= 0 && ::flock(handle, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (handle >= 0) ::close(handle);
  return locked;
}

std::string RunFolder::look(std::string const& path) {
  std::error_code none;
  if (!fs::is_directory(path, none)) throw SceneError({path}, fs::exists(path, none) ? "the folder of a run is expected, and this is a file" : "there is no such folder");
  if (!fs::exists(fs::path(path) / "scene.toml", none)) throw SceneError({path}, "there is no run in this folder: scene.toml is missing");
  return without_slash(path);
}

}  // namespace actio::scene
