// Linear conditions with few terms each, and the numbers that meet them all.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace actio::detail {

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
  double add(SparseRow const& row, double least = 0) {
    SparseRow rest = reduced(row);
    double const distance = rest.empty() ? 0 : largest_of(rest) / largest_of(row);
    if (rest.empty() || distance < least) return distance;
    int pivot = rest.begin()->first;
    double largest = 0;
    for (auto const& [column, x] : rest)
      if (std::abs(x) >= largest * (1 - negligible_))
        pivot = column, largest = std::max(largest, std::abs(x));
    double const scale = rest[pivot];
    for (auto& [column, x] : rest) x /= scale;
    rest[pivot] = 1;
    // The column of the pivot becomes zero in all other rows.
    for (int const k : std::set<int>(std::move(rows_with_[n(pivot)]))) eliminate(k, pivot, rest);
    int const number = static_cast<int>(rows_.size());
    row_of_pivot_[n(pivot)] = number;
    for (auto const& [column, x] : rest) rows_with_[n(column)].insert(number);
    rows_.push_back(std::move(rest));
    return distance;
  }

  /// All rows, in the order in which they were added.
  std::vector<SparseRow> const& rows() const { return rows_; }

  /// A basis of the vectors that all rows take to zero: one for each column without a pivot.
  std::vector<SparseRow> null_space() const {
    std::vector<SparseRow> basis;
    for (std::size_t free = 0; free < row_of_pivot_.size(); ++free) {
      if (row_of_pivot_[free] >= 0) continue;
      int const column = static_cast<int>(free);
      basis.push_back({{column, 1.0}});
      for (int const k : rows_with_[free]) {
        auto const at = rows_[n(k)].find(column);
        if (at != rows_[n(k)].end()) basis.back()[pivot_of(k)] = -at->second;
      }
    }
    return basis;
  }

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
  SparseRow reduced(SparseRow const& row) const {
    SparseRow rest;
    double const largest = largest_of(row);
    for (auto const& [column, x] : row) {
      int const by = row_of_pivot_[n(column)];
      if (by < 0)
        rest[column] += x;
      else
        for (auto const& [other, y] : rows_[n(by)])
          if (other != column) rest[other] -= x * y;
    }
    std::erase_if(rest, [&](auto const& entry) { return std::abs(entry.second) <= negligible_ * largest; });
    return rest;
  }
  void eliminate(int k, int pivot, SparseRow const& by) {
    SparseRow& row = rows_[n(k)];
    auto const at = row.find(pivot);
    if (at == row.end()) return;
    double const factor = at->second;
    row.erase(at);
    for (auto const& [column, x] : by) {
      if (column == pivot) continue;
      double& entry = row[column];
      entry -= factor * x;
      if (std::abs(entry) <= negligible_) {
        row.erase(column), rows_with_[n(column)].erase(k);
      } else {
        rows_with_[n(column)].insert(k);
      }
    }
  }
};

}  // namespace actio::detail
