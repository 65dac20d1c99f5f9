// A section, a density and a form that the tests of jets are written on: polynomials with whole coefficients,
// over any scalar.
#pragma once

#include "actio/continuum/continuum.hpp"
#include "actio/jets/cartan.hpp"

namespace actio::testing {

template <class V>
using ScalarOf = typename std::remove_cvref_t<V>::Scalar;

/// A motion of the plane, n = N = 2, of third degree.
struct Motion {
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, 2, 1> y;
    y << x[1] + x[0] * x[2] * x[1] / 3, x[2] * 2 + x[1] * x[1] * x[0] / 5 - x[0] * x[0];
    return y;
  }
};

/// A density that depends on everything, of fourth degree.
struct Density {
  template <class T, int n, int N>
  T operator()(Jet<T, n, N> const& j) const {
    T sum = j.v(0, 0) * j.v(0, 0) + j.v(N - 1, 0) * j.v(N - 1, 0) * 2 -
            j.v(0, n) * j.v(0, n) * j.v(N - 1, 1) + j.x[1] * j.y[0] * j.v(N - 1, n);
    return sum + j.y[0] * j.y[N - 1] * j.v(0, 0) * j.v(0, 1) + j.x[0] * j.y[N - 1];
  }
};

/// A point that no coordinate of is zero.
template <class S>
Matrix<S, 3, 1> event() { return {ratio<S>(1, 3), ratio<S>(-1, 7), ratio<S>(2, 5)}; }

/// A 2-form on 4-space with coefficients of second degree.
struct TwoForm {
  template <class S>
  S operator()(Matrix<S, 4, 1> const& at, Tangents<S, 4, 2> const& V) const {
    auto const minor = [&V](int i, int k) { return S(V(i, 0) * V(k, 1) - V(i, 1) * V(k, 0)); };
    return minor(0, 1) * at[2] * at[3] + minor(1, 3) * at[0] * at[1] - minor(0, 2) * at[3] * at[3] +
           minor(2, 3) * at[1];
  }
};

/// k vectors with small whole entries, in general position.
template <class S, int D, int k>
Tangents<S, D, k> tangents() {
  Tangents<S, D, k> V;
  for (int i = 0; i < D; ++i)
    for (int c = 0; c < k; ++c) V(i, c) = S((7 * i * i + 5 * c + 3 * i * c + c * c) % 11 - 5);
  return V;
}

}  // namespace actio::testing
