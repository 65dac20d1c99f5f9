// Aff(1): the maps x -> a x + b of the line with a > 0, as matrices ((a, b), (0, 1)).
//
// The smallest group that is not unimodular and has no invariant metric: a lost star, a wrong side or a wrong sign shows here.
#pragma once

#include "actio/foundations/groups/rotation_logarithm.hpp"

namespace actio {

/// Aff(1). Coordinates (rate of stretching, rate of shifting).
struct Aff1 : Matrices<2, 2> {
  template <class V>
  static auto hat(Eigen::MatrixBase<V> const& v) {
    using S = typename V::Scalar;
    Eigen::Matrix<S, 2, 2> a;
    a << v[0], v[1], S(0), S(0);
    return a;
  }
  template <class M>
  static auto vee(Eigen::MatrixBase<M> const& a) {
    return Eigen::Matrix<typename M::Scalar, 2, 1>(a(0, 0), a(0, 1));
  }
  template <class S>
  static Eigen::Matrix<S, 2, 2> inverse(Eigen::Matrix<S, 2, 2> const& a) {
    if (base_value(a(0, 0)) == Base<S>(0)) throw Singular("inverse", "a map of the line that stretches by more than zero is needed", 0, 0);
    Eigen::Matrix<S, 2, 2> b;
    b << S(1) / a(0, 0), -a(0, 1) / a(0, 0), S(0), S(1);
    return b;
  }
  template <Real S>
  static Eigen::Matrix<S, 2, 2> restore(Eigen::Matrix<S, 2, 2> const& a) {
    Eigen::Matrix<S, 2, 2> b;
    b << a(0, 0), a(0, 1), S(0), S(1);
    return b;
  }
};

}  // namespace actio
