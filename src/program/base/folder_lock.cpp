#include "program/base/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

#include "program/base/error.hpp"

namespace actio::scene {

FolderLock::FolderLock(std::string const& path, std::chrono::milliseconds patience)
    : handle_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (handle_ < 0) throw FileError(path + ": cannot be opened: " + std::strerror(errno));
  auto const until = std::chrono::steady_clock::now() + patience;
  // Some file systems have no locks; then there is none.
  while (::flock(handle_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    if (std::chrono::steady_clock::now() >= until) {
      ::close(handle_);
      throw FileError(path + ": another process of actio runs in this folder");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}
FolderLock::~FolderLock() {
  if (handle_ >= 0) ::close(handle_);
}

}  // namespace actio::scene
