#include "program/run/exports.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "program/output/hdf5_series.hpp"
#include "program/output/series_reader.hpp"
#include "program/run/run.hpp"
#include "program/run/run_files.hpp"

namespace actio::scene {
namespace {

/// Of two processes that would make the same file one waits: they lock the list of the program's files. Some
/// file systems have no locks; then there is none.
class OneAtATime {
 public:
  OneAtATime(std::string const& folder, bool wait)
      : list_(::open((folder + "/.actio").c_str(), O_RDWR | O_CLOEXEC)) {
    struct flock whole = {};
    whole.l_type = F_WRLCK, whole.l_whence = SEEK_SET;
    if (list_ >= 0 && ::fcntl(list_, wait ? F_OFD_SETLKW : F_OFD_SETLK, &whole) != 0)
      others_ = errno == EAGAIN || errno == EACCES;
  }
  ~OneAtATime() {
    if (list_ >= 0) ::close(list_);
  }
  OneAtATime(OneAtATime const&) = delete;
  OneAtATime& operator=(OneAtATime const&) = delete;
  bool others() const { return others_; }

 private:
  int list_;
  bool others_ = false;
};

bool has_snapshots(Scene const& scene) { return scene.snapshots && scene.simulation.snapshots; }

/// Those of the snapshots that are whole.
std::vector<double> times_in(std::string const& folder) {
  std::vector<double> out;
  auto const reader = read_csv_series(folder + "/" + times_of_snapshots, {"snapshot", "t"});
  for (std::vector<double> row(2); reader->next(row);) out.push_back(row[1]);
  return out;
}

}  // namespace

std::vector<std::string> formats_of_exports(Scene const& scene) {
  std::vector<std::string> out{"hdf5"};
  if (scene.system->snapshots)
    for (auto const& format : scene.system->snapshots->formats) out.push_back(format.name);
  return out;
}

std::vector<std::string> files_of_export(Scene const& scene, std::string const& format, long taken) {
  std::vector<std::string> out;
  if (format == "hdf5") out.emplace_back("series.h5");
  if (has_snapshots(scene))
    for (auto& name : scene.simulation.snapshots->files_in(format, taken)) out.push_back(std::move(name));
  return out;
}

bool make_exports(Scene const& scene, std::string const& folder, std::vector<std::string> const& formats,
                  Exporting const& how) {
  OneAtATime const alone(folder, how.wait);
  if (alone.others()) return false;
  for (auto const& format : formats) {
    if (format == "hdf5")
      make_hdf5_series(folder, series_head(scene, scene.file.written(), scene.schedule.rows()), how.durable,
                       how.see);
    if (format != "csv" && has_snapshots(scene))
      scene.simulation.snapshots->make(format, folder, times_in(folder), how.durable);
  }
  return true;
}

}  // namespace actio::scene
