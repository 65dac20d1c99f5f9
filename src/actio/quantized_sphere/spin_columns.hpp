// The commutators with the three spin matrices, column by column below the diagonal: what they are needed for
// is sums over their entries, and they need not be stored.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>

#include "actio/quantized_sphere/quantized_sphere.hpp"

namespace actio::sphere {

/// \f$[ie\cdot S, W]\f$ for up to three axes e.
template <class Real>
class SpinColumns {
 public:
  using Column = Eigen::Array<Real, Eigen::Dynamic, 1>;

  /// For turns about these axes, unit vectors.
  SpinColumns(QuantizedSphere const& sphere, std::vector<Eigen::Vector3d> axes)
      : n_(sphere.n),
        axes_(std::move(axes)),
        ladder_(Column::Zero(n_ + 2)),
        index_(Column::LinSpaced(n_, 0, static_cast<Real>(n_ - 1))) {
    for (int k = 0; k + 1 < n_; ++k) ladder_[k + 1] = static_cast<Real>(sphere.ladder(k));
  }
  std::size_t count() const { return axes_.size(); }  ///< of the axes

  /// A part of a column: entries from the diagonal on.
  struct Piece {
    Eigen::VectorBlock<Column> real;       ///< of the real part
    Eigen::VectorBlock<Column> imaginary;  ///< of the imaginary part
  };
  /// Calls `use(c, pieces)` for each column.
  /// @param depth  the most entries that a piece is to have
  template <class Use>
  void over(SkewHermitian<Real> const& w, Use const& use,
            Eigen::Index depth = std::numeric_limits<Eigen::Index>::max()) const {
    Sums real(n_), imaginary(n_);
    std::vector<Column> memory(2 * axes_.size(), Column(n_));
    std::vector<Piece> pieces;
    for (Eigen::Index c = 0; c < n_; ++c) {
      auto const rows = std::min<Eigen::Index>(depth, n_ - c);
      real.collect(ladder_, w.real, c, rows), imaginary.collect(ladder_, w.imaginary, c, rows);
      pieces.clear();
      for (std::size_t a = 0; a < axes_.size(); ++a) {
        pieces.push_back({memory[2 * a].head(rows), memory[2 * a + 1].head(rows)});
        combine(axes_[a], real, imaginary, w, c, pieces.back());
      }
      use(c, pieces);
    }
  }

 private:
  /// Of a column of a part M of W: what the ladder brings from the four neighbours of each entry.
  struct Sums {
    Column vertical, horizontal;       ///< of those above and below, of those left and right
    Column up_to_down, left_to_right;  ///< their differences

    explicit Sums(int n) : vertical(n), horizontal(n), up_to_down(n), left_to_right(n) {}
    void collect(Column const& ladder, typename SkewHermitian<Real>::Part const& m, Eigen::Index c,
                 Eigen::Index rows) {
      auto const n = m.rows();
      auto const column = m.col(c).array();
      // From the row after, and from the row before.
      auto const after_it = std::min(rows, n - c - 1);
      vertical[rows - 1] = 0;
      vertical.head(after_it) = ladder.segment(c + 1, after_it) * column.segment(c + 1, after_it);
      up_to_down.head(rows) = vertical.head(rows);
      Eigen::Index const first = c == 0 ? 1 : 0;
      auto const above =
          ladder.segment(c + first, rows - first) * column.segment(c + first - 1, rows - first);
      vertical.segment(first, rows - first) += above, up_to_down.segment(first, rows - first) -= above;
      horizontal.head(rows).setZero(), left_to_right.head(rows).setZero();
      if (c > 0)
        horizontal.head(rows) = ladder[c] * m.col(c - 1).segment(c, rows).array(),
        left_to_right.head(rows) = horizontal.head(rows);
      if (c + 1 == n) return;
      auto const after = ladder[c + 1] * m.col(c + 1).segment(c, rows).array();
      horizontal.head(rows) += after, left_to_right.head(rows) -= after;
    }
  };
  /// The sum over the coordinate axes, of those that e has a part along.
  void combine(Eigen::Vector3d const& axis, Sums const& real, Sums const& imaginary,
               SkewHermitian<Real> const& w, Eigen::Index c, Piece& piece) const {
    auto const rows = piece.real.size();
    Eigen::Array<Real, 3, 1> const e = axis.cast<Real>().array();
    piece.real.setZero(), piece.imaginary.setZero();
    if (e[0] != 0) {
      piece.real += e[0] * (imaginary.horizontal.head(rows) - imaginary.vertical.head(rows));
      piece.imaginary += e[0] * (real.vertical.head(rows) - real.horizontal.head(rows));
    }
    if (e[1] != 0) {
      piece.real += e[1] * (real.up_to_down.head(rows) - real.left_to_right.head(rows));
      piece.imaginary += e[1] * (imaginary.up_to_down.head(rows) - imaginary.left_to_right.head(rows));
    }
    if (e[2] != 0) {
      auto const apart = e[2] * index_.head(rows);
      piece.real += apart * w.imaginary.col(c).segment(c, rows).array();
      piece.imaginary -= apart * w.real.col(c).segment(c, rows).array();
    }
    piece.real[0] = 0;  // on the diagonal
  }

  int n_;
  std::vector<Eigen::Vector3d> axes_;
  Column ladder_;  ///< that between k - 1 and k at k
  Column index_;
};

}  // namespace actio::sphere
