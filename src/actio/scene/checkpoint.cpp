#include "actio/scene/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "actio/scene/run.hpp"
#include "actio/scene/scene_error.hpp"

namespace actio::scene {
namespace {

// Another version may make other digits of the same scene.
constexpr std::string_view heading = "actio checkpoint 2, " ACTIO_VERSION "\n";
/// What to do where a checkpoint is of no use.
constexpr char const* way_out = "; without it the run starts anew: remove it, then actio resume does so";

/// FNV-1a, eight bytes at a time: enough to see that a file was damaged or belongs elsewhere.
std::uint64_t hash(std::string_view bytes) {
  std::uint64_t h = 14695981039346656037u ^ bytes.size();
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    h = (h ^ word) * 1099511628211u;
    h ^= h >> 32;
  }
  return h;
}
std::string as_bytes(std::uint64_t x) { return {reinterpret_cast<char const*>(&x), sizeof x}; }

[[noreturn]] void fail(std::string const& path, int error) {
  throw FileError(path + ": cannot be written: " + std::strerror(error));
}

/// A file that is gone again unless it is given its name.
class Part {
 public:
  explicit Part(std::string const& path)
      : path_(path),
        part_(path + ".part"),
        file_(::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666)) {
    if (file_ < 0) fail(path_, errno);
  }
  ~Part() {
    if (file_ >= 0) ::close(file_);
    if (!named_) ::unlink(part_.c_str());
  }
  void write(std::string_view content) {
    while (!content.empty()) {
      ssize_t const n = ::write(file_, content.data(), content.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(path_, errno);
      content.remove_prefix(static_cast<std::size_t>(n));
    }
  }
  void name(bool durable) {
    if (durable && ::fsync(file_) != 0 && errno != EINVAL) fail(path_, errno);
    int const closed = ::close(std::exchange(file_, -1));
    if (closed != 0 || std::rename(part_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    named_ = true;
  }

 private:
  std::string path_, part_;
  int file_;
  bool named_ = false;
};

}  // namespace

void write_whole_file(std::string const& path, std::string_view content, bool durable) {
  Part part(path);
  part.write(content);
  part.name(durable);
  if (!durable) return;
  // The name is on the disk when the folder is.
  std::string const folder = std::filesystem::path(path).parent_path().string();
  if (int const handle = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      handle >= 0)
    ::fsync(handle), ::close(handle);
}

std::string what_determines(SceneFile const& scene) {
  SceneFile const copy = SceneFile::parse(scene.written(), scene.name());
  copy.section("scene").set("title", "");
  copy.section("output").set("plots", false);
  if (SceneTable run = copy.section("run"); !run.has("at")) run.set("until", 0.0);
  return copy.written();
}

void write_checkpoint(std::string const& path, std::string const& scene, std::string const& state,
                      bool durable) {
  write_whole_file(path, std::string(heading) + as_bytes(hash(scene)) + as_bytes(hash(state)) + state,
                   durable);
}

std::string read_checkpoint(std::string const& path, std::string const& scene) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be read");
  std::string const bytes{std::istreambuf_iterator<char>(in), {}};
  std::size_t const start = heading.size() + 16;
  if (!bytes.starts_with(heading.substr(0, heading.find("2,"))))
    throw FileError(path + ": is damaged, or no checkpoint" + way_out);
  if (!bytes.starts_with(heading))
    throw FileError(path + ": was written by another version of actio; this is " ACTIO_VERSION + way_out);
  if (bytes.size() < start) throw FileError(path + ": is damaged: it ends too early" + way_out);
  if (bytes.substr(heading.size(), 8) != as_bytes(hash(scene)))
    throw FileError(
        path +
        ": belongs to another scene; scene.toml beside it was changed since, or the checkpoint is damaged" +
        way_out);
  std::string state = bytes.substr(start);
  if (bytes.substr(heading.size() + 8, 8) != as_bytes(hash(state)))
    throw FileError(path + ": is damaged" + way_out);
  return state;
}

double checkpoint_interval() {
  char const* const text = std::getenv("ACTIO_CHECKPOINT_SECONDS");
  if (!text) return RunOptions{}.checkpoint_interval;
  char* end = nullptr;
  double const seconds = std::strtod(text, &end);
  if (end == text || *end || !(seconds >= 0))
    throw SceneError({"ACTIO_CHECKPOINT_SECONDS"},
                     fmt::format("a number of seconds is expected, found '{}'", text));
  return seconds;
}

}  // namespace actio::scene
