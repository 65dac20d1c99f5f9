// Key frames, the rows from which a motion can be played: every row, or every second, fourth, eighth, ... of
// a longer run, as long as no two neighbours are so far apart that what lies between them would be a guess;
// from there on, the beginning of the run alone.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace actio::scene {

/// The key frames of a run of any length: a few thousand of its rows, between which the page of the run
/// interpolates.
class KeyFrames {
 public:
  /// There are never more rows.
  static constexpr std::size_t most_rows = 3000;
  /// Whether one can go from one row to another without those between them.
  using Near = std::function<bool(std::vector<double> const&, std::vector<double> const&)>;

  /// Of a run whose neighbouring rows are told by `near`.
  explicit KeyFrames(Near near) : near_(std::move(near)) {}

  /// One row more.
  void add(std::span<double const> row) {
    if (full_ || seen_++ % stride_ != 0) return;
    if (rows_.size() == most_rows && !thin()) {
      full_ = true;
      return;
    }
    // After thinning, this row is the next of the longer stride: most_rows is even.
    rows_.emplace_back(row.begin(), row.end());
  }

  /// The rows that are kept, in the order of time.
  std::vector<std::vector<double>> const& rows() const { return rows_; }
  /// Every so many rows of the run one is kept.
  long stride() const { return stride_; }
  /// Whether later rows of the run are left out.
  bool beginning_only() const { return full_; }

 private:
  bool thin() {
    for (std::size_t i = 2; i < rows_.size(); i += 2)
      if (!near_(rows_[i - 2], rows_[i])) return false;
    for (std::size_t i = 1; 2 * i < rows_.size(); ++i) rows_[i] = std::move(rows_[2 * i]);
    rows_.resize(rows_.size() / 2);
    stride_ *= 2;
    return true;
  }

  Near near_;
  std::vector<std::vector<double>> rows_;
  long stride_ = 1, seen_ = 0;
  bool full_ = false;
};

}  // namespace actio::scene
