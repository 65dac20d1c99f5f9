#include "program/base/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "program/base/error.hpp"

namespace actio::scene {

WholeFile::WholeFile(std::string const& path)
    : path_(path),
      part_(path + ".part"),
      file_(::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666)) {
  if (file_ < 0) fail(errno);
}
WholeFile::~WholeFile() {
  if (file_ >= 0) ::close(file_);
  if (!named_) ::unlink(part_.c_str());
}
void WholeFile::fail(int error) const {
  throw FileError(path_ + ": cannot be written: " + std::strerror(error));
}

WholeFile& WholeFile::write(std::string_view content) {
  write_at(size_, content);
  size_ += content.size();
  return *this;
}
void WholeFile::write_at(std::size_t byte, std::string_view content) {
  while (!content.empty()) {
    ssize_t const n = ::pwrite(file_, content.data(), content.size(), static_cast<off_t>(byte));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(errno);
    content.remove_prefix(static_cast<std::size_t>(n)), byte += static_cast<std::size_t>(n);
  }
}
void WholeFile::name(bool durable) {
  if (durable && ::fsync(file_) != 0 && errno != EINVAL) fail(errno);
  int const closed = ::close(std::exchange(file_, -1));
  if (closed != 0 || std::rename(part_.c_str(), path_.c_str()) != 0) fail(errno);
  named_ = true;
  if (!durable) return;
  // The name is on the disk when the folder is.
  std::string const folder = std::filesystem::path(path_).parent_path().string();
  if (int const handle = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      handle >= 0)
    ::fsync(handle), ::close(handle);
}

bool has_its_name(int file, std::string const& path) {
  struct stat open, named;
  return ::fstat(file, &open) == 0 && open.st_nlink > 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino;
}
void require_there(std::string const& path) {
  if (::access(path.c_str(), F_OK) != 0 && errno == ENOENT)
    throw FileError(path +
                    ": is not there any more, and the checkpoint goes on behind its end; put it back, or "
                    "remove the checkpoint: then actio resume starts the run anew");
}
std::string lost_its_name(std::string const& path) {
  return path +
         ": was removed, or another file put in its place, while the run went on: its rows are lost, and "
         "only a run of the scene from its start writes them again";
}

}  // namespace actio::scene
