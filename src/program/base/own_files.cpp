#include "program/base/own_files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>

#include <string_view>

#include "program/base/error.hpp"

namespace actio::scene {
namespace {

constexpr char const* list_name = ".actio";
constexpr std::string_view headings[] = {
    "", "actio: the files of a run, which --force removes, and nothing else\n",
    "actio: the files of a member of a sweep, which --force removes, and nothing else\n",
    "actio: the files of a sweep, which --force removes, and nothing else\n"};
constexpr std::string_view members_word = "members ";
constexpr char const* folders_within[] = {"plots", "snapshots"};

std::string_view heading_of(OwnFiles::Of of) { return headings[static_cast<std::size_t>(of)]; }

/// A file that is no link, whole; nothing where there is none.
std::optional<std::string> read_file(int folder, char const* name, std::size_t most) {
  int const file = ::openat(folder, name, O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return {};
  struct stat status;
  std::optional<std::string> out;
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
    out.emplace();
    char piece[1 << 12];
    for (ssize_t n;
         out->size() < most && ((n = ::read(file, piece, sizeof piece)) > 0 || (n < 0 && errno == EINTR));)
      if (n > 0) out->append(piece, static_cast<std::size_t>(n));
  }
  ::close(file);
  return out;
}

/// `series.csv`, `plots/energy.svg`; neither `../notes` nor `/home`.
bool is_name(std::string_view name) {
  for (std::string_view const within : folders_within)
    if (name.starts_with(within) && name.substr(within.size()).starts_with("/")) {
      name.remove_prefix(within.size() + 1);
      break;
    }
  return !name.empty() && name.find('/') == std::string_view::npos && name != "." && name != "..";
}

/// A folder within, where it is one and no link; -1 otherwise.
class Within {
 public:
  Within(int folder, std::string const& name) : name_(name.substr(name.find('/') + 1)) {
    std::size_t const slash = name.find('/');
    if (slash == std::string::npos)
      at_ = folder;
    else
      own_ = at_ =
          ::openat(folder, name.substr(0, slash).c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  }
  ~Within() {
    if (own_ >= 0) ::close(own_);
  }
  Within(Within const&) = delete;
  Within& operator=(Within const&) = delete;
  bool there() const { return at_ >= 0; }
  int at() const { return at_; }
  char const* name() const { return name_.c_str(); }
  /// What is called so, links not followed.
  std::optional<mode_t> mode() const {
    struct stat status;
    if (at_ < 0 || ::fstatat(at_, name(), &status, AT_SYMLINK_NOFOLLOW) != 0) return {};
    return status.st_mode;
  }

 private:
  std::string name_;
  int at_ = -1, own_ = -1;
};

/// The names in a folder.
std::vector<std::string> entries_of(int folder) {
  std::vector<std::string> out;
  int const again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* const entries = again < 0 ? nullptr : ::fdopendir(again);
  if (!entries) throw FileError(std::string("the folder cannot be read: ") + std::strerror(errno));
  while (dirent const* const entry = ::readdir(entries))
    if (std::string name = entry->d_name; name != "." && name != "..") out.push_back(std::move(name));
  ::closedir(entries);
  return out;
}

/// What is in every picture that the program draws, and near the beginning of the page beside them.
char const* picture_mark(std::string const& name) {
  return name.ends_with(".svg") ? "run-sheet" : "name=\"generator\" content=\"actio\"";
}

}  // namespace

OwnFiles::OwnFiles(std::string const& folder)
    : folder_(folder), handle_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (handle_ < 0) throw FileError(folder + ": cannot be opened: " + std::strerror(errno));
  try {
    if (Within(handle_, list_name).mode())
      read_list();
    else
      recognise_run_without_list();
  } catch (...) {
    ::close(handle_);
    throw;
  }
}
OwnFiles::~OwnFiles() { ::close(handle_); }

void OwnFiles::fail(std::string const& name, std::string const& what) const {
  throw FileError(folder_ + "/" + name + ": " + what + ": " + std::strerror(errno));
}

void OwnFiles::read_list() {
  auto const text = read_file(handle_, list_name, std::size_t{1} << 26);
  std::string_view left = text ? std::string_view(*text) : "";
  // The writer of a heading that is not whole was killed before it wrote anything else.
  for (Of const of : {Of::run, Of::member, Of::sweep})
    if (text && (left.starts_with(heading_of(of)) || heading_of(of).starts_with(left))) of_ = of;
  if (of_ == Of::nothing)
    throw SceneError({folder_ + "/" + list_name},
                     "a list of the files that actio wrote is expected, and this is none; move "
                     "it away, or name another folder");
  for (Of const of : {Of::run, Of::member, Of::sweep})
    if (left.starts_with(heading_of(of))) of_ = of;
  left.remove_prefix(std::min(left.size(), heading_of(of_).size()));
  for (std::size_t end; (end = left.find('\n')) != std::string_view::npos; left.remove_prefix(end + 1)) {
    std::string_view const line = left.substr(0, end);
    if (of_ == Of::sweep && line.starts_with(members_word))
      std::from_chars(line.data() + members_word.size(), line.data() + line.size(), members_);
    else if (is_name(line))
      names_.emplace(line);
    else
      throw SceneError({folder_ + "/" + list_name},
                       "'" + shown(line, 100) + "' is no name of a file in this folder; nothing is removed");
  }
}

void OwnFiles::recognise_run_without_list() {
  auto const checkpoint = read_file(handle_, "checkpoint", 64);
  if (!checkpoint || !checkpoint->starts_with("actio checkpoint ") || !read_file(handle_, "scene.toml", 1))
    return;
  of_ = Of::run;
  for (char const* name : {"scene.toml", "series.csv", "series.h5", "summary.json", "checkpoint",
                           "scene.toml.part", "summary.json.part", "checkpoint.part"})
    names_.insert(name);
  // Its pictures are known by what is in them.
  Within const plots(handle_, "plots/");
  if (!plots.there()) return;
  for (auto const& name : entries_of(plots.at()))
    if (auto const text = read_file(plots.at(), name.c_str(), 1 << 12);
        text && (name == "index.html" || name.ends_with(".svg")) &&
        text->find(picture_mark(name)) != std::string::npos)
      names_.insert("plots/" + name);
}

bool OwnFiles::alone() const {
  for (auto const& name : entries_of(handle_))
    if (name != list_name || of_ == Of::nothing) return false;
  return true;
}

void OwnFiles::refuse_taken(std::string const& name) const {
  Within const within(handle_, name);
  auto const mode = within.mode();
  if (mode && !has(name))
    throw SceneError({folder_ + "/" + name},
                     "is there already, and actio did not write it; move it away, or name another folder");
  if (mode && S_ISLNK(*mode))
    throw SceneError({folder_ + "/" + name},
                     "is a link, and nothing is written through it; move it away, or name another folder");
}

void OwnFiles::append(std::string const& text) {
  int const file = ::openat(handle_, list_name, O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0) fail(list_name, "cannot be opened");
  std::string_view left = text;
  while (!left.empty()) {
    ssize_t const n = ::write(file, left.data(), left.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      int const error = errno;
      ::close(file);
      errno = error;
      fail(list_name, "cannot be written");
    }
    left.remove_prefix(static_cast<std::size_t>(n));
  }
  ::close(file);
}

void OwnFiles::begin(Of of, std::vector<std::string> const& names, long members) {
  if (of_ != Of::nothing && ::unlinkat(handle_, list_name, 0) != 0 && errno != ENOENT)
    fail(list_name, "cannot be removed");
  of_ = of, names_.clear(), members_ = members;
  for (auto const& name : names) refuse_taken(name);
  std::string text(heading_of(of));
  if (members > 0) text += std::string(members_word) + std::to_string(members) + "\n";
  for (auto const& name : names) text += name + "\n";
  append(text);
  names_.insert(names.begin(), names.end());
}

void OwnFiles::claim(std::vector<std::string> const& names) {
  std::string text;
  std::vector<std::string> fresh;  // folders in which nothing can be yet
  for (std::string const within : folders_within)
    for (auto const& name : names)
      if (name.starts_with(within + "/")) {
        bool const made = ::mkdirat(handle_, within.c_str(), 0777) == 0;
        if (!made && errno != EEXIST) fail(within, "cannot be made");
        if (made) fresh.push_back(within + "/");
        if (!Within(handle_, within + "/").there())
          throw SceneError({folder_ + "/" + within},
                           "a folder is expected, and this is a file or a link; move it away");
        break;
      }
  // A folder without a list gets one, with all that it is known by.
  bool const unlisted = !Within(handle_, list_name).mode();
  if (unlisted) text = heading_of(of_ = of_ == Of::nothing ? Of::run : of_);
  if (unlisted)
    for (auto const& name : names_) text += name + "\n";
  for (auto const& name : names) {
    if (std::ranges::none_of(fresh, [&](auto const& folder) { return name.starts_with(folder); }))
      refuse_taken(name);
    if (!has(name)) text += name + "\n";
  }
  if (!text.empty()) append(text);
  names_.insert(names.begin(), names.end());
}

void OwnFiles::check() const {
  for (auto const& name : names_) {
    auto const mode = Within(handle_, name).mode();
    if (mode && !S_ISREG(*mode))
      throw SceneError({folder_ + "/" + name},
                       std::string("is a ") + (S_ISLNK(*mode) ? "link" : "folder") +
                           ", and no file that actio wrote; move it away, or name another folder");
  }
}

void OwnFiles::unlink(std::string const& name) const {
  Within const within(handle_, name);
  if (!within.there()) return;
  if (::unlinkat(within.at(), within.name(), 0) != 0 && errno != ENOENT) fail(name, "cannot be removed");
}

void OwnFiles::clear(std::string const& within) {
  check();
  for (auto const& name : names_)
    if (name.starts_with(within + "/")) unlink(name);
}

void OwnFiles::remove() {
  check();
  // Without its checkpoint a run starts anew from its scene.
  unlink("checkpoint");
  for (auto const& name : names_)
    if (name != "scene.toml") unlink(name);
  if (has("scene.toml")) unlink("scene.toml");
  for (std::string const within : folders_within)
    if (std::any_of(names_.begin(), names_.end(),
                    [&](auto const& name) { return name.starts_with(within + "/"); }) &&
        ::unlinkat(handle_, within.c_str(), AT_REMOVEDIR) != 0 && errno != ENOENT && errno != ENOTEMPTY &&
        errno != EEXIST && errno != ENOTDIR)
      fail(within, "cannot be removed");
  if (::unlinkat(handle_, list_name, 0) != 0 && errno != ENOENT) fail(list_name, "cannot be removed");
  of_ = Of::nothing, names_.clear(), members_ = 0;
}

}  // namespace actio::scene
