// Rows that one rank computes of fields that every rank has whole.
//
// Each rank has room for all rows, and keeps up to date its own ones and as many of its neighbours' as it
// looks at. Numbers of rows, cells and nodes are then the same on all ranks.
#pragma once

#include <algorithm>
#include <cmath>

#include "actio/parallel/ranks.hpp"

namespace actio {

/// Numbers of cells or nodes, in ascending order: one range, or two where a period ends between them.
using Ranges = std::vector<RowRange>;

/// Calls f(number) for all of them.
template <class F>
[[gnu::always_inline]] inline void for_each(Ranges const& ranges, F const& f) {
  for (RowRange const& range : ranges)
    for (int k = range.from; k < range.to; ++k) f(static_cast<std::size_t>(k));
}

/// The rows of a box, and which of them are this rank's.
class RowShare {
 public:
  RowShare() = default;  ///< of a process that is alone
  /// Equal parts of so many rows.
  /// @param ranks  null: this process is alone
  /// @param round  whether the last row is followed by the first
  RowShare(Ranks* ranks, int rows, bool round) : RowShare(ranks, std::vector<int>{}, round) {
    for (int k = 0; k <= (ranks_ ? ranks_->size() : 1); ++k)
      cuts_.push_back(ranks_ ? RowRange::of(rows, k, ranks_->size()).from : k * rows);
  }
  /// Parts between given rows.
  RowShare(Ranks* ranks, std::vector<int> cuts, bool round)
      : ranks_(ranks && ranks->size() > 1 ? ranks : nullptr), cuts_(std::move(cuts)), round_(round) {}

  bool alone() const { return !ranks_; }                  ///< whether there are no other ranks
  Ranks* ranks() const { return ranks_; }                 ///< null where there are not
  bool round() const { return round_; }                   ///< whether the last row is followed by the first
  std::vector<int> const& cuts() const { return cuts_; }  ///< where parts begin, and where the last one ends
  int rows() const { return cuts_.back() - cuts_.front(); }  ///< of all ranks
  /// Those of this rank.
  RowRange own() const {
    auto const k = static_cast<std::size_t>(ranks_ ? ranks_->rank() : 0);
    return {cuts_[k], cuts_[k + 1]};
  }
  /// The fewest rows of a rank.
  int fewest() const {
    int out = rows();
    for (std::size_t k = 0; k + 1 < cuts_.size(); ++k) out = std::min(out, cuts_[k + 1] - cuts_[k]);
    return out;
  }
  /// The numbers of what is in this rank's rows, and so many below and above, of so many in a row.
  Ranges with(int below, int above, int in_row) const {
    int const from = own().from - below, to = own().to + above, first = cuts_.front(), last = cuts_.back();
    Ranges out;
    auto const add = [&](int a, int b) {
      if (a < b) out.push_back({a * in_row, b * in_row});
    };
    if (alone() || to - from >= rows()) {
      add(first, last);
    } else if (!round_) {
      add(std::max(first, from), std::min(last, to));
    } else {
      add(first, std::min(to - rows(), last)), add(std::max(first, from), std::min(last, to));
      add(from + rows(), last);
    }
    return out;
  }
  /// Rows of neighbours as they have them.
  /// @param field   all rows, from the first
  /// @param width   how many on both sides, of no more than each rank has
  template <class T>
  void exchange(std::span<T> field, int width) const {
    if (alone()) return;
    std::size_t const length = field.size() / static_cast<std::size_t>(rows());
    auto const at = [&](int row) {
      int const k = ((row - cuts_.front()) % rows() + rows()) % rows();
      return field.subspan(static_cast<std::size_t>(k) * length, length * static_cast<std::size_t>(width));
    };
    RowRange const mine = own();
    swap(at(mine.from), at(mine.to), at(mine.to - width), at(mine.from - width));
  }
  /// Both neighbours at once: the lowest rows of this rank for the one below, the highest for the one above.
  /// @param beyond, before  where those of the neighbour above are put, and of the one below
  template <class T>
  void swap(std::span<T> lowest, std::span<T> beyond, std::span<T> highest, std::span<T> before) const {
    ranks_->exchange(below(), std::as_bytes(lowest), above(), std::as_writable_bytes(beyond));
    ranks_->exchange(above(), std::as_bytes(highest), below(), std::as_writable_bytes(before));
  }
  /// All rows, everywhere.
  /// @param field  all rows, of which each rank has its own
  template <class T>
  void whole(std::span<T> field) const {
    if (alone()) return;
    std::size_t const length = field.size() / static_cast<std::size_t>(rows());
    RowRange const mine = own();
    auto const part = field.subspan(static_cast<std::size_t>(mine.from - cuts_.front()) * length,
                                    static_cast<std::size_t>(mine.count()) * length);
    ranks_->gather(std::as_bytes(part),
                   ranks_->rank() == 0 ? std::as_writable_bytes(field) : std::span<std::byte>{});
    ranks_->broadcast(std::as_writable_bytes(field));
  }
  /// The sum of all rows' numbers in the order of the rows: the same on any number of ranks.
  /// @param of_row  the number of a row; called for this rank's
  template <class F>
  double sum(F const& of_row) const {
    std::vector<double> sums(static_cast<std::size_t>(rows()));
    for (int j = own().from; j < own().to; ++j) sums[static_cast<std::size_t>(j - cuts_.front())] = of_row(j);
    whole(std::span(sums));
    double sum = 0;
    for (double const one : sums) sum += one;
    return sum;
  }
  /// Whether it is so anywhere.
  bool any(bool here) const { return alone() ? here : ranks_->any(here); }
  /// The largest of all; infinite where one is no finite number.
  double most(double here) const {
    if (!std::isfinite(here)) here = HUGE_VAL;
    return alone() ? here : ranks_->most(here);
  }

 private:
  Ranks* ranks_ = nullptr;
  std::vector<int> cuts_;
  bool round_ = false;

  int below() const { return ranks_->rank() > 0 ? ranks_->rank() - 1 : round_ ? ranks_->size() - 1 : -1; }
  int above() const { return ranks_->rank() + 1 < ranks_->size() ? ranks_->rank() + 1 : round_ ? 0 : -1; }
};

}  // namespace actio
