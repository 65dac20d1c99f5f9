// Processes that step one system together, each a part of it, and what they say to each other.
//
// Nothing is ever added across ranks: neighbours copy what the other one moves, and compute with the copies
// what one process would compute. So no bit depends on how many there are.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace actio {

/// The processes of a run, of which this is one. All of them make the same calls in the same order.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;  ///< which one this is, from 0
  virtual int size() const = 0;  ///< how many there are

  /// What rank 0 has there, everywhere.
  virtual void broadcast(std::span<std::byte> data) = 0;
  /// Sends to one and receives from another, who does likewise. A rank that is none, -1, is left out.
  virtual void exchange(int to, std::span<std::byte const> mine, int from, std::span<std::byte> theirs) = 0;
  /// What each has, one after the other, on rank 0.
  /// @param all  on rank 0, as long as all are together; elsewhere empty
  virtual void gather(std::span<std::byte const> mine, std::span<std::byte> all) = 0;
  /// The other way round: what rank 0 has for each, one after the other.
  virtual void scatter(std::span<std::byte const> all, std::span<std::byte> mine) = 0;
  /// Whether it is so anywhere.
  virtual bool any(bool here) = 0;
  /// The largest number of all, none of which is a NaN.
  virtual double most(double here) = 0;
};

/// Numbers as bytes.
template <class T>
std::span<std::byte> bytes_of(std::vector<T>& numbers) {
  return std::as_writable_bytes(std::span(numbers));
}
/// \copydoc bytes_of
template <class T>
std::span<std::byte const> bytes_of(std::vector<T> const& numbers) {
  return std::as_bytes(std::span(numbers));
}

/// From the first to before the last of so many rows, those of one rank: as equal parts as there are.
struct RowRange {
  int from;  ///< the first
  int to;    ///< the one after the last

  /// Those of a rank.
  static RowRange of(int rows, int rank, int ranks) {
    return {static_cast<int>(static_cast<long>(rows) * rank / ranks),
            static_cast<int>(static_cast<long>(rows) * (rank + 1) / ranks)};
  }
  int count() const { return to - from; }  ///< how many
};

/// Numbers on one rank's rows, and copies of rows of its neighbours on both sides.
class HaloRows {
 public:
  /// @param ranks  null: this process is alone, and has no copies
  /// @param rows   of all ranks
  /// @param round  whether the last one is followed by the first
  /// @param width  how many rows of each neighbour are copied; at most as many as a rank has
  HaloRows(Ranks* ranks, int rows, bool round, int width)
      : ranks_(ranks && ranks->size() > 1 ? ranks : nullptr),
        rows_(rows),
        own_(ranks_ ? RowRange::of(rows, ranks->rank(), ranks->size()) : RowRange{0, rows}),
        width_(ranks_ ? width : 0) {
    if (!ranks_) return;
    int const rank = ranks->rank(), last = ranks->size() - 1;
    below_ = rank > 0 ? rank - 1 : round ? last : -1;
    above_ = rank < last ? rank + 1 : round ? 0 : -1;
  }
  /// The most rows that a neighbour may copy; no bound where there is none.
  static int widest(Ranks const* ranks, int rows) {
    return ranks && ranks->size() > 1 ? rows / ranks->size() : std::numeric_limits<int>::max();
  }

  bool alone() const { return !ranks_; }                    ///< whether there are no other ranks
  Ranks& ranks() const { return *ranks_; }                  ///< where there are
  RowRange own() const { return own_; }                     ///< rows of this rank
  int stored() const { return own_.count() + 2 * width_; }  ///< rows that are held, copies included
  /// Where a row is among these.
  std::size_t local(int row) const {
    if (alone()) return static_cast<std::size_t>(row);
    int const beyond = row - own_.from + width_;
    return static_cast<std::size_t>((beyond % rows_ + rows_) % rows_);
  }
  /// Brings copies up to date.
  /// @param state  the rows that are held, one after the other
  template <class T>
  void exchange(std::vector<T>& state) const {
    if (alone() || width_ == 0) return;
    std::size_t const length = state.size() / static_cast<std::size_t>(stored()),
                      wide = length * static_cast<std::size_t>(width_),
                      own = length * static_cast<std::size_t>(own_.count());
    std::span<T> const all(state);
    ranks_->exchange(below_, std::as_bytes(all.subspan(wide, wide)), above_,
                     std::as_writable_bytes(all.subspan(wide + own, wide)));
    ranks_->exchange(above_, std::as_bytes(all.subspan(own, wide)), below_,
                     std::as_writable_bytes(all.subspan(0, wide)));
  }

 private:
  Ranks* ranks_;
  int rows_;
  RowRange own_;
  int width_;
  int below_ = -1, above_ = -1;  // neighbours
};

}  // namespace actio
