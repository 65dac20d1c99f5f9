#include "program/registry/change_in_time.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "actio/formula/value_range.hpp"

namespace actio::scene {
namespace {

/// An interval, and a bound of the second derivative over it. The largest bound comes first, and of equal
/// ones the shortest interval, so that something is found soon.
struct Piece {
  double from, to, bound;
  bool operator<(Piece const& other) const {
    return bound != other.bound ? bound < other.bound : to - from > other.to - other.from;
  }
};

class Search {
 public:
  Search(Tape const& second, std::vector<double> inputs) : second_(second), inputs_(std::move(inputs)) {
    for (double const x : inputs_) ranges_.emplace_back(x);
  }
  ChangeInTime run(double until, double enough, int most) {
    // The range of the values: that of a wave is found by any that are not in step with it.
    look(0), look(until);
    for (int k = 1; k < 64; ++k) look(until * k / 64, 0);
    add(0, until);
    // Ten thousand million steps would not resolve what is shorter.
    double const shortest = std::ldexp(until, -33);
    for (int k = 1; pieces_.top().bound > std::max(4 * found_.bend, enough); ++k) {
      Piece const top = pieces_.top();
      if (k >= most || !(top.to - top.from > shortest)) return unsettled(enough);
      pieces_.pop();
      double const middle = (top.from + top.to) / 2;
      add(top.from, middle), add(middle, top.to);
    }
    found_.bound = pieces_.top().bound;
    return found_;
  }

 private:
  void add(double from, double to) {
    look((from + to) / 2);
    ranges_.back() = ValueRange(from, to);
    ValueRange y[3];
    second_(ranges_.data(), y, range_work_);
    pieces_.push({from, to, y[2].largest()});
  }
  /// What of it matters: an event in an interval whose height may be, by the bound, a hundredth of the range.
  ChangeInTime unsettled(double enough) {
    found_.bound = pieces_.top().bound;
    double highest = (found_.most - found_.least) / 100;
    for (; !pieces_.empty(); pieces_.pop()) {
      Piece const& piece = pieces_.top();
      double const height = piece.bound * std::pow(piece.to - piece.from, 2) / 8;
      if (!(piece.bound > std::max(4 * found_.bend, enough)) || !(height > highest)) continue;
      highest = height;
      found_.settled = false, found_.from = piece.from, found_.to = piece.to;
    }
    return found_;
  }
  /// @param weight  of the second derivative: whether it counts
  void look(double time, double weight = 1) {
    inputs_.back() = time;
    double y[3];
    second_(inputs_.data(), y, work_);
    if (!std::isfinite(y[0]) || !std::isfinite(y[2])) return;
    found_.join({y[0], y[0], weight * std::abs(y[2])});
  }

  Tape const& second_;
  std::vector<double> inputs_, work_;
  std::vector<ValueRange> ranges_, range_work_;
  std::priority_queue<Piece> pieces_;
  ChangeInTime found_{HUGE_VAL, -HUGE_VAL, 0, 0, 0, 0, true};
};

}  // namespace

void ChangeInTime::join(ChangeInTime const& other) {
  least = std::min(least, other.least), most = std::max(most, other.most);
  bend = std::max(bend, other.bend);
  if (settled && !other.settled) settled = false, from = other.from, to = other.to;
  bound = std::max(bound, other.bound);
}

double ChangeInTime::frequency() const { return most > least ? std::sqrt(bend / (most - least)) : 0; }

ChangeInTime change_in_time(Tape const& second, std::vector<double> inputs, double until, double enough,
                            int most) {
  return Search(second, std::move(inputs)).run(until, enough, most);
}

}  // namespace actio::scene
