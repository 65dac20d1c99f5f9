#include "program/output/hdf5_series_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "program/base/whole_file.hpp"
#include "program/output/hdf5_attributes.hpp"
#include "program/output/hdf5_file.hpp"

namespace actio::scene::hdf5 {
namespace {

std::vector<DataSet> data_sets(SeriesHead const& head) {
  std::vector<DataSet> out;
  Quantity time{"t", Quantity::Kind::scalar, "The time.", "t", head.time_unit, "", {}};
  out.emplace_back(ColumnGroup{time, {"t"}});
  for (auto const& group : head.groups) out.emplace_back(group);
  return out;
}

/// Rows of a chunk, the same for all data sets: about 64 kB of the widest, more where that would be few; a
/// power of two, and no more than the run has.
std::size_t rows_of_chunk(std::size_t widest, std::size_t expected) {
  constexpr std::size_t numbers = 1 << 13, most = 1 << 17, few = 64;
  std::size_t const rows = std::max(numbers / widest, std::min(few, most / widest));
  return std::min(std::bit_floor(std::max<std::size_t>(1, rows)), std::bit_ceil(expected));
}

}  // namespace

SeriesFile::SeriesFile(std::string path, SeriesHead const& head)
    : path_(std::move(path)), sets_(data_sets(head)) {
  std::size_t widest = 1;
  for (auto const& set : sets_) widest = std::max(widest, set.width);
  at_once_ = hdf5::rows_of_chunk(widest, static_cast<std::size_t>(std::max(1L, head.rows)));
}
SeriesFile SeriesFile::make(Session const& h5, std::string const& path, SeriesHead const& head) {
  SeriesFile file(path, head);
  file.create(h5, head);
  return file;
}
SeriesFile SeriesFile::find(Session const& h5, std::string const& path, SeriesHead const& head) {
  SeriesFile file(path, head);
  file.look(h5);
  return file;
}

std::size_t SeriesFile::width() const {
  std::size_t width = 0;
  for (auto const& set : sets_) width += set.width;
  return width;
}

void SeriesFile::create(Session const& h5, SeriesHead const& head) {
  // Under another name: before it can be read by anybody it does not have its own.
  std::string const part = path_ + ".part";
  struct stat there;
  if (::lstat(path_.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
    refuse(path_ + ": cannot be opened: it is no ordinary file");
  ::unlink(part.c_str());
  Handle const how(h5->H5Pcreate(h5->H5P_CLS_FILE_CREATE_ID_g_value), h5->H5Pclose);
  h5->H5Pset_obj_track_times(how, false);  // equal runs leave equal bytes
  hid_t const made = h5->H5Fcreate(part.c_str(), H5F_ACC_TRUNC, how, access_to_growing_file(h5));
  file_ = Handle(check(h5, made, "cannot be opened"), h5->H5Fclose);
  tell(h5, file_, "title", head.title);
  tell(h5, file_, "system", head.system);
  tell(h5, file_, "actio_version", ACTIO_VERSION);
  tell(h5, file_, "scene", head.scene);
  for (auto const& set : sets_) create(h5, set);
  check(h5, file_.close(), "cannot be written");
  open(h5, part);
  if (std::rename(part.c_str(), path_.c_str()) != 0)
    fail(path_ + ": cannot be opened: " + std::strerror(errno));
}
void SeriesFile::create(Session const& h5, DataSet const& set) {
  auto most = set.extent, chunk_extent = set.extent;
  most[0] = H5S_UNLIMITED, chunk_extent[0] = at_once_;
  int const rank = static_cast<int>(most.size());
  Handle const space(h5->H5Screate_simple(rank, set.extent.data(), most.data()), h5->H5Sclose);
  Handle const how(h5->H5Pcreate(h5->H5P_CLS_DATASET_CREATE_ID_g_value), h5->H5Pclose);
  check(h5, h5->H5Pset_chunk(how, rank, chunk_extent.data()), "cannot be written");
  check(h5, h5->H5Pset_fletcher32(how), "cannot be written");
  h5->H5Pset_fill_time(how, H5D_FILL_TIME_NEVER);  // there are no rows but those that are written
  h5->H5Pset_obj_track_times(how, false);
  hid_t const type = h5->H5T_NATIVE_DOUBLE_g_value;  // chunks are written as they are in memory
  hid_t const made = h5->H5Dcreate2(file_, set.name().c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT);
  Handle const id(check(h5, made, "cannot be written"), h5->H5Dclose);
  Quantity const& quantity = set.group.quantity;
  tell(h5, id, "meaning", quantity.meaning);
  tell(h5, id, "formula", quantity.formula);
  tell(h5, id, "unit", quantity.unit);
  tell(h5, id, "statement", quantity.statement);
  tell(h5, id, "columns", set.group.columns);
}
/// An attribute with one text or a list of them.
template <class Texts>
void SeriesFile::tell(Session const& h5, hid_t object, char const* name, Texts const& texts) {
  guarded([&] { return attach(h5, path_, object, name, texts), 0; }, "cannot be written");
}

/// That the file to go on with is there, and is a table of this scene; how long its chunks are.
void SeriesFile::look(Session const& h5) {
  require_there(path_);
  hid_t const opened = h5->H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access_to_growing_file(h5));
  Handle const file(check(h5, opened, "cannot be opened"), h5->H5Fclose);
  for (auto& set : sets_) {
    Handle const id(check(h5, h5->H5Dopen2(file, set.name().c_str(), H5P_DEFAULT), "cannot be opened"),
                    h5->H5Dclose);
    Handle const space(check(h5, h5->H5Dget_space(id), "cannot be opened"), h5->H5Sclose);
    Handle const how(check(h5, h5->H5Dget_create_plist(id), "cannot be opened"), h5->H5Pclose);
    std::vector<hsize_t> there(set.extent.size()), chunk(set.extent.size());
    bool const like = h5->H5Sget_simple_extent_ndims(space) == static_cast<int>(there.size()) &&
                      h5->H5Sget_simple_extent_dims(space, there.data(), nullptr) >= 0 &&
                      std::equal(there.begin() + 1, there.end(), set.extent.begin() + 1) &&
                      h5->H5Pget_chunk(how, static_cast<int>(chunk.size()), chunk.data()) >= 0 &&
                      (&set == &sets_[0] || chunk[0] == at_once_);
    if (!like) refuse(path_ + ": is not the table of this scene");
    set.extent[0] = there[0], at_once_ = chunk[0];
  }
}

void SeriesFile::open(Session const& h5) { open(h5, path_); }
void SeriesFile::open(Session const& h5, std::string const& path) {
  hid_t const opened =
      h5->H5Fopen(path.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access_to_growing_file(h5));
  file_ = Handle(check(h5, opened, "cannot be opened"), h5->H5Fclose);
  Handle const how(h5->H5Pcreate(h5->H5P_CLS_DATASET_ACCESS_ID_g_value), h5->H5Pclose);
  h5->H5Pset_chunk_cache(how, 0, 0, 1);
  for (auto& set : sets_)
    set.id =
        Handle(check(h5, h5->H5Dopen2(file_, set.name().c_str(), how), "cannot be opened"), h5->H5Dclose);
}
void SeriesFile::close(Session const& h5) {
  for (auto& set : sets_) check(h5, set.id.close(), "cannot be written");
  check(h5, file_.close(), "cannot be written");
}
void SeriesFile::cut_back(Session const& h5, std::size_t rows) {
  HeadsOnly const heads_only;
  hid_t const opened = h5->H5Fopen(path_.c_str(), H5F_ACC_RDWR, access_to_growing_file(h5));
  Handle file(check(h5, opened, "cannot be opened"), h5->H5Fclose);
  for (auto& set : sets_) {
    if (set.extent[0] == rows) continue;
    set.extent[0] = rows;
    Handle id(check(h5, h5->H5Dopen2(file, set.name().c_str(), H5P_DEFAULT), "cannot be opened"),
              h5->H5Dclose);
    check(h5, h5->H5Dset_extent(id, set.extent.data()), "cannot be cut back");
    check(h5, id.close(), "cannot be cut back");
  }
  check(h5, file.close(), "cannot be cut back");
}

void SeriesFile::flush(Session const& h5) {
  check(h5, h5->H5Fflush(file_, H5F_SCOPE_LOCAL), "cannot be written");
}
int SeriesFile::descriptor(Session const& h5) {
  void* at = nullptr;
  check(h5, h5->H5Fget_vfd_handle(file_, H5P_DEFAULT, &at), "cannot be written");
  return *static_cast<int*>(at);
}
void SeriesFile::refuse_lost(Session const& h5) {
  if (!has_its_name(descriptor(h5), path_)) fail(lost_its_name(path_));
}
void SeriesFile::sync(Session const& h5) {
  if (::fdatasync(descriptor(h5)) != 0 && errno != EINVAL)
    fail(path_ + ": cannot be written: " + std::strerror(errno));
}

hid_t SeriesFile::check(Session const& h5, hid_t result, char const* what) {
  return guarded([&] { return h5.checked(result, path_, what); }, what);
}
/// What went wrong ends the writing, and is told with what the system says of it.
template <class Act>
hid_t SeriesFile::guarded(Act const& act, char const* what) {
  try {
    return act();
  } catch (FileError const& error) {
    std::string const system = driver_failure();
    fail(system.empty() ? error.what() : path_ + ": " + what + ": " + system);
  }
}
/// The library does not close a file that it could not write. It is left as it is: what was flushed before is
/// in it, and consistent.
void SeriesFile::fail(std::string const& what) {
  for (auto& set : sets_) set.id.abandon();
  file_.abandon();
  refuse(what);
}
void SeriesFile::refuse(std::string const& what) {
  failure_ = what;
  throw FileError(what);
}
void SeriesFile::rethrow() const {
  if (has_failed()) throw FileError(failure_);
}

}  // namespace actio::scene::hdf5
