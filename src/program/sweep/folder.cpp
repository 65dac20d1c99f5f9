#include "program/sweep/folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "program/base/own_files.hpp"
#include "program/run/checkpoint.hpp"

namespace actio::scene {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> const files{"sweep.toml", "sweep.toml.part", "sweep.csv",   "sweep.csv.part",
                                     ".results",   ".inputs",         ".inputs.part"};

/// Before each result among the kept ones: how long it is, and a sum over its bytes. One that was cut off is
/// none.
struct Head {
  std::uint32_t size = 0, sum = 0;
};
Head head_of(std::string_view bytes) {
  std::uint32_t sum = 2166136261u;
  for (unsigned char const byte : bytes) sum = (sum ^ byte) * 16777619u;
  return {static_cast<std::uint32_t>(bytes.size()), sum};
}

/// A folder and no link to one.
bool is_folder(std::string const& path) {
  struct stat status;
  return ::lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

/// How many members a sweep of the version before has, whose folder holds no list: the rows of its table.
long members_in_table(std::string const& folder) {
  std::string const path = folder + "/sweep.csv";
  std::error_code none;
  std::ifstream in(path);
  std::string line;
  if (fs::is_symlink(path, none) || !std::getline(in, line) || !line.starts_with("member,") ||
      line.find(",status,steps,wall_seconds") == std::string::npos)
    return 0;
  long rows = 0;
  while (std::getline(in, line)) ++rows;
  return std::min(rows, most_members);
}

/// The sweep in a folder, for who wants to replace it.
struct SweepBefore {
  std::string folder;
  bool listed = false;
  long members = 0;

  explicit SweepBefore(std::string path) : folder(std::move(path)) {
    OwnFiles const own(folder);
    listed = own.of() == OwnFiles::Of::sweep;
    members = listed ? own.members() : own.of() == OwnFiles::Of::nothing ? members_in_table(folder) : 0;
  }
  bool there() const { return listed || members > 0; }
  bool is_member(OwnFiles const& own) const {
    return own.of() == (listed ? OwnFiles::Of::member : OwnFiles::Of::run);
  }

  /// Refuses what could not be removed, before anything is.
  void check() const {
    OwnFiles(folder).check();
    each_member([&](std::string const& path) {
      OwnFiles const own(path);
      if (!is_member(own)) return;
      FolderLock const lock(path);
      own.check();
    });
  }
  void remove() const {
    each_member([&](std::string const& path) {
      OwnFiles own(path);
      if (!is_member(own)) return;
      own.remove();
      // Where something of other people is left, the folder is still that of a member.
      if (own.alone())
        ::rmdir(path.c_str());
      else
        own.begin(OwnFiles::Of::member, {});
    });
    if (listed)
      OwnFiles(folder).remove();
    else if (std::error_code error; !fs::remove(folder + "/sweep.csv", error) && error)
      throw FileError(folder + "/sweep.csv: cannot be removed: " + error.message());
  }

 private:
  template <class Do>
  void each_member(Do const& what) const {
    for (long member = 0; member < members; ++member)
      if (std::string const path = folder + "/" + SweepPlan::name(member); is_folder(path)) what(path);
  }
};

/// @return the sweep that has to go, if any
std::optional<SweepBefore> sweep_before(std::string const& path, bool replace) {
  OwnFiles const own(path);
  if (own.alone()) return {};
  if (!replace)
    throw SceneError({path},
                     SweepFolder::is_one(path)
                         ? "the folder is not empty; --force replaces the sweep in it, actio resume goes "
                           "on with it, --out names another"
                         : "the folder is not empty; --force replaces a sweep, --out names another folder");
  SweepBefore before(path);
  if (!before.there())
    throw SceneError({path},
                     "--force replaces a sweep of actio, and there is none in this folder: neither the "
                     "list .actio of its files nor a table sweep.csv; --out names another");
  return before;
}

}  // namespace

bool SweepFolder::is_one(std::string const& path) {
  std::error_code none;
  return fs::is_regular_file(path + "/sweep.toml", none);
}

void SweepFolder::refuse_unless_free(std::string const& path, bool replace) {
  std::error_code none;
  if (!fs::exists(path, none)) return;
  if (!fs::is_directory(path, none))
    throw SceneError({path}, "a folder for the sweep is expected, and this is a file; --out names another");
  FolderLock const lock(path);
  if (auto const before = sweep_before(path, replace)) before->check();
}

SweepFolder SweepFolder::create(SweepPlan const& plan, bool replace) {
  std::string const& path = plan.folder();
  try {
    if (fs::exists(path) && !fs::is_directory(path))
      throw SceneError({path}, "a folder for the sweep is expected, and this is a file; --out names another");
    fs::create_directories(path);
    SweepFolder folder(path, FolderLock(path));
    if (auto const before = sweep_before(path, replace)) before->check(), before->remove();
    OwnFiles(path).begin(OwnFiles::Of::sweep, files, plan.size());
    write_whole_file(path + "/sweep.toml", plan.written());
    return folder;
  } catch (fs::filesystem_error const& error) {
    throw FileError(path + ": cannot be made ready for a sweep: " + error.code().message());
  }
}

SweepFolder SweepFolder::open(std::string const& path) {
  if (!is_one(path)) throw SceneError({path}, "there is no sweep in this folder: sweep.toml is missing");
  return {path, FolderLock(path)};
}

SweepFolder::SweepFolder(std::string path, FolderLock lock)
    : path_(std::move(path)), lock_(std::move(lock)) {}
SweepFolder::SweepFolder(SweepFolder&& other) noexcept
    : path_(std::move(other.path_)),
      lock_(std::move(other.lock_)),
      results_(std::exchange(other.results_, -1)) {}
SweepFolder::~SweepFolder() {
  if (results_ >= 0) ::close(results_);
}

void SweepFolder::keep_inputs(InputFiles const& inputs) const {
  CheckpointStream stream;
  InputFiles copy = inputs;
  remember(stream, copy);
  write_whole_file(path_ + "/.inputs", stream.bytes());
}
InputFiles SweepFolder::inputs(std::string const& path) {
  std::ifstream in(path + "/.inputs", std::ios::binary);
  if (!in) return {};
  CheckpointStream stream(std::string{std::istreambuf_iterator<char>(in), {}});
  InputFiles out;
  try {
    remember(stream, out);
  } catch (Error const& error) {
    throw FileError(path + "/.inputs: is damaged: " + error.what());
  }
  return out;
}

std::vector<MemberResult> SweepFolder::kept() const {
  std::ifstream in(path_ + "/.results", std::ios::binary);
  std::vector<MemberResult> out;
  Head head;
  for (std::string bytes; in.read(reinterpret_cast<char*>(&head), sizeof head);) {
    if (head.size > std::uint32_t{1} << 28) break;
    bytes.resize(head.size);
    if (!in.read(bytes.data(), head.size) || head_of(bytes).sum != head.sum) break;
    out.push_back(MemberResult::unpacked(bytes));
  }
  return out;
}

void SweepFolder::keep(MemberResult const& result) {
  std::string const path = path_ + "/.results";
  if (results_ < 0) {
    // What was cut off goes, so that what comes after it can be read.
    off_t whole = 0;
    for (auto const& before : kept()) whole += static_cast<off_t>(sizeof(Head) + before.packed().size());
    results_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (results_ < 0 || ::ftruncate(results_, whole) != 0)
      throw FileError(path + ": cannot be opened: " + std::strerror(errno));
  }
  std::string const bytes = result.packed();
  Head const head = head_of(bytes);
  std::string const all = std::string(reinterpret_cast<char const*>(&head), sizeof head) + bytes;
  for (std::string_view left = all; !left.empty();) {
    ssize_t const n = ::write(results_, left.data(), left.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(path + ": cannot be written: " + std::strerror(errno));
    left.remove_prefix(static_cast<std::size_t>(n));
  }
}

void SweepFolder::write_table(std::string const& table) const {
  write_whole_file(path_ + "/sweep.csv", table);
}

void SweepFolder::sync() const { ::syncfs(lock_.handle()); }

}  // namespace actio::scene
