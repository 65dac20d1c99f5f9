// The file of a series in HDF5 with its data sets: how it is made, found again and cut back, and what becomes
// of it when something goes wrong.
#pragma once

#include <string>
#include <vector>

#include "program/output/hdf5_library.hpp"
#include "program/output/series.hpp"

namespace actio::scene::hdf5 {

/// One quantity in the file.
struct DataSet {
  ColumnGroup group;            ///< the quantity, and its columns
  std::vector<hsize_t> extent;  ///< rows, then the shape of a value
  std::size_t width;            ///< of a row, in numbers
  Handle id = {};               ///< open while the file grows

  /// Without rows.
  explicit DataSet(ColumnGroup of) : group(std::move(of)), extent{0}, width(group.columns.size()) {
    for (std::size_t const n : group.shape()) extent.push_back(n);
  }
  /// What both the quantity and the data set are called.
  std::string const& name() const { return group.quantity.name; }
};

/// A file with a data set for the time and one for each quantity. `close` closes it; after an error it is
/// left as it is.
class SeriesFile {
 public:
  /// A new file, open to grow.
  /// @throws FileError  where it cannot be made
  static SeriesFile make(Session const& h5, std::string const& path, SeriesHead const& head);
  /// A file that is there, and is to be gone on with: it is looked at, and not opened to grow.
  /// @throws FileError  where it is not there, or is not the table of this scene
  static SeriesFile find(Session const& h5, std::string const& path, SeriesHead const& head);

  std::string const& path() const { return path_; }           ///< where it is
  std::vector<DataSet>& sets() { return sets_; }              ///< the time first
  std::vector<DataSet> const& sets() const { return sets_; }  ///< the time first
  std::size_t rows_of_chunk() const { return at_once_; }      ///< the same for all data sets
  std::size_t width() const;                                  ///< of a row of all data sets, in numbers

  bool is_open() const { return file_ >= 0; }            ///< whether it can grow
  bool has_failed() const { return !failure_.empty(); }  ///< whether something went wrong
  /// @throws FileError  what went wrong before, where anything did
  void rethrow() const;

  /// Opens it to grow: from here on it is consistent at any instant.
  void open(Session const& h5);
  /// Closes it and its data sets, where they are open.
  void close(Session const& h5);
  /// Rows beyond these are not told of any more. The chunks that have them stay, and are written again. The
  /// file is not open.
  void cut_back(Session const& h5, std::size_t rows);
  /// What the file tells of itself follows what was written.
  void flush(Session const& h5);
  /// Refuses a file that was removed, or that another was put in the place of.
  /// @throws FileError
  void refuse_lost(Session const& h5);
  /// Everything so far is on the disk.
  void sync(Session const& h5);

  /// What the library returned, where it went well.
  /// @param what  "cannot be written", for the complaint
  /// @throws FileError  otherwise, and from then on from `rethrow`, with what the system says of it
  hid_t check(Session const& h5, hid_t result, char const* what);
  /// Ends the writing, with a complaint about what the file holds.
  /// @throws FileError  always, and from then on from `rethrow`
  [[noreturn]] void refuse(std::string const& what);

 private:
  SeriesFile(std::string path, SeriesHead const& head);

  void create(Session const& h5, SeriesHead const& head);
  void create(Session const& h5, DataSet const& set);
  void look(Session const& h5);
  void open(Session const& h5, std::string const& path);
  int descriptor(Session const& h5);
  template <class Texts>
  void tell(Session const& h5, hid_t object, char const* name, Texts const& texts);
  template <class Act>
  hid_t guarded(Act const& act, char const* what);
  [[noreturn]] void fail(std::string const& what);

  std::string path_, failure_;
  Handle file_;
  std::vector<DataSet> sets_;
  std::size_t at_once_ = 1;  // rows of a chunk
};

}  // namespace actio::scene::hdf5
