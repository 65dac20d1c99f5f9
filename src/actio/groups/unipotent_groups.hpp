// R^n and the Heisenberg group: matrices with ones on the diagonal, whose exponential is a polynomial.
#pragma once

#include "actio/groups/matrix_group.hpp"

namespace actio {

namespace detail {
/// The dimension of \f$\mathbb R^n\f$, known to the compiler.
template <int n>
struct VectorSpaceDimension {
  static constexpr int dimension() { return n; }
};
/// The same, chosen at run time.
template <>
struct VectorSpaceDimension<Dynamic> {
  int size;  ///< the dimension
  int dimension() const { return size; }
};
}  // namespace detail

/// \f$\mathbb R^n\f$ under addition, n known to the compiler, or `Dynamic`: `Translations<Dynamic>{n}`. The
/// abelian case: Ad is the identity, the bracket vanishes, left and right translations agree.
template <int n>
struct Translations : detail::VectorSpaceDimension<n> {
  static constexpr int dim = n;
  template <class S>
  using Value = Matrix<S, n, 1>;

  template <class S>
  Value<S> identity() const { return Value<S>::Zero(this->dimension()); }
  template <class V>
  static V compose(V const& a, V const& b) { return a + b; }
  template <class V>
  static V inverse(V const& a) { return -a; }
  template <class V>
  static V Ad(V const&, V const& v) { return v; }
  template <class V>
  static V bracket(V const& v, V const&) { return V::Zero(v.size()); }
  template <class V>
  static V retract(V const& v) { return v; }
  template <class V>
  static V near_identity(V const& v) { return v; }
  template <class V>
  static V exp(V const& v) { return v; }
  template <class V>
  static V log(V const& a) { return a; }
  template <class V>
  static V restore(V const& a) { return a; }
};

/// The Heisenberg group of matrices ((1, x, z), (0, 1, y), (0, 0, 1)). Coordinates (x, y, z); the bracket is
/// all in z.
struct Heisenberg : Matrices<3, 3> {
  template <MatrixLike V>
  static auto hat(V const& v) {
    using S = typename V::Scalar;
    Matrix<S, 3, 3> a;
    a << S(0), v[0], v[2], S(0), S(0), v[1], S(0), S(0), S(0);
    return a;
  }
  template <MatrixLike M>
  static auto vee(M const& a) { return Matrix<typename M::Scalar, 3, 1>(a(0, 1), a(1, 2), a(0, 2)); }
  /// The exponential itself, a polynomial: \f$1 + A + A^2/2\f$.
  template <class S>
  static Matrix<S, 3, 3> retract(Matrix<S, 3, 1> const& v) {
    auto const a = hat(v);
    Matrix<S, 3, 3> e = a + a * a / S(2);
    e.diagonal().array() += S(1);
    return e;
  }
  template <class S>
  static Matrix<S, 3, 3> exp(Matrix<S, 3, 1> const& v) { return retract(v); }
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
