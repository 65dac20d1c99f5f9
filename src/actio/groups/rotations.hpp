// SO(n): rotations of n-space, as orthogonal matrices.
//
// Coordinates of so(3) are the usual ones, hat(w) x = w x x (cross product). For n = 2 the coordinate is the
// angle, counted anticlockwise; for n > 3 the coordinates are the entries above the diagonal, row by row.
#pragma once

#include "actio/groups/rotation_logarithm.hpp"

namespace actio {

namespace detail {
/// The nearest rotation to second order: \f$\tfrac12 R\,(3 - R^T R)\f$.
template <class M>
M restored_rotation(M const& a) {
  using S = typename M::Scalar;
  M excess = a.transpose() * a;
  excess.diagonal().array() -= S(1);
  double const distance = to_double(magnitude(excess));
  if (!(distance < 0.1))
    throw OutsideDomain("restore", "a matrix near the rotations is needed; largest entry of R^T R - 1",
                        distance, 0.1);
  return a - a * excess / S(2);
}
}  // namespace detail

/// SO(n).
template <int n>
struct SO : Matrices<n, n*(n - 1) / 2> {
  using Matrices<n, n*(n - 1) / 2>::dim;

  template <MatrixLike V>
  static auto hat(V const& v) {
    using S = typename V::Scalar;
    Matrix<S, n, n> a = Matrix<S, n, n>::Zero();
    if constexpr (n == 2) {
      a << S(0), -v[0], v[0], S(0);
    } else if constexpr (n == 3) {
      a << S(0), -v[2], v[1], v[2], S(0), -v[0], -v[1], v[0], S(0);
    } else {
      for (int i = 0, k = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j, ++k) a(i, j) = v[k], a(j, i) = -v[k];
    }
    return a;
  }

  /// The skew part of a matrix, as coordinates.
  template <MatrixLike M>
  static auto vee(M const& a) {
    using S = typename M::Scalar;
    Matrix<S, dim, 1> v;
    if constexpr (n == 2) {
      v << (a(1, 0) - a(0, 1)) / S(2);
    } else if constexpr (n == 3) {
      v << (a(2, 1) - a(1, 2)) / S(2), (a(0, 2) - a(2, 0)) / S(2), (a(1, 0) - a(0, 1)) / S(2);
    } else {
      for (int i = 0, k = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j, ++k) v[k] = (a(i, j) - a(j, i)) / S(2);
    }
    return v;
  }

  template <class S>
  static Matrix<S, n, n> inverse(Matrix<S, n, n> const& a) { return a.transpose(); }

  template <class S>
    requires(n == 3)
  static Matrix<S, 3, 1> Ad(Matrix<S, 3, 3> const& a, Matrix<S, 3, 1> const& v) { return a * v; }
  /// \f$\mathrm{Ad}^*_R\,\mu = R^T\mu\f$ in 3-space.
  template <class S>
    requires(n == 3)
  static Matrix<S, 3, 1> Ad_star(Matrix<S, 3, 3> const& a, Matrix<S, 3, 1> const& mu) {
    return a.transpose() * mu;
  }
  template <class S>
    requires(n == 3)
  static Matrix<S, 3, 1> bracket(Matrix<S, 3, 1> const& v, Matrix<S, 3, 1> const& w) { return cross(v, w); }

  /// \f$\alpha + \beta\hat v + \gamma\hat v^2\f$, which for n = 3 is
  /// \f$(\alpha-\gamma|v|^2) + \beta\hat v + \gamma vv^T\f$.
  template <class S>
    requires(n <= 3)
  static Matrix<S, n, n> turn_polynomial(Matrix<S, dim, 1> const& v, S const& alpha, S const& beta,
                                         S const& gamma) {
    Matrix<S, n, n> m;
    if constexpr (n == 2) {
      S const along = alpha - gamma * (v[0] * v[0]), across = beta * v[0];
      m(0, 0) = along, m(0, 1) = -across, m(1, 0) = across, m(1, 1) = along;
    } else {
      Matrix<S, 3, 1> const c = v * gamma, b = v * beta;
      S const xx = c[0] * v[0], yy = c[1] * v[1], zz = c[2] * v[2], xy = c[0] * v[1], xz = c[0] * v[2],
              yz = c[1] * v[2];
      m(0, 0) = alpha - (yy + zz), m(1, 1) = alpha - (xx + zz), m(2, 2) = alpha - (xx + yy);
      m(0, 1) = xy - b[2], m(1, 0) = xy + b[2];
      m(0, 2) = xz + b[1], m(2, 0) = xz - b[1];
      m(1, 2) = yz - b[0], m(2, 1) = yz + b[0];
    }
    return m;
  }

  template <Real S>
    requires(n <= 3)
  static Matrix<S, n, n> exp(Matrix<S, dim, 1> const& v) {
    // exp = 1 + c_1 hat(v) + c_2 hat(v)^2, with Stumpff's functions of the squared angle.
    return turn_polynomial(v, S(1), stumpff<1>(S(v.squaredNorm())), stumpff<2>(S(v.squaredNorm())));
  }

  template <Real S>
    requires(n == 4)
  static Matrix<S, 4, 4> exp(Matrix<S, dim, 1> const& v) {
    return rotation_exponential(Matrix<S, 4, 4>(hat(v)));
  }

  template <Real S>
    requires(n > 4)
  static Matrix<S, n, n> exp(Matrix<S, dim, 1> const& v) {
    Matrix<S, n, n> const e = matrix_exponential(hat(v));
    // Large angles are squared many times, and rounding is squared with them.
    for (Index i = 0; i < v.size(); ++i)
      if (to_double(magnitude(base_value(v[i]))) > 8) return restore(e);
    return e;
  }

  /// Good to rounding up to rotations within 1e-8 of pi; refuses at pi.
  /// @throws OutsideDomain  at a rotation by pi, where the natural chart (3.19) ends
  template <Real S>
  static Matrix<S, dim, 1> log(Matrix<S, n, n> const& a) {
    if constexpr (n == 2)
      return Matrix<S, 1, 1>(angle_of_rotation(S(a(1, 0) - a(0, 1)), S(a(0, 0) + a(1, 1))));
    else if constexpr (n == 3)
      return rotation_vector(a);
    else if constexpr (n > 4 && !Plain<S>)
      return primitive::lifted_log(SO{}, a);
    else
      return vee(rotation_logarithm(a));
  }

  /// The nearest rotation to second order: \f$\tfrac12 R\,(3 - R^T R)\f$.
  /// @throws OutsideDomain  where \f$R^T R\f$ is not even near 1
  template <Real S>
  static Matrix<S, n, n> restore(Matrix<S, n, n> const& a) { return detail::restored_rotation(a); }
};

}  // namespace actio
