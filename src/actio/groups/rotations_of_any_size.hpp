// SO(n) with n known when the program runs, and the planes in which coordinates of so(n) turn.
//
// The same coordinates as for a fixed n: for n = 3 the axes, for n = 2 the angle, otherwise the entries above
// the diagonal, row by row.
#pragma once

#include "actio/groups/rotations.hpp"

namespace actio {

/// Calls `visit(a, i, j)` for each coordinate a of so(n): the a-th basis vector has +1 at (i, j) and -1 at
/// (j, i).
template <class Visit>
void over_planes(int n, Visit const& visit) {
  if (n == 2) {
    visit(0, 1, 0);
  } else if (n == 3) {
    for (int a = 0; a < 3; ++a) visit(a, (a + 2) % 3, (a + 1) % 3);
  } else {
    for (int i = 0, a = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j, ++a) visit(a, i, j);
  }
}

/// SO(n), n at run time.
template <>
struct SO<Dynamic> {
  static constexpr int size = Dynamic;  ///< known at run time only
  static constexpr int dim = Dynamic;   ///< known at run time only
  int n = 3;                            ///< dimension of the space that is rotated

  int matrix_size() const { return n; }
  int dimension() const { return n * (n - 1) / 2; }

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    Matrix<S, Dynamic, Dynamic> m = Matrix<S, Dynamic, Dynamic>::Zero(n, n);
    over_planes(n, [&](int a, int i, int j) { m(i, j) = v[a], m(j, i) = -v[a]; });
    return m;
  }
  /// The skew part of a matrix, as coordinates.
  template <MatrixLike M>
  auto vee(M const& m) const {
    using S = typename M::Scalar;
    Matrix<S, Dynamic, 1> v(dimension());
    over_planes(n, [&](int a, int i, int j) { v[a] = (m(i, j) - m(j, i)) / S(2); });
    return v;
  }
  template <class S>
  static Matrix<S, Dynamic, Dynamic> inverse(Matrix<S, Dynamic, Dynamic> const& a) { return a.transpose(); }
  /// The nearest rotation to second order: \f$\tfrac12 R\,(3 - R^T R)\f$.
  /// @throws OutsideDomain  where \f$R^T R\f$ is not even near 1
  template <Real S>
  static Matrix<S, Dynamic, Dynamic> restore(Matrix<S, Dynamic, Dynamic> const& a) {
    return detail::restored_rotation(a);
  }
};

}  // namespace actio
