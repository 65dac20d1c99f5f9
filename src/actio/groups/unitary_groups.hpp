// U(n) and SU(n): complex matrices A + i B with orthonormal columns, stored as the real matrices ((A, -B),
// (B, A)).
//
// The real form needs no complex scalar, so that fractions and dual numbers serve as they are, and it shows
// U(n) as what it is, the intersection of SO(2n) and Sp(2n, R).
#pragma once

#include "actio/groups/algebra_logarithm.hpp"
#include "actio/groups/order.hpp"
#include "actio/linear_algebra/determinant.hpp"

namespace actio {

/// U(n), of fixed order or, as `U<>(n)`, of an order chosen at run time.
///
/// Coordinates: the n phases on the diagonal, then (x, y) of each entry x + iy above the diagonal, row by
/// row; below it stands -x + iy.
template <int n = Dynamic>
struct U : Order<n, 1> {
  using Order<n, 1>::Order, Order<n, 1>::order;
  static constexpr int size = follows_from<n>(2 * n);
  static constexpr int dim = follows_from<n>(n * n);
  constexpr int matrix_size() const { return 2 * order(); }
  constexpr int dimension() const { return order() * order(); }
  template <class S>
  using Matrix = actio::Matrix<S, size, size>;
  template <class S>
  using Vector = actio::Matrix<S, dim, 1>;

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    int const m = order();
    Matrix<S> a = Matrix<S>::Zero(2 * m, 2 * m);
    for (int k = 0; k < m; ++k) a(m + k, k) = v[k], a(k, m + k) = -v[k];
    for (int i = 0, c = m; i < m; ++i)
      for (int j = i + 1; j < m; ++j, c += 2) {
        a(i, j) = a(m + i, m + j) = v[c], a(j, i) = a(m + j, m + i) = -v[c];
        a(m + i, j) = a(m + j, i) = v[c + 1], a(i, m + j) = a(j, m + i) = -v[c + 1];
      }
    return a;
  }
  /// The skew-Hermitian part of the complex linear part of a matrix, as coordinates.
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    int const m = order();
    auto const real = [&](int i, int j) { return S(a(i, j) + a(m + i, m + j)); };
    auto const imaginary = [&](int i, int j) { return S(a(m + i, j) - a(i, m + j)); };
    Vector<S> v(dimension());
    for (int k = 0; k < m; ++k) v[k] = imaginary(k, k) / S(2);
    for (int i = 0, c = m; i < m; ++i)
      for (int j = i + 1; j < m; ++j) {
        v[c++] = (real(i, j) - real(j, i)) / S(4);
        v[c++] = (imaginary(i, j) + imaginary(j, i)) / S(4);
      }
    return v;
  }
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const { return a.transpose(); }
  /// @throws OutsideDomain  at and next to an eigenvalue -1, and where the matrix is not unitary
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const { return logarithm_in_algebra<U, S>(*this, a); }
  /// The nearest unitary matrix to second order: \f$\tfrac12 U\,(3 - U^*U)\f$ of the complex linear part U.
  /// @throws OutsideDomain  where \f$U^*U\f$ is not even near 1, or the rest is not near 0
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    int const m = order();
    Matrix<S> linear(2 * m, 2 * m);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        linear(i, j) = linear(m + i, m + j) = (a(i, j) + a(m + i, m + j)) / S(2);
        linear(m + i, j) = (a(m + i, j) - a(i, m + j)) / S(2);
        linear(i, m + j) = -linear(m + i, j);
      }
    Matrix<S> excess = linear.transpose() * linear;
    excess.diagonal().array() -= S(1);
    double const distance = std::max(row_norm(excess), row_norm(Matrix<S>(a - linear)));
    if (!(distance < 0.1))
      throw OutsideDomain("restore",
                          "a matrix near the unitary ones is needed; largest row of U^* U - 1, "
                          "or of what is not complex linear",
                          distance, 0.1);
    return linear - linear * excess / S(2);
  }
};

/// SU(n), n > 1, of fixed order or, as `SU<>(n)`, of an order chosen at run time. SU(2) as unit quaternions
/// is `SU2`.
///
/// Coordinates: those of the diagonal matrices \f$i(E_{kk} - E_{k+1,k+1})\f$, then (x, y) of each entry
/// x + iy above the diagonal, row by row. The quaternion coordinates of `SU2` are twice these.
template <int n = Dynamic>
struct SU : Order<n, 2> {
  using Order<n, 2>::Order, Order<n, 2>::order;
  static constexpr int size = follows_from<n>(2 * n);
  static constexpr int dim = follows_from<n>(n * n - 1);
  constexpr int matrix_size() const { return 2 * order(); }
  constexpr int dimension() const { return order() * order() - 1; }
  template <class S>
  using Matrix = actio::Matrix<S, size, size>;
  template <class S>
  using Vector = actio::Matrix<S, dim, 1>;

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    int const m = order();
    Coordinates<U<n>, S> u(m * m);
    for (int k = 0; k < m; ++k) u[k] = (k + 1 < m ? S(v[k]) : S(0)) - (k > 0 ? S(v[k - 1]) : S(0));
    for (int c = m; c < m * m; ++c) u[c] = v[c - 1];
    return unitary().hat(u);
  }
  /// The traceless skew-Hermitian part of the complex linear part of a matrix, as coordinates.
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    int const m = order();
    Coordinates<U<n>, S> const u = unitary().vee(a);
    Vector<S> v(dimension());
    S trace(0), sum(0);
    for (int k = 0; k < m; ++k) trace += u[k];
    for (int k = 0; k + 1 < m; ++k) {
      sum += u[k] - trace / S(m);
      v[k] = sum;
    }
    for (int c = m; c < m * m; ++c) v[c - 1] = u[c];
    return v;
  }
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const { return a.transpose(); }
  /// \f$D\,C^2D\f$ with C Cayley's transform of half the matrix and
  /// \f$D = \mathrm{diag}(\overline{\det C}, 1, \dots, 1)\f$; Cayley's transform itself for n = 2.
  ///
  /// \f$\det C\f$, of modulus 1, differs from 1 by the cube of v, and turns into its conjugate with -v.
  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    Matrix<S> const a = hat(v);
    if (order() == 2) return cayley(a);
    Matrix<S> const half = cayley(Matrix<S>(a / S(2)));
    Matrix<S> g = half * half;
    Complex<S> const phase = complex_determinant(half).conjugate();
    turn_row(g, 0, phase);
    turn_column(g, 0, phase);
    return g;
  }
  /// @throws OutsideDomain  at and next to an eigenvalue -1, where the matrix is not in the group, and where
  ///                        its angles add up to a whole turn: then the principal logarithm has a trace
  ///                        (n > 2)
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const { return logarithm_in_algebra<SU, S>(*this, a); }
  /// As for U(n); then all columns are turned by an angle that brings the determinant to 1, up to the cube of
  /// its distance.
  /// @throws OutsideDomain  where the matrix is not even near the group
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    Matrix<S> g = unitary().restore(a);
    Complex<S> const d = complex_determinant(g);
    double const distance = std::max(std::abs(to_double(d.re) - 1), std::abs(to_double(d.im)));
    if (!(distance < 0.1))
      throw OutsideDomain("restore", "a matrix near SU(n) is needed; |determinant - 1|", distance, 0.1);
    // The tangent of half the angle is a quotient, and so is the turn back by its n-th part: no root, no
    // arcus.
    S const tangent = d.im / ((S(1) + d.re) * S(order()));
    Complex<S> const back = Complex<S>(S(1), -tangent) / Complex<S>(S(1), tangent);
    for (int i = 0; i < order(); ++i) turn_row(g, i, back);
    return g;
  }

 private:
  constexpr U<n> unitary() const {
    if constexpr (n == Dynamic)
      return U<n>(order());
    else
      return U<n>{};
  }
  /// Multiplies the i-th row of the complex matrix.
  template <class S>
  void turn_row(Matrix<S>& a, int i, Complex<S> const& by) const {
    int const m = order();
    for (int j = 0; j < 2 * m; ++j) {
      S const x = a(i, j), y = a(m + i, j);
      a(i, j) = x * by.re - y * by.im, a(m + i, j) = x * by.im + y * by.re;
    }
  }
  /// Multiplies the j-th column of the complex matrix.
  template <class S>
  void turn_column(Matrix<S>& a, int j, Complex<S> const& by) const {
    int const m = order();
    for (int i = 0; i < 2 * m; ++i) {
      S const x = a(i, j), y = a(i, m + j);
      a(i, j) = x * by.re + y * by.im, a(i, m + j) = y * by.re - x * by.im;
    }
  }
};

}  // namespace actio
