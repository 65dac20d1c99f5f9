// Aff(1): the maps x -> a x + b of the line with a > 0, as matrices ((a, b), (0, 1)).
//
// The smallest group that is not unimodular and has no invariant metric: a lost star, a wrong side or a wrong
// sign shows here.
#pragma once

#include "actio/groups/rotation_logarithm.hpp"

namespace actio {

/// Aff(1). Coordinates (rate of stretching, rate of shifting).
struct Aff1 : Matrices<2, 2> {
  template <MatrixLike V>
  static auto hat(V const& v) {
    using S = typename V::Scalar;
    Matrix<S, 2, 2> a;
    a << v[0], v[1], S(0), S(0);
    return a;
  }
  template <MatrixLike M>
  static auto vee(M const& a) { return Matrix<typename M::Scalar, 2, 1>(a(0, 0), a(0, 1)); }
  template <class S>
  static Matrix<S, 2, 2> inverse(Matrix<S, 2, 2> const& a) {
    if (base_value(a(0, 0)) == Base<S>(0))
      throw Singular("inverse", "a map of the line that stretches by more than zero is needed", 0, 0);
    Matrix<S, 2, 2> b;
    b << S(1) / a(0, 0), -a(0, 1) / a(0, 0), S(0), S(1);
    return b;
  }
  template <Real S>
  static Matrix<S, 2, 2> restore(Matrix<S, 2, 2> const& a) {
    Matrix<S, 2, 2> b;
    b << a(0, 0), a(0, 1), S(0), S(1);
    return b;
  }
};

}  // namespace actio
