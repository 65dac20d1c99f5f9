// GL(n) and SL(2): invertible matrices, and those of determinant 1.
#pragma once

#include "actio/foundations/groups/rotation_logarithm.hpp"

namespace actio {

/// GL(n), the component of the identity. Coordinates: the entries of the matrix, row by row.
template <int n>
struct GL : Matrices<n, n * n> {
  template <MatrixLike V>
  static auto hat(V const& v) {
    using S = typename V::Scalar;
    Matrix<S, n, n> a;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) a(i, j) = v[n * i + j];
    return a;
  }
  template <MatrixLike M>
  static auto vee(M const& a) {
    Matrix<typename M::Scalar, n * n, 1> v;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) v[n * i + j] = a(i, j);
    return v;
  }
  /// Every matrix near the group is in the group.
  template <class A>
  static A restore(A const& a) {
    return a;
  }
};

/// SL(2). Coordinates (a, b, c) of ((a, b), (c, -a)).
struct SL2 : Matrices<2, 3> {
  template <MatrixLike V>
  static auto hat(V const& v) {
    Matrix<typename V::Scalar, 2, 2> a;
    a << v[0], v[1], v[2], -v[0];
    return a;
  }
  template <MatrixLike M>
  static auto vee(M const& a) {
    using S = typename M::Scalar;
    return Matrix<S, 3, 1>((a(0, 0) - a(1, 1)) / S(2), a(0, 1), a(1, 0));
  }
  template <class S>
  static Matrix<S, 2, 2> inverse(Matrix<S, 2, 2> const& a) {
    Matrix<S, 2, 2> b;
    b << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
    return b;
  }
  /// Scaled to determinant 1.
  /// @throws OutsideDomain  where the determinant is not even near 1
  template <Real S>
  static Matrix<S, 2, 2> restore(Matrix<S, 2, 2> const& a) {
    using std::sqrt;
    S const determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    double const distance = std::abs(to_double(determinant) - 1);
    if (!(distance < 0.1)) throw OutsideDomain("restore", "a matrix near SL(2) is needed; |determinant - 1|", distance, 0.1);
    return a / S(sqrt(determinant));
  }
};

}  // namespace actio
