// The table that a run leaves: a row per output instant, the time first.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "actio/scene/memory.hpp"
#include "actio/scene/scene_error.hpp"

namespace actio::scene {

/// A table that grows by rows, on disk or elsewhere. Whoever looks at it at any instant finds whole rows.
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
  virtual void remember(Memory& memory) = 0;
};

/// A new table `path`, or one that is there and will be cut back by `remember`.
/// @throws FileError
std::unique_ptr<Series> csv_series(std::string const& path, std::vector<std::string> const& columns, bool resume);

}  // namespace actio::scene
