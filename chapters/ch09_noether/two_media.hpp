// The gas and the solid of chapter 6, as chapter 9 meets them again: discs that move linearly, x = A(t) X.
//
// The gas has the mass 1 - |X|^2 and the pressure (rho/J)^2; the solid is rubber of uniform mass, stiff in
// its middle and soft at its rim. Both are thrown in the same way, and both motions are exact
// (graded_body.hpp).
#pragma once

#include "actio/continuum/stresses.hpp"
#include "ch06_continuum/gas_ellipse.hpp"

// The gas: A'' = 4 (det A)^-1 A^-T.
inline EllipticGas const cloud{1, 2};

// Rubber, and rubber with fibres along the first coordinate of the body.
struct Fibred {
  actio::NeoHookean<double> rubber{1.0, {2.0}};
  double fibres = 0;
  template <class T>
  T operator()(actio::Matrix<T, 2, 2> const& C) const {
    T const stretch = C(0, 0) - actio::Base<T>(1);
    return rubber(C) + stretch * stretch * actio::Base<T>(fibres / 4);
  }
};

// The solid: A'' = -2 dw/dA, with the stress at the centre for dw/dA.
struct RubberDisc {
  actio::OfGreenTensor<Fibred> w;
  auto medium() const {
    return actio::Continuum{actio::Euclidean<2>{}, actio::Euclidean<2>{}, actio::Homogeneous<double>{},
                            GradedEnergy{w}};
  }
  template <class S>
  actio::Matrix<S, 2, 2> operator()(actio::Matrix<S, 2, 2> const& A) const {
    actio::Jet<S, 2, 2> centre{actio::Event<S, 2>::Zero(), actio::Matrix<S, 2, 1>::Zero(),
                               actio::Matrix<S, 2, 3>::Zero()};
    centre.v.template rightCols<2>() = A;
    return actio::first_piola_kirchhoff_stress(medium(), centre) * S(-2);
  }
};
inline RubberDisc const rubber{{{}}}, fibred_rubber{{{{1.0, {2.0}}, 1.0}}};

// The motion of a body as a section, good about the time t.
template <class Body>
auto motion_of(Body const& body, double t) {
  return linear_motion<2>(body, actio::taylor_reference(state_rate<2>(body), thrown_gas(), t), t);
}

// The same materials without the grading: a gas and a rubber whose particles are all alike.
inline actio::Continuum const uniform_gas{actio::Euclidean<2>{}, actio::Euclidean<2>{},
                                          actio::Homogeneous<double>{},
                                          actio::Barotropic{actio::WholePolytropic<double, 1>{1}}};
inline actio::Continuum const uniform_rubber{actio::Euclidean<2>{}, actio::Euclidean<2>{},
                                             actio::Homogeneous<double>{}, rubber.w};

// Maps of the body: a squeeze (s X^1, X^2/s), a quarter turn, and a stretch (s X^1, X^2), which changes
// areas.
struct Squeeze {
  double s;
  template <class V>
  auto operator()(V const& X) const { return V(X[0] * s, X[1] / s); }
};
struct QuarterTurn {
  template <class V>
  auto operator()(V const& X) const { return V(-X[1], X[0]); }
};
struct Stretched {
  double s;
  template <class V>
  auto operator()(V const& X) const { return V(X[0] * s, X[1]); }
};

// A metric of the body for which its area is the mass of the gas.
struct MassAsArea {
  template <class V>
  auto operator()(V const& X) const {
    using T = typename V::Scalar;
    return actio::Matrix<T, 2, 2>(actio::Matrix<T, 2, 2>::Identity() * fading(X));
  }
};
