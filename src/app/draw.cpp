#include "app/draw.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "program/base/error.hpp"
#include "program/pictures/pictures.hpp"

namespace actio::app {
namespace {

namespace fs = std::filesystem;

/// Keeps a folder for this process while it lives. Some file systems have no locks; then there is none.
class Lock {
 public:
  explicit Lock(std::string const& folder)
      : handle_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (handle_ >= 0) ::flock(handle_, LOCK_EX);
  }
  ~Lock() {
    if (handle_ >= 0) ::close(handle_);
  }
  Lock(Lock const&) = delete;
  Lock& operator=(Lock const&) = delete;

 private:
  int handle_;
};

}  // namespace

void draw(scene::Scene const& scene, std::string const& folder, bool quiet) {
  std::error_code error;
  fs::create_directories(folder + "/plots", error);
  if (error) throw scene::FileError(folder + "/plots: the folder cannot be made: " + error.message());
  Lock const lock(folder + "/plots");
  scene::draw_pictures(scene, folder, quiet);
}

bool drawn(std::string const& folder) {
  // The page is drawn last, and the summary is written before the first picture.
  std::error_code page, summary;
  auto const drawn = fs::last_write_time(folder + "/plots/index.html", page),
             ended = fs::last_write_time(folder + "/summary.json", summary);
  return !page && (summary || drawn >= ended);
}

}  // namespace actio::app
