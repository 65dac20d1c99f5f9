// Stored energies per unit mass: barotropic fluids, which know the Jacobian alone, and solids, which know the Green tensor.
//
// Moduli are divided by the mass density of the body, so that they are squares of speeds; energies vanish at rest only where that is said.
#pragma once

#include <string>

#include "actio/jets/continuum.hpp"

namespace actio {

/// A barotropic fluid: \f$W = w(J)\f$.
template <class Law>
struct Barotropic {
  Law w;  ///< stored energy per unit mass as a function of J, over any scalar

  template <class BodyMetric, class SpaceMetric, class S, int n>
  S operator()(Eigen::Matrix<S, n, 1> const&, BodyMetric const& G, SpaceMetric const& g, Eigen::Matrix<S, n, n> const& F) const {
    return w(jacobian(G, g, F));
  }

  /// @throws NotOrientationPreserving  where J is not positive
  template <class BodyMetric, class SpaceMetric, class S, int n>
  void examine(Eigen::Matrix<S, n, 1> const& x, BodyMetric const& G, SpaceMetric const& g, Eigen::Matrix<S, n, n> const& F) const {
    S const J = jacobian(G, g, F);
    if (!(base_value(J) > Base<S>(0)))
      throw NotOrientationPreserving("fluid at x = " + detail::shown(x), "the Jacobian of a fluid's motion is positive", to_double(J), 0);
  }
};
template <class Law>
Barotropic(Law) -> Barotropic<Law>;

/// \f$w = \frac{K}{\gamma - 1}J^{1-\gamma}\f$, a polytropic gas: pressure \f$P = \rho K J^{-\gamma}\f$.
template <class S>
struct Polytropic {
  S K;      ///< pressure over density at J = 1
  S gamma;  ///< exponent, not 1
  template <Real T>
  T operator()(T const& J) const {
    using std::pow;
    return pow(J, Base<T>(S(1) - gamma)) * Base<T>(K / (gamma - S(1)));
  }
};

/// The same with a whole exponent \f$\gamma = m + 1\f$: \f$w = \frac{K}{m}J^{-m}\f$, over any field.
template <class S, int m>
struct WholePolytropic {
  S K;  ///< pressure over density at J = 1
  template <class T>
  T operator()(T const& J) const {
    T power = J;
    for (int k = 1; k < m; ++k) power = power * J;
    return T(Base<T>(K) / Base<T>(m)) / power;
  }
};

/// A solid whose energy is a function of the Green tensor with its first index raised: \f$W = w(G^{-1}C)\f$, written for any scalar.
template <class Law>
struct OfGreenTensor {
  Law w;  ///< stored energy per unit mass as a function of the matrix \f$C^i{}_j\f$

  template <class BodyMetric, class SpaceMetric, class S, int N, int n>
  S operator()(Eigen::Matrix<S, n, 1> const&, BodyMetric const& G, SpaceMetric const& g, Eigen::Matrix<S, N, n> const& F) const {
    return w(raised(G, green_tensor(g, F)));
  }
};
template <class Law>
OfGreenTensor(Law) -> OfGreenTensor<Law>;

/// St Venant and Kirchhoff's solid: \f$w = \tfrac\lambda2(\Tr E)^2 + \mu\Tr E^2\f$ with \f$E = \tfrac12(C - 1)\f$.
template <class S>
struct StVenantKirchhoff {
  S lambda, mu;  ///< Lame's moduli over the mass density
  template <class T, int n>
  T operator()(Eigen::Matrix<T, n, n> const& C) const {
    Eigen::Matrix<T, n, n> E = C;
    for (int i = 0; i < n; ++i) E(i, i) -= T(1);
    T trace(0), square(0);
    for (int i = 0; i < n; ++i) {
      trace += E(i, i);
      for (int k = 0; k < n; ++k) square += E(i, k) * E(k, i);
    }
    return trace * trace * Base<T>(lambda / S(8)) + square * Base<T>(mu / S(4));
  }
};

}  // namespace actio
