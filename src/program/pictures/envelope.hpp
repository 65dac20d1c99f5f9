// The envelope of a curve of any length, in bounded memory (min-max decimation): pieces of equally many rows,
// and of each its first, lowest, highest and last point.
//
// Pieces join in pairs when there are too many of them, so no length need be known beforehand, and no peak is
// lost.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace actio::scene {

/// The outline of a curve over time.
class Envelope {
 public:
  /// There are never more pieces; up to so many rows each is a piece of its own, and the curve is kept whole.
  static constexpr std::size_t most_pieces = 2048;

  /// A point of the curve.
  struct Point {
    double t,   ///< time
        value;  ///< of the curve then
  };
  /// The curve over some neighbouring rows.
  struct Piece {
    Point first,  ///< of its points, in the order of time
        low,      ///< the lowest
        high,     ///< the highest
        last;     ///< in the order of time
  };

  /// One point more, later than all before.
  void add(double t, double value) {
    Point const p{t, value};
    if (pieces_.empty() || in_last_ == rows_per_piece_) {
      if (pieces_.size() == most_pieces) join();
      pieces_.push_back({p, p, p, p});
      in_last_ = 1;
      return;
    }
    pieces_.back() = joined(pieces_.back(), {p, p, p, p});
    ++in_last_;
  }

  /// The pieces, in the order of time.
  std::vector<Piece> const& pieces() const { return pieces_; }
  /// Of every piece but the last, which may have fewer. One: nothing is left out.
  long rows_per_piece() const { return rows_per_piece_; }
  /// The lowest value of the curve, which has a point.
  double lowest() const {
    return std::ranges::min(pieces_, {}, [](Piece const& p) { return p.low.value; }).low.value;
  }
  /// The highest value of the curve, which has a point.
  double highest() const {
    return std::ranges::max(pieces_, {}, [](Piece const& p) { return p.high.value; }).high.value;
  }

  /// The points that are kept, in the order of time.
  std::vector<Point> points() const {
    std::vector<Point> out;
    for (auto const& piece : pieces_) {
      bool const low_first = piece.low.t < piece.high.t;
      for (Point const& p :
           {piece.first, low_first ? piece.low : piece.high, low_first ? piece.high : piece.low, piece.last})
        if (out.empty() || p.t > out.back().t) out.push_back(p);
    }
    return out;
  }

 private:
  static Piece joined(Piece const& a, Piece const& b) {
    return {a.first, b.low.value < a.low.value ? b.low : a.low, b.high.value > a.high.value ? b.high : a.high,
            b.last};
  }
  void join() {
    for (std::size_t i = 0; 2 * i + 1 < pieces_.size(); ++i)
      pieces_[i] = joined(pieces_[2 * i], pieces_[2 * i + 1]);
    pieces_.resize(pieces_.size() / 2);
    rows_per_piece_ *= 2;
  }

  std::vector<Piece> pieces_;
  long rows_per_piece_ = 1, in_last_ = 0;
};

}  // namespace actio::scene
