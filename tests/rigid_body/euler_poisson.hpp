// The equations of Euler and Poisson, written out: the reference solution that judges the heavy tops.
#pragma once

#include "actio/rigid_body/heavy_top.hpp"

namespace actio::testing {

/// Component by component, for moments about the fixed point and the weight times the centre of mass: nothing
/// of the library is in them.
template <class S>
struct EulerPoisson {
  Matrix<S, 3, 1> moments, lever;

  template <class T>
  Matrix<T, 6, 1> operator()(Matrix<T, 6, 1> const& y) const {
    T const w1 = y[0] / T(moments[0]), w2 = y[1] / T(moments[1]), w3 = y[2] / T(moments[2]), p1(lever[0]),
            p2(lever[1]), p3(lever[2]);
    Matrix<T, 6, 1> rate;
    rate[0] = y[1] * w3 - y[2] * w2 + y[4] * p3 - y[5] * p2;
    rate[1] = y[2] * w1 - y[0] * w3 + y[5] * p1 - y[3] * p3;
    rate[2] = y[0] * w2 - y[1] * w1 + y[3] * p2 - y[4] * p1;
    rate[3] = y[4] * w3 - y[5] * w2;
    rate[4] = y[5] * w1 - y[3] * w3;
    rate[5] = y[3] * w2 - y[4] * w1;
    return rate;
  }
};

/// Momentum and vertical in one column.
template <class S>
Matrix<S, 6, 1> together(HeavyTopState<S> const& state) {
  Matrix<S, 6, 1> y;
  y << state.momentum.components, state.vector;
  return y;
}

}  // namespace actio::testing
