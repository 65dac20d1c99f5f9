// Graded bodies: balls whose stiffness fades to nothing at the rim, and their linear motions x = A(t) X,
// which are exact for every stored energy.
//
// The mass per volume is (1 - |X|^2)^k and the stored energy per unit mass (1 - |X|^2) w(F). Where F = A(t)
// is the same everywhere, so is dw/dF, and of the divergence of the stress only the grading is left: d_i
// [(1 - |X|^2)^(k+1)] = -2 (k+1) (1 - |X|^2)^k X_i. All of it is mass times X, and
//
//   A'' = -2 (k+1) dw/dA
//
// solves the field equations at every point, with no force on the rim. A gas that spreads into empty space is
// of this kind, with k = 1/(gamma - 1).
#pragma once

#include <cmath>
#include <vector>

#include "actio/continuum/materials.hpp"
#include "witness/taylor_reference.hpp"

// 1 - |X|^2, the square of the half chord through X.
template <class V>
typename V::Scalar fading(V const& X) { return typename V::Scalar(1) - X.dot(X); }

// Mass per volume of the body; with k = 0 it is `Homogeneous`.
struct GradedMass {
  double exponent;  // k
  template <class V>
  typename V::Scalar operator()(V const& X) const {
    using std::pow;
    return pow(fading(X), exponent);
  }
};

// Stored energy per unit mass, from that of a material.
template <class Energy>
struct GradedEnergy {
  Energy w;
  template <class BodyMetric, class SpaceMetric, class S, int N, int n>
  S operator()(actio::Matrix<S, n, 1> const& X, BodyMetric const& G, SpaceMetric const& g,
               actio::Matrix<S, N, n> const& F) const {
    return fading(X) * w(X, G, g, F);
  }
  // Where w is a fluid's: the energy of the particle X as a function of J.
  template <class V>
  auto law_at(V const& X) const
    requires actio::is_barotropic<Energy>
  {
    return [this, scale = fading(X)]<class T>(T const& J) { return T(T(scale) * w.w(J)); };
  }
};
template <class Energy>
GradedEnergy(Energy) -> GradedEnergy<Energy>;

// A graded fluid is a fluid: its energy is a function of the particle and of J.
template <class Energy>
inline constexpr bool actio::is_barotropic<GradedEnergy<Energy>> = actio::is_barotropic<Energy>;

// A state of a linear motion: A, then its rate of change, each column after column.
template <class S, int n>
using LinearState = actio::Matrix<S, 2 * n * n, 1>;
template <class S, int n>
LinearState<S, n> linear_state(actio::Matrix<S, n, n> const& A, actio::Matrix<S, n, n> const& V) {
  LinearState<S, n> state;
  state << A.reshaped(), V.reshaped();
  return state;
}
template <int n, class S>
actio::Matrix<S, n, n> part_of(actio::Matrix<S, 2 * n * n, 1> const& state, int which) {
  return state.template segment<n * n>(which * n * n).reshaped(n, n);
}

// The rate of change of a state, where `acceleration` gives A'' from A.
template <int n, class Acceleration>
auto state_rate(Acceleration const& acceleration) {
  return [acceleration]<class S>(actio::Matrix<S, 2 * n * n, 1> const& state) {
    actio::Matrix<S, n, n> const A = part_of<n>(state, 0), V = part_of<n>(state, 1);
    return linear_state<S, n>(V, acceleration(A));
  };
}

// A linear motion as a section: A(t) is a power series about a time, good near it.
template <class S, int n>
struct LinearMotion {
  double start;
  std::vector<actio::Matrix<S, n, n>> terms;  // of (t - start)^k
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    T const t = x[0] - T(start);
    actio::Matrix<T, n, n> A = terms.back().template cast<T>();
    for (std::size_t k = terms.size() - 1; k-- > 0;) A = (A * t + terms[k].template cast<T>()).eval();
    return actio::Matrix<T, n, 1>(A * x.template tail<n>());
  }
};

// The linear motion that has this state at the time `start`. Each round of the rate gives one power more.
template <int n, class S, class Acceleration>
LinearMotion<S, n> linear_motion(Acceleration const& acceleration,
                                 actio::Matrix<S, 2 * n * n, 1> const& state, double start = 0,
                                 int powers = 26) {
  using actio::Taylor;
  auto const rate = state_rate<n>(acceleration);
  actio::Matrix<Taylor<S>, 2 * n * n, 1> series;
  for (int i = 0; i < series.size(); ++i) series[i] = Taylor<S>::series({state[i]});
  for (int k = 0; k < powers; ++k) {
    auto const next = rate(series);
    for (int i = 0; i < series.size(); ++i) {
      series[i].coefficients.push_back(next[i].coefficient(k) / S(k + 1));
      series[i].order = k + 1;
    }
  }
  LinearMotion<S, n> motion{start, {}};
  for (int k = 0; k <= powers; ++k) {
    motion.terms.emplace_back();
    for (int i = 0; i < n * n; ++i) motion.terms.back()(i % n, i / n) = series[i].coefficient(k);
  }
  return motion;
}
