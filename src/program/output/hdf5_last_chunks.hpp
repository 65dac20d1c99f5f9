// The last chunk of each data set of a series: it grows until it is full, and can be read at any instant.
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
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "program/output/hdf5_series_file.hpp"

namespace actio::scene::hdf5 {

/// The last chunks of the data sets of one file, all with the same rows.
class LastChunks {
 public:
  /// What a last chunk is.
  enum class Last {
    growing,  ///< rows will be put behind those that it has
    full      ///< it has all the rows that it will have
  };

  /// Empty ones.
  /// @param file  referred to; it is open where chunks are written
  explicit LastChunks(SeriesFile& file) : file_(file), chunks_(file.sets().size()) {}

  /// One row more, in memory: the numbers of all data sets.
  void add(std::span<double const> row);
  /// The chunks go to the file. Nothing tells of their new rows yet.
  /// @param rows  of the table, with these
  /// @throws FileError  where they cannot be written
  void write(Session const& h5, std::size_t rows, Last last);
  /// The last chunk of a table that was closed is said to have no checksum, and stays as it is: now it may
  /// grow.
  /// @throws FileError  where it cannot be read or written
  void unseal(Session const& h5);
  /// The file was cut back: from here on it may have a chunk where one is written, which is read first.
  void expect_chunks();

  /// Those of the rows in memory, for one data set after the other.
  std::vector<std::uint32_t> checksums() const;
  /// Bytes that were written since the last call of `tell`.
  std::size_t untold() const { return untold_; }
  /// The file tells of all that was written.
  /// @throws FileError  where it cannot
  void tell(Session const& h5) { file_.flush(h5), untold_ = 0; }

 private:
  struct Chunk {
    std::vector<double> rows = {};  // in memory
    bool behind = false;            // whether the file may have chunks that are written again
    hsize_t length = 0, place = 0;  // in the file; zero where it is not there yet
    std::span<unsigned char const> bytes() const {
      return {reinterpret_cast<unsigned char const*>(rows.data()), rows.size() * sizeof(double)};
    }
  };

  /// Bytes of a chunk that is full, and of one that grows.
  std::size_t full(DataSet const& set) const {
    return file_.rows_of_chunk() * set.width * sizeof(double) + 4;
  }
  std::size_t growing(DataSet const& set) const { return full(set) + 4; }
  void put(Session const& h5, DataSet const& set, Chunk& chunk, hsize_t begin, Last last);
  void get(Session const& h5, DataSet const& set, Chunk& chunk, hsize_t begin);

  SeriesFile& file_;
  std::vector<Chunk> chunks_;  // of the data sets, in their order
  std::vector<unsigned char> buffer_;
  std::size_t untold_ = 0;
};

}  // namespace actio::scene::hdf5
