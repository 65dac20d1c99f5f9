// The lock of a folder: no two processes of the program work in one.
#pragma once

#include <chrono>
#include <string>

namespace actio::scene {

/// A folder that this process has for itself. The lock goes with the process, however it ends.
class FolderLock {
 public:
  /// @param patience  how long another process may still keep the folder
  /// @throws FileError  where the folder cannot be opened, or another process works in it
  explicit FolderLock(std::string const& path, std::chrono::milliseconds patience = {});
  ~FolderLock();
  /// Takes over the lock.
  FolderLock(FolderLock&& other) noexcept : handle_(other.handle_) { other.handle_ = -1; }
  FolderLock(FolderLock const&) = delete;
  FolderLock& operator=(FolderLock const&) = delete;

  /// The folder, open.
  int handle() const { return handle_; }

 private:
  int handle_ = -1;
};

}  // namespace actio::scene
