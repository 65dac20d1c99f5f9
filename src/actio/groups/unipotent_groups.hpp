// R^n and the Heisenberg group: matrices with ones on the diagonal, whose exponential is a polynomial.
#pragma once

#include "actio/groups/matrix_group.hpp"

namespace actio {

/// \f$\mathbb R^n\f$ under addition. The abelian case: it sees no side and no star.
template <int n>
struct Translations {
  static constexpr int dim = n;
  static constexpr int dimension() { return n; }
  template <class S>
  using Value = Matrix<S, n, 1>;

  template <class S>
  static Value<S> identity() {
    return Value<S>::Zero();
  }
  template <class S>
  static Value<S> compose(Value<S> const& a, Value<S> const& b) {
    return a + b;
  }
  template <class S>
  static Value<S> inverse(Value<S> const& a) {
    return -a;
  }
  template <class S>
  static Value<S> Ad(Value<S> const&, Value<S> const& v) {
    return v;
  }
  template <class S>
  static Value<S> bracket(Value<S> const&, Value<S> const&) {
    return Value<S>::Zero();
  }
  template <class S>
  static Value<S> retract(Value<S> const& v) {
    return v;
  }
  template <class S>
  static Value<S> near_identity(Value<S> const& v) {
    return v;
  }
  template <class S>
  static Value<S> exp(Value<S> const& v) {
    return v;
  }
  template <class S>
  static Value<S> log(Value<S> const& a) {
    return a;
  }
  template <class S>
  static Value<S> restore(Value<S> const& a) {
    return a;
  }
};

/// The Heisenberg group of matrices ((1, x, z), (0, 1, y), (0, 0, 1)). Coordinates (x, y, z); the bracket is all in z.
struct Heisenberg : Matrices<3, 3> {
  template <MatrixLike V>
  static auto hat(V const& v) {
    using S = typename V::Scalar;
    Matrix<S, 3, 3> a;
    a << S(0), v[0], v[2], S(0), S(0), v[1], S(0), S(0), S(0);
    return a;
  }
  template <MatrixLike M>
  static auto vee(M const& a) {
    return Matrix<typename M::Scalar, 3, 1>(a(0, 1), a(1, 2), a(0, 2));
  }
  /// The exponential itself, a polynomial: \f$1 + A + A^2/2\f$.
  template <class S>
  static Matrix<S, 3, 3> retract(Matrix<S, 3, 1> const& v) {
    auto const a = hat(v);
    Matrix<S, 3, 3> e = a + a * a / S(2);
    e.diagonal().array() += S(1);
    return e;
  }
  template <class S>
  static Matrix<S, 3, 3> exp(Matrix<S, 3, 1> const& v) {
    return retract(v);
  }
  template <class S>
  static Matrix<S, 3, 1> log(Matrix<S, 3, 3> const& a) {
    return {a(0, 1), a(1, 2), a(0, 2) - a(0, 1) * a(1, 2) / S(2)};
  }
  template <class S>
  static Matrix<S, 3, 3> restore(Matrix<S, 3, 3> const& a) {
    Matrix<S, 3, 3> b = Matrix<S, 3, 3>::Identity();
    b(0, 1) = a(0, 1), b(0, 2) = a(0, 2), b(1, 2) = a(1, 2);
    return b;
  }
};

}  // namespace actio
