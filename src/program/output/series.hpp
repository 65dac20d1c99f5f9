// The table that a run leaves: a row per output instant, the time first.
//
// `series.csv` is a text with a header row, and numbers with 17 significant digits: those that were computed,
// bit for bit. It can be read while the run goes on and whatever ended it, Ctrl-C, `kill -9` or a full disk.
// Rows are in the file half a second after they were computed at the latest, so that `kill -9` and a full
// disk take no more than those of the last half second with them; a loss of power takes no more than those
// since the last checkpoint, two seconds before. What is lost is computed again by `resume`.
//
// A table in HDF5 is made of it, whole (hdf5_series.hpp).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "program/base/checkpoint_stream.hpp"
#include "program/base/error.hpp"
#include "program/registry/quantity.hpp"

namespace actio::scene {

/// A table that grows by rows, on disk or elsewhere. A reader finds whole rows at any instant.
/// After an error there is no going on: whatever is called throws it again.
class Series {
 public:
  virtual ~Series() = default;
  /// One row more. It may wait in memory until `flush`.
  /// @throws FileError  where the disk is full; rows that were there are kept whole
  virtual void add(std::span<double const> row) = 0;
  /// Every row so far is in the file, for others to see.
  virtual void flush() = 0;
  /// Every row so far is on the disk.
  virtual void sync() = 0;
  /// Saves how far the table goes, after `sync`; or cuts it back to there.
  virtual void remember(CheckpointStream& stream) = 0;
};

/// What a table tells besides its numbers.
struct SeriesHead {
  std::string title,                ///< of the scene
      system;                       ///< the name of its kind of system
  std::string scene;                ///< in TOML, defaults written out
  std::vector<ColumnGroup> groups;  ///< the columns after the time
  long rows = 0;                    ///< expected; a matter of speed alone
  std::string time_unit = "time";   ///< of `t`, as it is called

  /// The names of all columns, the time first.
  std::vector<std::string> columns() const;
};

/// The table `series.csv` in a folder, written by a thread of its own where it is large; new, or there and
/// cut back by `remember`.
/// @throws FileError
std::unique_ptr<Series> open_series(std::string const& folder, SeriesHead const& head, bool resume);

/// A new table `path`, or one that is there and will be cut back by `remember`.
/// @throws FileError
std::unique_ptr<Series> csv_series(std::string const& path, std::vector<std::string> const& columns,
                                   bool resume);

/// The same table, with rows formatted and written by a thread of its own. No more than a few blocks of rows
/// wait for it, however long the run; an error of the writer comes out of whatever is called next.
std::unique_ptr<Series> in_background(std::unique_ptr<Series> series);

}  // namespace actio::scene
