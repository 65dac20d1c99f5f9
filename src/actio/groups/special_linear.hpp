// SL(n): real matrices of determinant 1.
//
// Cayley's transform of a traceless matrix has determinant 1 for n = 2 only. Beyond, one entry of a diagonal
// matrix on either side makes up for it: that makes the retraction a rational map, and symmetric.
#pragma once

#include "actio/groups/algebra_logarithm.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/order.hpp"
#include "actio/linear_algebra/determinant.hpp"

namespace actio {

/// SL(n), n > 1, of fixed order or, as `SL<>(n)`, of an order chosen at run time.
///
/// Coordinates: those of the traceless diagonal matrices \f$E_{kk} - E_{k+1,k+1}\f$, then the entries off the
/// diagonal, row by row.
template <int n = Dynamic>
struct SL : Order<n, 2> {
  using Order<n, 2>::Order, Order<n, 2>::order;
  static constexpr int size = n;
  static constexpr int dim = follows_from<n>(n * n - 1);
  constexpr int matrix_size() const { return order(); }
  constexpr int dimension() const { return order() * order() - 1; }
  template <class S>
  using Matrix = actio::Matrix<S, size, size>;
  template <class S>
  using Vector = actio::Matrix<S, dim, 1>;

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    int const rows = order();
    Matrix<S> a = Matrix<S>::Zero(rows, rows);
    for (int k = 0; k + 1 < rows; ++k) a(k, k) += v[k], a(k + 1, k + 1) -= v[k];
    for (int i = 0, c = rows - 1; i < rows; ++i)
      for (int j = 0; j < rows; ++j)
        if (i != j) a(i, j) = v[c++];
    return a;
  }
  /// The traceless part of a matrix, as coordinates.
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    int const rows = order();
    Vector<S> v(dimension());
    S trace(0), sum(0);
    for (int k = 0; k < rows; ++k) trace += a(k, k);
    for (int k = 0; k + 1 < rows; ++k) {
      sum += a(k, k) - trace / S(rows);
      v[k] = sum;
    }
    for (int i = 0, c = rows - 1; i < rows; ++i)
      for (int j = 0; j < rows; ++j)
        if (i != j) v[c++] = a(i, j);
    return v;
  }

  /// \f$D\,C^2D\f$ with C Cayley's transform of half the matrix and
  /// \f$D = \mathrm{diag}(1/\det C, 1, \dots, 1)\f$; Cayley's transform itself for n = 2.
  ///
  /// \f$\det C\f$ differs from 1 by the cube of v, and turns into its inverse with -v.
  /// @throws Singular  where the matrix has the eigenvalue 4 (for n = 2: 2)
  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    Matrix<S> const a = hat(v);
    if (order() == 2) return cayley(a);
    Matrix<S> const half = cayley(Matrix<S>(a / S(2)));
    Matrix<S> g = half * half;
    S const inverse = S(1) / determinant_by_elimination(half);
    g.row(0) *= inverse;
    g.col(0) *= inverse;
    return g;
  }
  template <Real S>
  Matrix<S> exp(Vector<S> const& v) const {
    if constexpr (n == 2)
      return SL2::exp(v);
    else
      return matrix_exponential(hat(v));
  }
  /// @throws OutsideDomain  at and next to an eigenvalue on the negative axis, and where the determinant is
  ///                        not 1
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const {
    if constexpr (n == 2)
      if (SL2::near_identity_matrix(a)) return SL2::near_logarithm(a);
    return logarithm_in_algebra<SL, S>(*this, a);
  }
  /// Scaled to determinant 1, up to the cube of its distance:
  /// \f$d^{-1/n}\approx\frac{(n-1)d+(n+1)}{(n+1)d+(n-1)}\f$.
  /// @throws OutsideDomain  where the determinant is not even near 1
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    S const d = determinant_by_elimination(a);
    double const distance = std::abs(to_double(d) - 1);
    if (!(distance < 0.1))
      throw OutsideDomain("restore", "a matrix near SL(n) is needed; |determinant - 1|", distance, 0.1);
    S const less(order() - 1), more(order() + 1);
    return a * S((less * d + more) / (more * d + less));
  }
};

}  // namespace actio
