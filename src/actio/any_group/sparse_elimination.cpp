#include "actio/any_group/sparse_elimination.hpp"

namespace actio::systems {

namespace detail {

double SparseElimination::add(SparseRow const& row, double least) {
  SparseRow rest = reduced(row);
  double const distance = rest.empty() ? 0 : largest_of(rest) / largest_of(row);
  if (rest.empty() || distance < least) return distance;
  int pivot = rest.begin()->first;
  double largest = 0;
  for (auto const& [column, x] : rest)
    if (std::abs(x) >= largest * (1 - negligible_)) pivot = column, largest = std::max(largest, std::abs(x));
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

std::vector<SparseRow> SparseElimination::null_space() const {
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

SparseRow SparseElimination::reduced(SparseRow const& row) const {
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

void SparseElimination::eliminate(int k, int pivot, SparseRow const& by) {
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

}  // namespace detail

}  // namespace actio::systems
