#include "actio/scene/checkpoint.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "actio/scene/scene_error.hpp"

namespace actio::scene {
namespace {

constexpr std::string_view heading = "actio checkpoint 1\n";

/// FNV-1a: enough to see that a file was damaged or belongs elsewhere.
std::uint64_t hash(std::string_view bytes) {
  std::uint64_t h = 14695981039346656037u;
  for (unsigned char const c : bytes) h = (h ^ c) * 1099511628211u;
  return h;
}
std::string as_bytes(std::uint64_t x) { return {reinterpret_cast<char const*>(&x), sizeof x}; }

[[noreturn]] void fail(std::string const& path, std::string const& what) { throw FileError(path + ": " + what + ": " + std::strerror(errno)); }

}  // namespace

void write_whole_file(std::string const& path, std::string_view content) {
  std::string const part = path + ".part";
  int const file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail(part, "cannot be opened");
  std::size_t done = 0;
  while (done < content.size()) {
    ssize_t const n = ::write(file, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      int const error = errno;
      ::close(file), ::unlink(part.c_str());
      errno = error;
      fail(path, "cannot be written");
    }
    done += static_cast<std::size_t>(n);
  }
  if (::fsync(file) != 0 && errno != EINVAL) fail(path, "cannot be written");
  ::close(file);
  if (std::rename(part.c_str(), path.c_str()) != 0) fail(path, "cannot be written");
  std::string const folder = std::filesystem::path(path).parent_path().string();
  if (int const handle = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); handle >= 0) ::fsync(handle), ::close(handle);
}

void write_checkpoint(std::string const& path, std::string const& scene, std::string const& state) {
  write_whole_file(path, std::string(heading) + as_bytes(hash(scene)) + as_bytes(hash(state)) + state);
}

std::string read_checkpoint(std::string const& path, std::string const& scene) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be read");
  std::string const bytes{std::istreambuf_iterator<char>(in), {}};
  std::size_t const start = heading.size() + 16;
  if (!bytes.starts_with(heading) || bytes.size() < start) throw FileError(path + ": is no checkpoint of this version of actio");
  if (bytes.substr(heading.size(), 8) != as_bytes(hash(scene))) throw FileError(path + ": belongs to another scene; scene.toml was changed since");
  std::string state = bytes.substr(start);
  if (bytes.substr(heading.size() + 8, 8) != as_bytes(hash(state))) throw FileError(path + ": is damaged");
  return state;
}

}  // namespace actio::scene
