// Skew-Hermitian matrices as two real ones.
//
// W = R + i J with R skew and J symmetric. Products of complex matrices are made of products of real ones, so
// the two parts are stored apart; each of them is stored whole.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace actio::sphere {

/// Complex matrices of a size known when the program runs.
template <class S = double>
using ComplexMatrix = Eigen::Matrix<std::complex<S>, Eigen::Dynamic, Eigen::Dynamic>;

/// An element of the Lie algebra u(N): \f$W = R + iJ\f$, \f$R^T = -R\f$, \f$J^T = J\f$.
///
/// \snippet sphere.cpp skew_hermitian
template <class S = double>
struct SkewHermitian {
  using Part = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;  ///< real matrices
  Part real;                                                      ///< R, skew
  Part imaginary;                                                 ///< J, symmetric

  SkewHermitian() = default;
  /// Zero.
  explicit SkewHermitian(Eigen::Index n) : real(Part::Zero(n, n)), imaginary(Part::Zero(n, n)) {}
  /// Of its two parts, which are not looked at.
  SkewHermitian(Part r, Part j) : real(std::move(r)), imaginary(std::move(j)) {}
  /// The skew-Hermitian part of a matrix.
  explicit SkewHermitian(ComplexMatrix<S> const& a)
      : real((a.real() - a.real().transpose()) / S(2)), imaginary((a.imag() + a.imag().transpose()) / S(2)) {}

  Eigen::Index size() const { return real.rows(); }  ///< N
  /// As one complex matrix.
  ComplexMatrix<S> complex() const {
    ComplexMatrix<S> w(size(), size());
    w.real() = real, w.imag() = imaginary;
    return w;
  }
  /// \f$-iW\f$, Hermitian.
  ComplexMatrix<S> hermitian() const {
    ComplexMatrix<S> w(size(), size());
    w.real() = imaginary, w.imag() = -real;
    return w;
  }
  /// In another precision.
  template <class T>
  SkewHermitian<T> cast() const { return {real.template cast<T>(), imaginary.template cast<T>()}; }

  SkewHermitian& operator+=(SkewHermitian const& other) {
    real += other.real, imaginary += other.imaginary;
    return *this;
  }
  SkewHermitian& operator-=(SkewHermitian const& other) {
    real -= other.real, imaginary -= other.imaginary;
    return *this;
  }
  SkewHermitian& operator*=(S factor) {
    real *= factor, imaginary *= factor;
    return *this;
  }
  friend SkewHermitian operator+(SkewHermitian a, SkewHermitian const& b) { return a += b; }
  friend SkewHermitian operator-(SkewHermitian a, SkewHermitian const& b) { return a -= b; }
  friend SkewHermitian operator*(S factor, SkewHermitian a) { return a *= factor; }
};

/// \f$\langle X, Y\rangle = -\mathrm{Tr}(XY) = \mathrm{Re}\,\mathrm{Tr}(X^*Y)\f$, invariant under conjugation
/// by unitary matrices.
template <class S>
S inner_product(SkewHermitian<S> const& x, SkewHermitian<S> const& y) {
  return x.real.cwiseProduct(y.real).sum() + x.imaginary.cwiseProduct(y.imaginary).sum();
}
/// \f$|X| = \sqrt{\langle X, X\rangle}\f$, the Frobenius norm.
template <class S>
S norm(SkewHermitian<S> const& x) {
  using std::sqrt;
  return sqrt(x.real.squaredNorm() + x.imaginary.squaredNorm());
}

/// Calls `use(i, j, rows, columns)` for the tiles of a matrix of the size n that are on and below its
/// diagonal: two tiles that mirror one another are both near.
template <class Use>
void over_tiles(Eigen::Index n, Use const& use) {
  constexpr Eigen::Index tile = 32;
  for (Eigen::Index j = 0; j < n; j += tile)
    for (Eigen::Index i = j; i < n; i += tile) use(i, j, std::min(tile, n - i), std::min(tile, n - j));
}

/// Completes a matrix of which what is on and below the diagonal is known.
template <class S>
void mirror_lower(SkewHermitian<S>& w) {
  auto const n = w.size();
  constexpr Eigen::Index tile = 32;  // two tiles fit into the nearest cache
  for (Eigen::Index j = 0; j < n; j += tile) {
    auto const columns = std::min(tile, n - j);
    for (Eigen::Index c = j; c < j + columns; ++c)
      for (Eigen::Index r = c + 1; r < j + columns; ++r)
        w.real(c, r) = -w.real(r, c), w.imaginary(c, r) = w.imaginary(r, c);
    for (Eigen::Index i = j + tile; i < n; i += tile) {
      auto const rows = std::min(tile, n - i);
      w.real.block(j, i, columns, rows) = -w.real.block(i, j, rows, columns).transpose();
      w.imaginary.block(j, i, columns, rows) = w.imaginary.block(i, j, rows, columns).transpose();
    }
  }
}

/// \f$[X, Y] = XY - YX = B - B^*\f$ with B = XY, by four real products: the clear twin of the commutators
/// that the steps make.
template <class S>
SkewHermitian<S> commutator(SkewHermitian<S> const& x, SkewHermitian<S> const& y) {
  using Part = typename SkewHermitian<S>::Part;
  Part real = x.real * y.real, imaginary = x.real * y.imaginary, other(x.real.rows(), y.real.cols());
  other.noalias() = x.imaginary * y.imaginary, real -= other;
  other.noalias() = x.imaginary * y.real, imaginary += other;
  return {real - real.transpose(), imaginary + imaginary.transpose()};
}

// Our own programs have it compiled once (compiled_products.cpp).
extern template SkewHermitian<> commutator(SkewHermitian<> const&, SkewHermitian<> const&);

}  // namespace actio::sphere
