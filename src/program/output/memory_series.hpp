// A table in memory: for a caller that uses the numbers in the same process.
#pragma once

#include "program/output/series.hpp"

namespace actio::scene {

/// A table is larger than the memory.
struct TooLarge : Error {
  /// @param rows     of the table
  /// @param columns  of numbers of eight bytes
  TooLarge(std::size_t rows, std::size_t columns);
};

/// Rows are added at the end of `table`, one after the other, which outlives the series. The memory for all
/// of them is taken at once.
/// @param rows, columns  of what the table will hold
/// @throws TooLarge
std::unique_ptr<Series> memory_series(std::vector<double>& table, std::size_t rows, std::size_t columns);

}  // namespace actio::scene
