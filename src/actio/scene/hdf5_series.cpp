// A data set for each quantity, in a file that any reader can open at any instant (hdf5_file.hpp), with a
// checksum on every chunk of numbers.
//
// A chunk that is written once is there, with its checksum, before anything tells of it. The last chunk is
// not: it grows. To write it anew in its place with a new checksum would not do, since a reader that looks in
// between, or after a kill in between, finds a checksum that is not that of the numbers, and cannot read the
// chunk at all. So as long as it grows it is said to have no checksum, a thing that HDF5 knows of each chunk,
// but it has room for one. Its first rows stay as they are while others are put behind them, and rows are
// told of when they are there. When it is full, its checksum is written into the room, and only then is it
// said to have one. (The library changes what it says of a chunk only where its length changes: one that
// grows is said to be four bytes longer.) A table that is closed has a checksum on its last chunk as well; a
// checkpoint remembers that of the last chunk, so that `resume` sees whatever bit was turned since.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include "actio/scene/hdf5_attributes.hpp"
#include "actio/scene/hdf5_checksums.hpp"
#include "actio/scene/hdf5_file.hpp"
#include "actio/scene/series.hpp"
#include "actio/scene/series_reader.hpp"

namespace actio::scene {
namespace {

using hdf5::Handle, hdf5::Session;

/// One quantity in the file, and its last chunk.
struct DataSet {
  ColumnGroup group;
  std::vector<hsize_t> extent;    // rows, then the shape of a value
  std::size_t width = 1;          // of a row, in numbers
  std::vector<double> last = {};  // rows of the chunk that grows
  bool behind = false;            // whether the file may have chunks that are written again
  hsize_t length = 0, place = 0;  // of the last chunk in the file; zero where it is not there yet
  Handle id = {};

  explicit DataSet(ColumnGroup of) : group(std::move(of)), extent{0}, width(group.columns.size()) {
    for (std::size_t const n : group.shape()) extent.push_back(n);
  }
  std::string const& name() const { return group.quantity.name; }
  std::span<unsigned char const> bytes() const {
    return {reinterpret_cast<unsigned char const*>(last.data()), last.size() * sizeof(double)};
  }
};

/// Where a chunk begins.
std::vector<hsize_t> place(DataSet const& set, hsize_t row) {
  std::vector<hsize_t> out(set.extent.size());
  out[0] = row;
  return out;
}

std::vector<DataSet> data_sets(SeriesHead const& head) {
  std::vector<DataSet> out;
  Quantity time{"t", Quantity::Kind::scalar, "The time.", "t", head.time_unit, "", {}, false};
  out.emplace_back(ColumnGroup{time, {"t"}});
  for (auto const& group : head.groups) out.emplace_back(group);
  return out;
}

class Hdf5Series : public Series {
 public:
  Hdf5Series(std::string const& path, SeriesHead const& head, bool resume)
      : path_(path), sets_(data_sets(head)), groups_(head.groups) {
    std::size_t widest = 1;
    for (auto const& set : sets_) widest = std::max(widest, set.width);
    at_once_ = chunk(widest, static_cast<std::size_t>(std::max(1L, head.rows)));
    Session const h5;
    if (resume)
      look(h5);
    else
      create(h5, head);
  }
  ~Hdf5Series() override {
    if (failure_.empty() && file_ < 0) return;  // it was to be gone on with, and was not
    Session const h5;
    try {
      if (failure_.empty()) seal(h5);
      for (auto& set : sets_) check(h5, set.id.close(), "cannot be written");
      check(h5, file_.close(), "cannot be written");
    } catch (FileError const&) {
    }
  }

  void add(std::span<double const> row) override {
    rethrow();
    for (auto at = row.begin(); auto& set : sets_) {
      auto const end = at + static_cast<std::ptrdiff_t>(set.width);
      set.last.insert(set.last.end(), at, end), at = end;
    }
    if (++rows_ % at_once_ != 0) return;
    Session const h5;
    write(h5, Last::full);
    if (untold_ > enough) tell(h5);
  }
  void flush() override {
    rethrow();
    if (told_ == rows_) return;
    Session const h5;
    if (rows_ % at_once_ != 0) write(h5, Last::growing);
    tell(h5);
  }
  void sync() override {
    flush();
    Session const h5;
    if (::fdatasync(descriptor(h5)) != 0 && errno != EINVAL)
      fail(path_ + ": cannot be written: " + std::strerror(errno));
  }
  void remember(CheckpointStream& stream) override {
    rethrow();
    std::vector<std::uint32_t> sums;
    for (auto const& set : sets_) sums.push_back(hdf5::fletcher32(set.bytes()));
    stream(rows_, sums);
    if (!stream.reading()) return;
    read_back(sums);
    Session const h5;
    unseal(h5);
    cut_back(h5);
    start(h5, path_);
    for (auto& set : sets_) set.behind = true;
    told_ = rows_;
  }

 private:
  /// What the last chunk is: still growing, or with all the rows that it will have.
  enum class Last { growing, full };
  static constexpr std::size_t enough = 1 << 17;  // bytes that are not told of

  /// Rows of a chunk, the same for all data sets: about 64 kB of the widest, more where that would be few; a
  /// power of two, and no more than the run has.
  static std::size_t chunk(std::size_t widest, std::size_t expected) {
    constexpr std::size_t numbers = 1 << 13, most = 1 << 17, few = 64;
    std::size_t const rows = std::max(numbers / widest, std::min(few, most / widest));
    return std::min(std::bit_floor(std::max<std::size_t>(1, rows)), std::bit_ceil(expected));
  }

  static Handle access(Session const& h5) { return hdf5::access_to_growing_file(h5); }

  void create(Session const& h5, SeriesHead const& head) {
    // Under another name: before it can be read by anybody it does not have its own.
    std::string const part = path_ + ".part";
    struct stat there;
    if (::lstat(path_.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
      refuse(path_ + ": cannot be opened: it is no ordinary file");
    ::unlink(part.c_str());
    Handle const how(h5->H5Pcreate(h5->H5P_CLS_FILE_CREATE_ID_g_value), h5->H5Pclose);
    h5->H5Pset_obj_track_times(how, false);  // equal runs leave equal bytes
    file_ = Handle(check(h5, h5->H5Fcreate(part.c_str(), H5F_ACC_TRUNC, how, access(h5)), "cannot be opened"),
                   h5->H5Fclose);
    tell(h5, file_, "title", head.title);
    tell(h5, file_, "system", head.system);
    tell(h5, file_, "actio_version", ACTIO_VERSION);
    tell(h5, file_, "scene", head.scene);
    for (auto const& set : sets_) create(h5, set);
    check(h5, file_.close(), "cannot be written");
    start(h5, part);
    if (std::rename(part.c_str(), path_.c_str()) != 0)
      fail(path_ + ": cannot be opened: " + std::strerror(errno));
  }
  void create(Session const& h5, DataSet const& set) {
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
  void tell(Session const& h5, hid_t object, char const* name, Texts const& texts) {
    guarded([&] { return hdf5::attach(h5, path_, object, name, texts), 0; }, "cannot be written");
  }

  /// That the file to go on with is there, and is a table of this scene; how long its chunks are.
  void look(Session const& h5) {
    Handle const file(check(h5, h5->H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access(h5)), "cannot be opened"),
                      h5->H5Fclose);
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
  /// Reads the rows that a checkpoint remembers, each chunk against its checksum; keeps those of the last
  /// chunk.
  void read_back(std::vector<std::uint32_t> const& sums) {
    for (auto const& set : sets_)
      if (set.extent[0] < rows_)
        refuse(path_ + ": has " + std::to_string(set.extent[0]) + " rows, where the checkpoint needs " +
               std::to_string(rows_) + "; it was cut since");
    auto const reader = read_hdf5_series(path_, groups_);
    std::size_t width = 0;
    for (auto const& set : sets_) width += set.width;
    std::vector<double> row(width);
    std::size_t const whole = rows_ - rows_ % at_once_;
    for (std::size_t k = 0; k < rows_; ++k) {
      if (!reader->next(row)) refuse(path_ + ": ends too early");
      if (k < whole) continue;
      for (auto at = row.begin(); auto& set : sets_) {
        auto const end = at + static_cast<std::ptrdiff_t>(set.width);
        set.last.insert(set.last.end(), at, end), at = end;
      }
    }
    for (std::size_t i = 0; i < sets_.size(); ++i)
      if (hdf5::fletcher32(sets_[i].bytes()) != sums[i])
        refuse(hdf5::damage(path_, sets_[i].name(), whole, rows_));
  }
  /// Rows that the checkpoint does not have are not told of any more. The chunks that have them stay, and are
  /// written again.
  void cut_back(Session const& h5) {
    hdf5::HeadsOnly const heads_only;
    Handle file(check(h5, h5->H5Fopen(path_.c_str(), H5F_ACC_RDWR, access(h5)), "cannot be opened"),
                h5->H5Fclose);
    for (auto& set : sets_) {
      if (set.extent[0] == rows_) continue;
      set.extent[0] = rows_;
      Handle id(check(h5, h5->H5Dopen2(file, set.name().c_str(), H5P_DEFAULT), "cannot be opened"),
                h5->H5Dclose);
      check(h5, h5->H5Dset_extent(id, set.extent.data()), "cannot be cut back");
      check(h5, id.close(), "cannot be cut back");
    }
    check(h5, file.close(), "cannot be cut back");
  }
  /// From here on the file is consistent at any instant.
  void start(Session const& h5, std::string const& path) {
    hid_t const opened = h5->H5Fopen(path.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access(h5));
    file_ = Handle(check(h5, opened, "cannot be opened"), h5->H5Fclose);
    Handle const how(h5->H5Pcreate(h5->H5P_CLS_DATASET_ACCESS_ID_g_value), h5->H5Pclose);
    h5->H5Pset_chunk_cache(how, 0, 0, 1);
    for (auto& set : sets_)
      set.id =
          Handle(check(h5, h5->H5Dopen2(file_, set.name().c_str(), how), "cannot be opened"), h5->H5Dclose);
  }

  /// Bytes of a chunk that is full, and of one that grows.
  std::size_t full(DataSet const& set) const { return at_once_ * set.width * sizeof(double) + 4; }
  std::size_t growing(DataSet const& set) const { return full(set) + 4; }

  /// The last chunk of each data set goes to the file. Nothing tells of its new rows yet.
  void write(Session const& h5, Last last) {
    hsize_t const begin = (rows_ - 1) / at_once_ * at_once_;
    for (auto& set : sets_) {
      if (set.extent[0] != rows_) {
        set.extent[0] = rows_;
        check(h5, h5->H5Dset_extent(set.id, set.extent.data()), "cannot be written");
      }
      // What is there from before it was cut back stays, for a reader that is about to read it.
      chunk_.assign(growing(set), 0);
      if (set.behind) get(h5, set, begin);
      // A chunk that was full has the rows that this one will have.
      if (last == Last::full || set.length != full(set)) {
        auto const numbers = set.bytes();
        std::copy(numbers.begin(), numbers.end(), chunk_.begin());
        put(h5, set, begin, last);
      }
      if (rows_ % at_once_ == 0) set.last.clear(), set.length = 0;
    }
  }
  void put(Session const& h5, DataSet& set, hsize_t begin, Last last) {
    std::size_t const size = last == Last::full ? full(set) : growing(set);
    auto const numbers = std::span(chunk_).first(full(set) - 4);
    if (last == Last::full) hdf5::encode(chunk_.data() + numbers.size(), hdf5::fletcher32(numbers));
    auto const at = place(set, begin);
    std::uint32_t const without_checksum = last == Last::full ? 0 : 1;
    std::optional<hdf5::InPlace> in_place;
    if (set.length != 0 && set.length != size) in_place.emplace(set.place);
    check(h5, h5->H5Dwrite_chunk(set.id, H5P_DEFAULT, without_checksum, at.data(), size, chunk_.data()),
          "cannot be written");
    set.length = size, set.place = hdf5::last_place();
    untold_ += size;
  }
  /// A chunk that is there, its length and its place. Where it is not, the others are not either.
  void get(Session const& h5, DataSet& set, hsize_t begin) {
    auto const at = place(set, begin);
    // Of a chunk that is not there the library says so by an error, or by a length of zero.
    set.length = 0;
    set.behind = h5->H5Dget_chunk_storage_size(set.id, at.data(), &set.length) >= 0 && set.length != 0;
    if (!set.behind) return;
    if (set.length != full(set) && set.length != growing(set))
      refuse(path_ + ": is not the table of this scene");
    std::uint32_t without_checksum = 0;
    check(h5, h5->H5Dread_chunk(set.id, H5P_DEFAULT, at.data(), &without_checksum, chunk_.data()),
          "cannot be read");
    set.place = hdf5::last_place();
  }
  /// What the file tells of itself follows what was written.
  void tell(Session const& h5) {
    check(h5, h5->H5Fflush(file_, H5F_SCOPE_LOCAL), "cannot be written");
    told_ = rows_, untold_ = 0;
  }
  /// The last chunk gets its checksum, for good.
  void seal(Session const& h5) {
    if (rows_ % at_once_ != 0) {
      write(h5, Last::growing), tell(h5);
      write(h5, Last::full);
    }
    tell(h5);
  }
  /// The last chunk of a table that was closed is said to have no checksum, and stays as it is: now it may
  /// grow.
  void unseal(Session const& h5) {
    start(h5, path_);
    for (auto& set : sets_) {
      if (set.extent[0] % at_once_ == 0) continue;
      hsize_t const begin = set.extent[0] - set.extent[0] % at_once_;
      chunk_.assign(growing(set), 0);
      get(h5, set, begin);
      if (set.length == full(set)) put(h5, set, begin, Last::growing);
      set.length = 0;
    }
    tell(h5);
    for (auto& set : sets_) check(h5, set.id.close(), "cannot be written");
    check(h5, file_.close(), "cannot be written");
  }

  int descriptor(Session const& h5) {
    void* at = nullptr;
    check(h5, h5->H5Fget_vfd_handle(file_, H5P_DEFAULT, &at), "cannot be written");
    return *static_cast<int*>(at);
  }

  hid_t check(Session const& h5, hid_t result, char const* what) {
    return guarded([&] { return h5.checked(result, path_, what); }, what);
  }
  /// What went wrong ends the writing, and is told with what the system says of it.
  template <class Act>
  hid_t guarded(Act const& act, char const* what) {
    try {
      return act();
    } catch (FileError const& error) {
      std::string const system = hdf5::driver_failure();
      fail(system.empty() ? error.what() : path_ + ": " + what + ": " + system);
    }
  }
  /// The library does not close a file that it could not write. It is left as it is: what was flushed before
  /// is in it, and consistent.
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
  std::vector<ColumnGroup> groups_;
  std::size_t at_once_ = 1;          // rows of a chunk
  std::size_t rows_ = 0, told_ = 0;  // all of them, and those that the file tells of
  std::size_t untold_ = 0;           // bytes written since
  std::vector<unsigned char> chunk_;
};

}  // namespace

std::unique_ptr<Series> hdf5_series(std::string const& path, SeriesHead const& head, bool resume) {
  return std::make_unique<Hdf5Series>(path, head, resume);
}

}  // namespace actio::scene
