// Linear conditions with few terms each, and the numbers that meet them all.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace actio::systems::detail {

/// A row of a matrix, or a vector: its entries that are not zero, by their column.
using SparseRow = std::map<int, double>;

/// Rows in reduced echelon form, to which rows are added one by one: each has a pivot of 1 in a column where
/// all others are zero. In a new row the pivot is the largest entry, of equal ones the last.
///
/// Coefficients that are small whole numbers stay fractions with small denominators, and rounding does not
/// pile up; in general an entry counts as zero below 1e-9 of the largest of its row.
class SparseElimination {
 public:
  /// Of that many columns.
  explicit SparseElimination(int columns) : row_of_pivot_(n(columns), -1), rows_with_(n(columns)) {}

  /// Adds a row, if it is far enough from the span of those before: pivots that are differences of nearly
  /// equal numbers would carry their rounding into all rows.
  /// @param least  the distance, relative to the largest entry, from which the row is added
  /// @return       the distance; zero where the row is a combination of those before
  double add(SparseRow const& row, double least = 0);

  /// All rows, in the order in which they were added.
  std::vector<SparseRow> const& rows() const { return rows_; }

  /// A basis of the vectors that all rows take to zero: one for each column without a pivot.
  std::vector<SparseRow> null_space() const;

 private:
  static constexpr double negligible_ = 1e-9;
  std::vector<SparseRow> rows_;
  std::vector<int> row_of_pivot_;         // of a column, or -1
  std::vector<std::set<int>> rows_with_;  // an entry in a column
  static std::size_t n(int i) { return static_cast<std::size_t>(i); }

  static double largest_of(SparseRow const& row) {
    double largest = 0;
    for (auto const& [column, x] : row) largest = std::max(largest, std::abs(x));
    return largest;
  }
  int pivot_of(int row) const {
    for (auto const& [column, x] : rows_[n(row)])
      if (row_of_pivot_[n(column)] == row) return column;
    return -1;
  }
  /// Without the columns that are pivots, and without rounding noise.
  SparseRow reduced(SparseRow const& row) const;
  void eliminate(int k, int pivot, SparseRow const& by);
};

}  // namespace actio::systems::detail
