#include "actio/quantized_torus/cyclic_diagonals.hpp"

#include "actio/quantized_torus/fft.hpp"

namespace actio::torus {

CyclicDiagonals::Block::Block(int size)
    : memory_(detail::fft_allocate(static_cast<std::size_t>(size) * static_cast<std::size_t>(size + 1) / 2),
              detail::fft_free),
      rows_(memory_.get(), (size + 1) / 2, size) {}

CyclicDiagonals::CyclicDiagonals(QuantizedTorus const& torus)
    : n_(torus.n),
      forwards_(detail::fft_side_by_side(n_, (n_ + 1) / 2, true)),
      backwards_(detail::fft_side_by_side(n_, (n_ + 1) / 2, false)) {}

// In the column k of the matrix the diagonals lie one after another, from its main one on and round the end:
// (k + n, k) holds -conj W(k, k + n), and -iW(k, k + n) = J + iR there.

void CyclicDiagonals::take(sphere::SkewHermitian<> const& w, Block& block) const {
  Rows& rows = block.rows();
  for (int k = 0; k < n_; ++k) {
    auto const first = std::min<Eigen::Index>(rows.rows(), n_ - k), rest = rows.rows() - first;
    rows.col(k).head(first).real() = w.imaginary.col(k).segment(k, first);
    rows.col(k).head(first).imag() = w.real.col(k).segment(k, first);
    rows.col(k).tail(rest).real() = w.imaginary.col(k).head(rest);
    rows.col(k).tail(rest).imag() = w.real.col(k).head(rest);
  }
}

void CyclicDiagonals::put(Block& block, sphere::SkewHermitian<>& w) const {
  Rows& rows = block.rows();
  if (w.size() != n_) w = sphere::SkewHermitian<>(n_);
  rows.row(0).imag().setZero();
  for (int k = 0; k < n_; ++k) {
    auto const first = std::min<Eigen::Index>(rows.rows(), n_ - k), rest = rows.rows() - first;
    w.imaginary.col(k).segment(k, first) = rows.col(k).head(first).real();
    w.real.col(k).segment(k, first) = rows.col(k).head(first).imag();
    // Round the end they are above the diagonal: there their mirror image is put, below it.
    for (Eigen::Index i = 0; i < rest; ++i) {
      w.imaginary(k, i) = rows(first + i, k).real();
      w.real(k, i) = -rows(first + i, k).imag();
    }
  }
  sphere::mirror_lower(w);
}

void CyclicDiagonals::forwards(Block& block) const { detail::fft_run(forwards_, block.rows().data()); }
void CyclicDiagonals::backwards(Block& block) const { detail::fft_run(backwards_, block.rows().data()); }

}  // namespace actio::torus
