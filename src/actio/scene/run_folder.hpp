// The folder of a run: made or found, and locked, so that no two processes run in it.
#pragma once

#include <string>

namespace actio::scene {

/// A folder that this process runs in. The lock goes with the process, however it ends.
class RunFolder {
 public:
  /// For a new run: made where there is none, empty.
  /// @param replace  whether the run that is in it goes: all that a run leaves, and nothing else
  /// @throws SceneError  where it is no folder, or not empty and `replace` is not said
  /// @throws FileError   where it cannot be made or emptied, or another process runs in it
  static RunFolder create(std::string const& path, bool replace);
  /// That of a run.
  /// @throws SceneError  where there is no such folder, or no run in it
  /// @throws FileError   where another process runs in it
  static RunFolder open(std::string const& path);

  /// That there is a run in a folder, in which another process may run.
  /// @return the path, without a slash at its end
  /// @throws SceneError  where there is no such folder, or no run in it
  static std::string look(std::string const& path);
  /// Whether another process runs in a folder.
  static bool in_use(std::string const& path);

  /// Takes over the lock.
  RunFolder(RunFolder&& other) noexcept : path_(std::move(other.path_)), handle_(other.handle_) { other.handle_ = -1; }
  RunFolder(RunFolder const&) = delete;
  RunFolder& operator=(RunFolder const&) = delete;
  ~RunFolder();

  /// The path of the folder.
  std::string const& path() const { return path_; }
  /// A file in it.
  std::string operator/(std::string const& name) const { return path_ + "/" + name; }

 private:
  explicit RunFolder(std::string const& path);

  std::string path_;
  int handle_ = -1;
};

}  // namespace actio::scene
