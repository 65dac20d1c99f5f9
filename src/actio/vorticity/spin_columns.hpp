// The commutators with the three spin matrices, column by column below the diagonal: what they are needed for
// is sums over their entries, and they need not be stored.
#pragma once

#include <array>

#include "actio/vorticity/quantized_sphere.hpp"

namespace actio {

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

  /// A part of a column: the entries from the diagonal on.
  struct Piece {
    Column real;       ///< of the real part
    Column imaginary;  ///< of the imaginary part
  };
  /// Calls `use(c, pieces)` for each column.
  template <class Use>
  void over(SkewHermitian<Real> const& w, Use const& use) const {
    std::vector<Piece> pieces(axes_.size());
    Piece first, second, third;
    for (Eigen::Index c = 0; c < n_; ++c) {
      auto const rows = n_ - c;
      Column up, down, left, right;
      auto const neighbours = [&](auto const& m) {
        up = Column::Zero(rows), down = Column::Zero(rows), left = Column::Zero(rows),
        right = Column::Zero(rows);
        up.head(rows - 1) = ladder_.segment(c + 1, rows - 1) * m.col(c).tail(rows - 1).array();
        if (c > 0)
          down = ladder_.segment(c, rows) * m.col(c).segment(c - 1, rows).array();
        else
          down.tail(rows - 1) = ladder_.segment(1, rows - 1) * m.col(0).head(rows - 1).array();
        if (c > 0) left = ladder_[c] * m.col(c - 1).tail(rows).array();
        if (c + 1 < n_) right = ladder_[c + 1] * m.col(c + 1).tail(rows).array();
      };
      neighbours(w.real);
      first.imaginary = up + down - left - right, second.real = up - down - left + right;
      neighbours(w.imaginary);
      first.real = left + right - up - down, second.imaginary = up - down - left + right;
      auto const apart = index_.head(rows);
      third.real = apart * w.imaginary.col(c).tail(rows).array(),
      third.imaginary = -apart * w.real.col(c).tail(rows).array();
      for (std::size_t a = 0; a < axes_.size(); ++a) {
        auto const e = axes_[a].template cast<Real>();
        pieces[a].real = e[0] * first.real + e[1] * second.real + e[2] * third.real;
        pieces[a].imaginary = e[0] * first.imaginary + e[1] * second.imaginary + e[2] * third.imaginary;
        // On the diagonal.
        pieces[a].real[0] = 0;
      }
      use(c, pieces);
    }
  }

 private:
  int n_;
  std::vector<Eigen::Vector3d> axes_;
  Column ladder_;  ///< that between k - 1 and k at k
  Column index_;
};

}  // namespace actio
