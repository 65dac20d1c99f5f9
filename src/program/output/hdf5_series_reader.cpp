// The data sets of a series in HDF5, read side by side in blocks of about a megabyte.
#include <algorithm>
#include <limits>

#include "program/output/hdf5_library.hpp"
#include "program/output/series_reader.hpp"

namespace actio::scene {
namespace {

using hdf5::Handle, hdf5::Session;

class Hdf5SeriesReader : public SeriesReader {
 public:
  Hdf5SeriesReader(std::string const& path, std::vector<ColumnGroup> const& groups)
      : path_(path), h5_(), rows_(std::numeric_limits<hsize_t>::max()) {
    Handle const access(h5_->H5Pcreate(h5_->H5P_CLS_FILE_ACCESS_ID_g_value), h5_->H5Pclose);
    h5_->H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    h5_->H5Pset_file_locking(access, false, true);
    file_ = Handle(h5_.checked(h5_->H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access), path_,
                               "cannot be read"),
                   h5_->H5Fclose);
    open("t", {});
    for (auto const& group : groups) open(group.quantity.name, group.shape());
    std::size_t width = 0;
    for (auto const& set : sets_) width += set.width;
    at_once_ = std::max<hsize_t>(1, (1 << 17) / width);
  }

  bool next(std::span<double> row) override {
    if (next_ >= rows_) return false;
    if (next_ >= block_end_) read_block();
    double* at = row.data();
    for (auto const& set : sets_)
      at = std::copy_n(set.block.data() + (next_ - block_begin_) * set.width, set.width, at);
    ++next_;
    return true;
  }
  double fraction() const override {
    return rows_ > 0 ? static_cast<double>(next_) / static_cast<double>(rows_) : 1;
  }

 private:
  struct DataSet {
    std::string name;
    Handle id;
    std::vector<hsize_t> extent;  // rows, then the shape of a value
    hsize_t chunk;                // rows of one
    std::size_t width;            // of a row, in numbers
    std::vector<double> block = {};
  };

  void open(std::string const& name, std::vector<std::size_t> const& shape) {
    Handle id(h5_.checked(h5_->H5Dopen2(file_, name.c_str(), H5P_DEFAULT), path_, "cannot be read"),
              h5_->H5Dclose);
    Handle const space(h5_.checked(h5_->H5Dget_space(id), path_, "cannot be read"), h5_->H5Sclose);
    std::vector<hsize_t> extent(1 + shape.size());
    if (h5_->H5Sget_simple_extent_ndims(space) != static_cast<int>(extent.size()) ||
        h5_->H5Sget_simple_extent_dims(space, extent.data(), nullptr) < 0 ||
        !std::equal(shape.begin(), shape.end(), extent.begin() + 1))
      throw FileError(path_ + ": the shape of '" + name + "' is not that of the scene");
    std::size_t width = 1;
    for (std::size_t const n : shape) width *= n;
    rows_ = std::min(rows_, extent[0]);
    Handle const how(h5_.checked(h5_->H5Dget_create_plist(id), path_, "cannot be read"), h5_->H5Pclose);
    std::vector<hsize_t> chunk(extent.size(), 1);
    h5_->H5Pget_chunk(how, static_cast<int>(chunk.size()), chunk.data());
    sets_.push_back({name, std::move(id), std::move(extent), chunk[0], width});
  }
  void read_block() {
    block_begin_ = next_, block_end_ = std::min(rows_, next_ + at_once_);
    for (auto& set : sets_)
      if (!read(set, block_begin_, block_end_))
        throw FileError(hdf5::damage(path_, set.name, block_begin_, block_end_));
  }
  /// @return false where a chunk cannot be read; `begin` and `end` are then those of the rows in it
  bool read(DataSet& set, hsize_t& begin, hsize_t& end) {
    if (read_rows(set, begin, end)) return true;
    hsize_t const last = end;
    for (begin -= begin % set.chunk; begin < last; begin = end) {
      end = std::min(last, begin + set.chunk);
      if (!read_rows(set, begin, end)) return false;
    }
    return false;
  }
  bool read_rows(DataSet& set, hsize_t begin, hsize_t end) {
    std::vector<hsize_t> first(set.extent.size()), size = set.extent;
    first[0] = begin, size[0] = end - begin;
    set.block.resize(size[0] * set.width);
    Handle const space(h5_.checked(h5_->H5Dget_space(set.id), path_, "cannot be read"), h5_->H5Sclose);
    Handle const memory(h5_->H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                        h5_->H5Sclose);
    h5_->H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, size.data(), nullptr);
    return h5_->H5Dread(set.id, h5_->H5T_NATIVE_DOUBLE_g_value, memory, space, H5P_DEFAULT,
                        set.block.data()) >= 0;
  }

  std::string path_;
  Session h5_;  // as long as the reader: no other series is open meanwhile
  Handle file_;
  std::vector<DataSet> sets_;
  hsize_t rows_, at_once_ = 0, next_ = 0, block_begin_ = 0, block_end_ = 0;
};

}  // namespace

std::unique_ptr<SeriesReader> read_hdf5_series(std::string const& path,
                                               std::vector<ColumnGroup> const& groups) {
  return std::make_unique<Hdf5SeriesReader>(path, groups);
}

}  // namespace actio::scene
