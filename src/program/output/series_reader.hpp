// The rows of a run, read back from the disk one after another: memory does not grow with their number.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "program/base/error.hpp"
#include "program/registry/quantity.hpp"

namespace actio::scene {

/// A table that a run left, from its first row to its last whole one.
class SeriesReader {
 public:
  virtual ~SeriesReader() = default;
  /// The next row, the time first; false where there is none.
  /// @throws FileError  where it cannot be read, or is no row of this table
  virtual bool next(std::span<double> row) = 0;
  /// How much of the table has been read, from 0 to 1.
  virtual double fraction() const = 0;
};

/// The table `series.csv` in a folder.
/// @param groups  the columns after the time
/// @throws FileError  where it is not there, or cannot be read, or has other columns
std::unique_ptr<SeriesReader> read_series(std::string const& folder, std::vector<ColumnGroup> const& groups);

/// The table `path` in comma-separated values.
/// @param columns  that it has, the time first
std::unique_ptr<SeriesReader> read_csv_series(std::string const& path,
                                              std::vector<std::string> const& columns);

}  // namespace actio::scene
