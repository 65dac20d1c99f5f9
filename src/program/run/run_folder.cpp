#include "program/run/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "program/base/error.hpp"
#include "program/base/own_files.hpp"

namespace actio::scene {
namespace {

namespace fs = std::filesystem;

/// `out/` is `out`.
std::string without_slash(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

/// Makes way for a new run.
void remove_run(std::string const& path, OwnFiles& own, bool replace) {
  if (own.alone()) return;
  if (!replace)
    throw SceneError({path}, "the folder is not empty; --force replaces the run in it, --out names another");
  if (own.of() == OwnFiles::Of::sweep)
    throw SceneError({path},
                     "there is a sweep in this folder, which a run does not replace; --out names another");
  if (own.of() == OwnFiles::Of::nothing)
    throw SceneError({path},
                     "--force replaces a run of actio, and there is none in this folder: neither the list "
                     ".actio of its files nor a checkpoint; --out names another");
  own.remove();
}

}  // namespace

RunFolder RunFolder::create(std::string const& path, bool replace, std::vector<std::string> const& files) {
  try {
    if (fs::exists(path) && !fs::is_directory(path))
      throw SceneError({path}, "a folder for the run is expected, and this is a file; --out names another");
    fs::create_directories(path);
    RunFolder folder(without_slash(path), FolderLock(path));
    OwnFiles own(folder.path());
    remove_run(path, own, replace);
    own.begin(OwnFiles::Of::run, files);
    return folder;
  } catch (fs::filesystem_error const& error) {
    throw FileError(path + ": cannot be made ready for a run: " + error.code().message() +
                    "; --out names another place for it");
  }
}

RunFolder RunFolder::open(std::string const& path) {
  // Who asks whether a run goes on here has the folder for an instant (`in_use`).
  return {look(path), FolderLock(path, std::chrono::milliseconds(200))};
}

bool RunFolder::in_use(std::string const& path) {
  int const handle = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  bool const locked = handle >= 0 && ::flock(handle, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (handle >= 0) ::close(handle);
  return locked;
}

std::string RunFolder::look(std::string const& path) {
  std::error_code none;
  if (!fs::is_directory(path, none))
    throw SceneError({path}, fs::exists(path, none) ? "the folder of a run is expected, and this is a file"
                                                    : "there is no such folder");
  if (!fs::exists(fs::path(path) / "scene.toml", none))
    throw SceneError({path}, "there is no run in this folder: scene.toml is missing");
  return without_slash(path);
}

RunFolder RunFolder::of_member(std::string const& path) {
  if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST)
    throw FileError(path + ": cannot be made: " + std::strerror(errno));
  struct stat status;
  if (::lstat(path.c_str(), &status) == 0 && !S_ISDIR(status.st_mode))
    throw SceneError(
        {path}, "a folder for a member of the sweep is expected, and this is a file or a link; move it away");
  // A process of a sweep that was killed may need a moment to see it.
  RunFolder folder(path, FolderLock(path, std::chrono::seconds(5)));
  OwnFiles const own(path);
  if (own.of() != OwnFiles::Of::member && !own.alone())
    throw SceneError({path},
                     "the folder is not empty, and what is in it is no member of this sweep; move it away");
  return folder;
}

void RunFolder::begin_member(std::vector<std::string> const& files) const {
  OwnFiles own(path_);
  if (own.of() == OwnFiles::Of::member) own.remove();
  own.begin(OwnFiles::Of::member, files);
}

bool RunFolder::begun() const { return ::access((path_ + "/checkpoint").c_str(), F_OK) == 0; }

}  // namespace actio::scene
