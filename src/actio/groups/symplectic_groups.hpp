// Sp(2n, R): real matrices that preserve the symplectic form, A^T J A = J with J = ((0, 1), (-1, 0)).
#pragma once

#include "actio/groups/algebra_logarithm.hpp"
#include "actio/groups/order.hpp"

namespace actio {

/// Sp(2n, R) as `Sp<2 * n>`: the parameter is the number of rows. `Sp<>(rows)` has an order chosen at run
/// time.
///
/// The algebra consists of \f$\begin{pmatrix}P&Q\\R&-P^T\end{pmatrix}\f$ with Q and R symmetric. Coordinates:
/// P row by row, then the upper triangles of Q and of R, row by row.
template <int rows = Dynamic>
struct Sp : Order<rows, 2> {
  static_assert(rows == Dynamic || rows % 2 == 0, "symplectic matrices have an even number of rows");
  Sp()
    requires(rows != Dynamic)
  = default;
  /// @throws OutsideDomain  where the number of rows is odd, or not between 2 and 1000
  explicit Sp(int count)
    requires(rows == Dynamic)
      : Order<rows, 2>(count) {
    if (count % 2 != 0) throw OutsideDomain("Sp", "an even number of rows is needed", count, count + 1);
  }
  static constexpr int size = rows;
  static constexpr int dim = follows_from<rows>(rows * (rows + 1) / 2);
  constexpr int matrix_size() const { return this->order(); }
  constexpr int dimension() const { return matrix_size() * (matrix_size() + 1) / 2; }
  template <class S>
  using Matrix = actio::Matrix<S, size, size>;
  template <class S>
  using Vector = actio::Matrix<S, dim, 1>;

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    int const n = matrix_size() / 2;
    Matrix<S> a = Matrix<S>::Zero(2 * n, 2 * n);
    int c = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j, ++c) a(i, j) = v[c], a(n + j, n + i) = -v[c];
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j, ++c) a(i, n + j) = a(j, n + i) = v[c];
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j, ++c) a(n + i, j) = a(n + j, i) = v[c];
    return a;
  }
  /// The part of a matrix in the algebra, as coordinates.
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    int const n = matrix_size() / 2;
    Vector<S> v(dimension());
    int c = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) v[c++] = (a(i, j) - a(n + j, n + i)) / S(2);
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j) v[c++] = (a(i, n + j) + a(j, n + i)) / S(2);
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j) v[c++] = (a(n + i, j) + a(n + j, i)) / S(2);
    return v;
  }
  /// \f$-J A^T J\f$: \f$\begin{pmatrix}A&B\\C&D\end{pmatrix}^{-1} =
  /// \begin{pmatrix}D^T&-B^T\\-C^T&A^T\end{pmatrix}\f$.
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const {
    int const n = matrix_size() / 2;
    Matrix<S> b(2 * n, 2 * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        b(i, j) = a(n + j, n + i), b(i, n + j) = -a(j, n + i);
        b(n + i, j) = -a(n + j, i), b(n + i, n + j) = a(j, i);
      }
    return b;
  }
  /// @throws OutsideDomain  at and next to an eigenvalue on the negative axis, and where the matrix is not
  ///                        symplectic
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const { return logarithm_in_algebra<Sp, S>(*this, a); }
  /// Back on the group to second order: \f$\tfrac12 A\,(3 + J A^T J A)\f$.
  /// @throws OutsideDomain  where \f$-J A^T J A\f$ is not even near 1
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    Matrix<S> excess = inverse(a) * a;
    excess.diagonal().array() -= S(1);
    double const distance = row_norm(excess);
    if (!(distance < 0.1))
      throw OutsideDomain("restore",
                          "a matrix near the symplectic ones is needed; largest row of -J A^T J A - 1",
                          distance, 0.1);
    return a - a * excess / S(2);
  }
};

}  // namespace actio
