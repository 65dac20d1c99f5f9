// The folder of a run: made or found, and locked, so that no two processes run in it.
#pragma once

#include <string>
#include <vector>

#include "program/base/folder_lock.hpp"

namespace actio::scene {

/// A folder that this process runs in. The lock goes with the process, however it ends.
class RunFolder {
 public:
  /// For a new run: made where there is none, empty, or beside files of other people after the run that was
  /// in it.
  /// @param files    that the run will write: their list is in the folder before any of them
  /// @param replace  whether the run that is in it goes: the files in its list, and nothing else
  /// @throws SceneError  where it is no folder, or not empty and `replace` is not said; where there is no
  ///         run that could be replaced, or one of the
  ///                     files would take the place of somebody else's
  /// @throws FileError   where it cannot be made or emptied, or another process runs in it
  static RunFolder create(std::string const& path, bool replace, std::vector<std::string> const& files);
  /// That of a run.
  /// @throws SceneError  where there is no such folder, or no run in it
  /// @throws FileError   where another process runs in it
  static RunFolder open(std::string const& path);
  /// That of a member of a sweep: made where there is none, or left by the same member. Another process may
  /// still be about to leave it.
  /// @throws SceneError  where something else is in it
  /// @throws FileError   as `create`
  static RunFolder of_member(std::string const& path);

  /// The list of a member's files, anew, in place of what it has left here.
  /// @throws SceneError, FileError
  void begin_member(std::vector<std::string> const& files) const;
  /// Whether there is a checkpoint to go on from.
  bool begun() const;
  /// That there is a run in a folder, in which another process may run.
  /// @return the path, without a slash at its end
  /// @throws SceneError  where there is no such folder, or no run in it
  static std::string look(std::string const& path);
  /// Whether another process runs in a folder.
  static bool in_use(std::string const& path);

  /// The path of the folder.
  std::string const& path() const { return path_; }
  /// A file in it.
  std::string operator/(std::string const& name) const { return path_ + "/" + name; }

 private:
  RunFolder(std::string path, FolderLock lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::string path_;
  FolderLock lock_;
};

}  // namespace actio::scene
