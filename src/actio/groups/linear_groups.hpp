// GL(n) and SL(2): invertible matrices, and those of determinant 1.
#pragma once

#include "actio/groups/rotation_logarithm.hpp"

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
  static A restore(A const& a) { return a; }
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
  /// \f$c_0(d) + c_1(d)\,\hat v\f$ with Stumpff's functions of \f$d = \det\hat v\f$, since
  /// \f$\hat v^2 = -d\f$.
  template <Real S>
  static Matrix<S, 2, 2> exp(Matrix<S, 3, 1> const& v) {
    Matrix<S, 2, 2> a = hat(v);
    S const d = -(v[0] * v[0] + v[1] * v[2]);
    if (!(base_value(d) > Base<S>(-1))) return matrix_exponential(a);
    S const c0 = stumpff<0>(d), c1 = stumpff<1>(d);
    a *= c1;
    a(0, 0) += c0, a(1, 1) += c0;
    return a;
  }
  /// @throws OutsideDomain  at and next to an eigenvalue on the negative axis
  template <Real S>
  static Matrix<S, 3, 1> log(Matrix<S, 2, 2> const& a) {
    if (near_identity_matrix(a)) return near_logarithm(a);
    if constexpr (is_dual<S>)
      return primitive::lifted_log(SL2{}, a);
    else
      return vee(matrix_logarithm(a));
  }
  /// Whether \ref near_logarithm is the logarithm: eigenvalues near 1, determinant 1 up to half of the digits
  /// of double.
  template <Real S>
  static bool near_identity_matrix(Matrix<S, 2, 2> const& a) {
    auto const& [p, q, r, s] = std::array<Base<S>, 4>{base_value(a(0, 0)), base_value(a(0, 1)),
                                                      base_value(a(1, 0)), base_value(a(1, 1))};
    Base<S> const c = (p + s) / 2, half = (p - s) / 2, d = -(half * half + q * r);
    return c > Base<S>(0) && magnitude(d) < ratio<Base<S>>(1, 4) &&
           magnitude(Base<S>(p * s - q * r - Base<S>(1))) <= Base<S>(1e-8);
  }
  /// With \f$a = c + b\f$, b without a trace, \f$b^2 = -d\f$: near the identity
  /// \f$\log a = b\,\arcsin\sqrt d/\sqrt d\f$.
  template <Real S>
  static Matrix<S, 3, 1> near_logarithm(Matrix<S, 2, 2> const& a) {
    Matrix<S, 3, 1> const b = vee(a);
    return b * asinc_derivative<0>(S(-(b[0] * b[0] + b[1] * b[2])));
  }
  /// Scaled to determinant 1.
  /// @throws OutsideDomain  where the determinant is not even near 1
  template <Real S>
  static Matrix<S, 2, 2> restore(Matrix<S, 2, 2> const& a) {
    using std::sqrt;
    S const determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    double const distance = std::abs(to_double(determinant) - 1);
    if (!(distance < 0.1))
      throw OutsideDomain("restore", "a matrix near SL(2) is needed; |determinant - 1|", distance, 0.1);
    return a / S(sqrt(determinant));
  }
};

}  // namespace actio
