// A data set for each quantity, in a file that is consistent at any instant: HDF5's mode of a single writer and many readers.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

#include "actio/scene/hdf5_library.hpp"
#include "actio/scene/series.hpp"

namespace actio::scene {
namespace {

using hdf5::Handle, hdf5::Session;

/// One quantity in the file, and those of its rows that wait.
struct DataSet {
  ColumnGroup group;
  std::vector<hsize_t> extent;  // rows, then the shape of a value
  std::size_t width = 1;        // of a row, in numbers
  std::vector<double> waiting = {};
  Handle id = {};

  explicit DataSet(ColumnGroup of) : group(std::move(of)), extent{0}, width(group.columns.size()) {
    for (std::size_t const n : group.shape()) extent.push_back(n);
  }
  std::string const& name() const { return group.quantity.name; }
};

std::vector<DataSet> data_sets(SeriesHead const& head) {
  std::vector<DataSet> out;
  Quantity time{"t", Quantity::Kind::scalar, "The time.", "t", head.time_unit, "", {}, false};
  out.emplace_back(ColumnGroup{time, {"t"}});
  for (auto const& group : head.groups) out.emplace_back(group);
  return out;
}

class Hdf5Series : public Series {
 public:
  Hdf5Series(std::string const& path, SeriesHead const& head, bool resume) : path_(path), sets_(data_sets(head)), expected_(static_cast<std::size_t>(std::max(1L, head.rows))) {
    std::size_t widest = 0;
    for (auto const& set : sets_) widest = std::max(widest, set.width);
    at_once_ = chunk(widest);
    Session const h5;
    if (resume) reopen(h5);
    else create(h5, head), start(h5);
  }
  ~Hdf5Series() override {
    Session const h5;
    try {
      if (failure_.empty()) write(h5);
      for (auto& set : sets_) check(h5, set.id.close(), "cannot be written");
      check(h5, file_.close(), "cannot be written");
    } catch (FileError const&) {
    }
  }

  void add(std::span<double const> row) override {
    rethrow();
    for (auto at = row.begin(); auto& set : sets_) set.waiting.insert(set.waiting.end(), at, at + static_cast<std::ptrdiff_t>(set.width)), at += static_cast<std::ptrdiff_t>(set.width);
    // Up to the end of a chunk, so that chunks are written whole.
    if (++waiting_ < at_once_ - written_ % at_once_) return;
    Session const h5;
    write(h5);
  }
  void flush() override {
    rethrow();
    Session const h5;
    write(h5);
  }
  void sync() override {
    flush();
    Session const h5;
    if (::fdatasync(descriptor(h5)) != 0 && errno != EINVAL) fail(path_ + ": cannot be written: " + std::strerror(errno));
  }
  void remember(Memory& memory) override {
    rethrow();
    memory(written_);
    if (!memory.reading()) return;
    Session const h5;
    cut_back(h5);
    start(h5);
  }

 private:
  /// Rows of a chunk of a data set: about 64 kB, a power of two, and no more than the run will have.
  std::size_t chunk(std::size_t width) const {
    constexpr std::size_t numbers = 1 << 13;
    return std::min(std::bit_floor(std::max<std::size_t>(1, numbers / width)), std::bit_ceil(expected_));
  }

  Handle access(Session const& h5) const {
    Handle access(h5->H5Pcreate(h5->H5P_CLS_FILE_ACCESS_ID_g_value), h5->H5Pclose);
    h5->H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    h5->H5Pset_file_locking(access, true, true);  // a file system without locks will do
    return access;
  }

  void create(Session const& h5, SeriesHead const& head) {
    file_ = Handle(check(h5, h5->H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access(h5)), "cannot be opened"), h5->H5Fclose);
    tell(h5, file_, "title", head.title);
    tell(h5, file_, "system", head.system);
    tell(h5, file_, "actio_version", ACTIO_VERSION);
    tell(h5, file_, "scene", head.scene);
    for (auto const& set : sets_) create(h5, set);
  }
  void create(Session const& h5, DataSet const& set) {
    auto most = set.extent, chunk_extent = set.extent;
    most[0] = H5S_UNLIMITED, chunk_extent[0] = chunk(set.width);
    int const rank = static_cast<int>(most.size());
    Handle const space(h5->H5Screate_simple(rank, set.extent.data(), most.data()), h5->H5Sclose);
    Handle const how(h5->H5Pcreate(h5->H5P_CLS_DATASET_CREATE_ID_g_value), h5->H5Pclose);
    check(h5, h5->H5Pset_chunk(how, rank, chunk_extent.data()), "cannot be written");
    h5->H5Pset_fill_time(how, H5D_FILL_TIME_NEVER);  // there are no rows but those that are written
    Handle const id(check(h5, h5->H5Dcreate2(file_, set.name().c_str(), h5->H5T_IEEE_F64LE_g_value, space, H5P_DEFAULT, how, H5P_DEFAULT), "cannot be written"), h5->H5Dclose);
    Quantity const& quantity = set.group.quantity;
    tell(h5, id, "meaning", quantity.meaning);
    tell(h5, id, "formula", quantity.formula);
    tell(h5, id, "unit", quantity.unit);
    tell(h5, id, "statement", quantity.statement);
    tell(h5, id, "columns", set.group.columns, true);
  }
  /// An attribute with one text, or with a list of texts; none where there is nothing to say.
  void tell(Session const& h5, hid_t object, char const* name, std::vector<std::string> const& texts, bool list) {
    if (!list && texts.front().empty()) return;
    Handle const type(h5->H5Tcopy(h5->H5T_C_S1_g_value), h5->H5Tclose);
    h5->H5Tset_size(type, H5T_VARIABLE);
    h5->H5Tset_cset(type, H5T_CSET_UTF8);
    hsize_t const size = texts.size();
    Handle const space(list ? h5->H5Screate_simple(1, &size, nullptr) : h5->H5Screate(H5S_SCALAR), h5->H5Sclose);
    Handle const attribute(check(h5, h5->H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), "cannot be written"), h5->H5Aclose);
    std::vector<char const*> pointers;
    for (auto const& text : texts) pointers.push_back(text.c_str());
    check(h5, h5->H5Awrite(attribute, type, pointers.data()), "cannot be written");
  }
  void tell(Session const& h5, hid_t object, char const* name, std::string const& text) { tell(h5, object, name, {text}, false); }

  /// Opens a file whose writer may have been killed.
  void reopen(Session const& h5) {
    Handle const access = this->access(h5);
    hbool_t const clear = true;
    h5->H5Pset(access, "clear_status_flags", &clear);  // as h5clear does
    file_ = Handle(check(h5, h5->H5Fopen(path_.c_str(), H5F_ACC_RDWR, access), "cannot be opened"), h5->H5Fclose);
    // What a killed writer had put at the end counts as taken.
    check(h5, h5->H5Fincrement_filesize(file_, 0), "cannot be opened");
  }
  void cut_back(Session const& h5) {
    for (auto& set : sets_) {
      Handle const id(check(h5, h5->H5Dopen2(file_, set.name().c_str(), H5P_DEFAULT), "cannot be opened"), h5->H5Dclose);
      Handle const space(check(h5, h5->H5Dget_space(id), "cannot be opened"), h5->H5Sclose);
      std::vector<hsize_t> there(set.extent.size());
      if (h5->H5Sget_simple_extent_ndims(space) != static_cast<int>(there.size()) || h5->H5Sget_simple_extent_dims(space, there.data(), nullptr) < 0) refuse(path_ + ": is not the table of this scene");
      if (there[0] < written_) refuse(path_ + ": has " + std::to_string(there[0]) + " rows, where the checkpoint needs " + std::to_string(written_) + "; it was cut since");
      set.extent[0] = written_;
      check(h5, h5->H5Dset_extent(id, set.extent.data()), "cannot be cut back");
    }
  }
  /// From here on the file is consistent at any instant.
  void start(Session const& h5) {
    check(h5, file_.close(), "cannot be written");
    file_ = Handle(check(h5, h5->H5Fopen(path_.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access(h5)), "cannot be opened"), h5->H5Fclose);
    // Numbers go to the file at once, past the library's cache: of those that it keeps back it would tell readers even where the disk then refuses them.
    Handle const how(h5->H5Pcreate(h5->H5P_CLS_DATASET_ACCESS_ID_g_value), h5->H5Pclose);
    h5->H5Pset_chunk_cache(how, 0, 0, 1);
    for (auto& set : sets_) set.id = Handle(check(h5, h5->H5Dopen2(file_, set.name().c_str(), how), "cannot be opened"), h5->H5Dclose);
  }

  /// What waits goes to the file.
  void write(Session const& h5) {
    if (waiting_ == 0) return;
    for (auto& set : sets_) {
      std::vector<hsize_t> first(set.extent.size()), size = set.extent;
      first[0] = written_, size[0] = waiting_;
      set.extent[0] = written_ + waiting_;
      check(h5, h5->H5Dset_extent(set.id, set.extent.data()), "cannot be written");
      Handle const space(check(h5, h5->H5Dget_space(set.id), "cannot be written"), h5->H5Sclose);
      Handle const memory(h5->H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), h5->H5Sclose);
      h5->H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, size.data(), nullptr);
      check(h5, h5->H5Dwrite(set.id, h5->H5T_NATIVE_DOUBLE_g_value, memory, space, H5P_DEFAULT, set.waiting.data()), "cannot be written");
      set.waiting.clear();
    }
    // Numbers first, then room for all that the library has laid out, and only then what tells readers of them: at whatever point the disk is full, the file is
    // as it was before these rows.
    reserve(h5);
    check(h5, h5->H5Fflush(file_, H5F_SCOPE_LOCAL), "cannot be written");
    written_ += waiting_, waiting_ = 0;
  }

  void reserve(Session const& h5) {
    hsize_t size = 0;
    check(h5, h5->H5Fget_filesize(file_, &size), "cannot be written");
    struct stat now;
    if (::fstat(descriptor(h5), &now) != 0) fail(path_ + ": cannot be written: " + std::strerror(errno));
    off_t const missing = static_cast<off_t>(size) - now.st_size;
    if (int const error = missing > 0 ? ::posix_fallocate(descriptor(h5), now.st_size, missing) : 0) fail(path_ + ": cannot be written: " + std::strerror(error));
  }
  int descriptor(Session const& h5) {
    void* at = nullptr;
    check(h5, h5->H5Fget_vfd_handle(file_, H5P_DEFAULT, &at), "cannot be written");
    return *static_cast<int*>(at);
  }

  hid_t check(Session const& h5, hid_t result, char const* what) {
    try {
      return h5.checked(result, path_, what);
    } catch (FileError const& error) {
      fail(error.what());
    }
  }
  /// The library does not close a file that it could not write. It is left as it is: what was flushed before is in it, and consistent.
  [[noreturn]] void fail(std::string const& what) {
    for (auto& set : sets_) set.id.abandon();
    file_.abandon();
    refuse(what);
  }
  [[noreturn]] void refuse(std::string const& what) {
    failure_ = what;
    throw FileError(what);
  }
  void rethrow() const {
    if (!failure_.empty()) throw FileError(failure_);
  }

  std::string path_, failure_;
  Handle file_;
  std::vector<DataSet> sets_;
  std::size_t expected_, at_once_;
  std::size_t written_ = 0, waiting_ = 0;  // rows
};

}  // namespace

std::unique_ptr<Series> hdf5_series(std::string const& path, SeriesHead const& head, bool resume) { return std::make_unique<Hdf5Series>(path, head, resume); }

}  // namespace actio::scene
