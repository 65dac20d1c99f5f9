// Stored energies: barotropic fluids, which know the Jacobian alone, and solids, which know the Green tensor.
//
// Energies are per unit mass, so their unit, and that of all moduli here, is a speed squared: a modulus over
// the mass density of the body. Times rho they are pressures. Laws are written over any field where they have
// whole powers, and over scalars with roots where they have real powers or logarithms.
#pragma once

#include <string>

#include "actio/continuum/continuum.hpp"

namespace actio {

/// A mass density that grows linearly: \f$\rho(x) = \rho_0\,(1 + s\cdot x)\f$. Media refuse points where it
/// is not positive.
template <class S, int n>
struct LinearDensity {
  S at_origin;            ///< \f$\rho_0\f$, mass per volume of the body; positive
  Matrix<S, n, 1> slope;  ///< s, per length of the body
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    T sum(1);
    for (int i = 0; i < n; ++i) sum += x[i] * Base<T>(slope[i]);
    return T(sum * Base<T>(at_origin));
  }
};

// ---- Fluids.

/// A barotropic fluid: \f$W = w(J)\f$, with any law w; its pressure is \f$-\rho w'(J)\f$. Made in braces of
/// its law: `Barotropic{Polytropic<double>{K, gamma}}`.
///
/// \snippet fields.cpp barotropic
template <class Law>
struct Barotropic {
  Law w;  ///< stored energy per unit mass as a function of J, over any scalar

  template <class BodyMetric, class SpaceMetric, class S, int n>
  S operator()(Matrix<S, n, 1> const&, BodyMetric const& G, SpaceMetric const& g,
               Matrix<S, n, n> const& F) const {
    return w(jacobian(G, g, F));
  }

  /// @throws NotOrientationPreserving  where J is not positive
  /// @throws NotASquare  over the rationals, where the volume of space is irrational
  template <class BodyMetric, class SpaceMetric, class S, int n>
  void examine(Matrix<S, n, 1> const& x, BodyMetric const& G, SpaceMetric const& g,
               Matrix<S, n, n> const& F) const {
    require_volume(g, x, "metric of space at phi(x), x =");
    require_orientation(S(jacobian(G, g, F)), x, "fluid");
  }
};
template <class Law>
Barotropic(Law) -> Barotropic<Law>;

/// Whether a stored energy is a function of the particle and of the Jacobian alone.
template <class Energy>
inline constexpr bool is_barotropic = false;
/// These are.
template <class Law>
inline constexpr bool is_barotropic<Barotropic<Law>> = true;

namespace detail {
/// \f$x^m\f$, m positive.
template <int m, class T>
T whole_power(T const& x) {
  T power = x;
  for (int k = 1; k < m; ++k) power = power * x;
  return power;
}
}  // namespace detail

/// \f$w = \frac{K}{\gamma - 1}J^{1-\gamma}\f$, a polytropic gas: pressure \f$P = \rho K J^{-\gamma}\f$.
template <class S>
struct Polytropic {
  S K;      ///< pressure over mass density at J = 1, speed squared; positive
  S gamma;  ///< exponent, not 1; above 1 for a gas, 1.4 for air
  template <Real T>
  T operator()(T const& J) const {
    using std::pow;
    return pow(J, Base<T>(S(1) - gamma)) * Base<T>(K / (gamma - S(1)));
  }
};

/// The same with a whole exponent \f$\gamma = m + 1\f$: \f$w = \frac{K}{m}J^{-m}\f$, over any field.
template <class S, int m>
struct WholePolytropic {
  S K;  ///< pressure over mass density at J = 1, speed squared; positive
  template <class T>
  T operator()(T const& J) const { return T(Base<T>(K) / Base<T>(m)) / detail::whole_power<m>(J); }
};

/// Tait's liquid, \f$w = B\bigl(\frac{J^{1-\gamma} - 1}{\gamma - 1} + J - 1\bigr)\f$: pressure
/// \f$P = \rho B\,(J^{-\gamma} - 1)\f$, zero at J = 1, speed of sound \f$\sqrt{\gamma B}\f$ there.
template <class S>
struct Tait {
  S B;      ///< modulus over mass density, speed squared; positive, \f$c^2/\gamma\f$ for the speed of sound c
  S gamma;  ///< exponent, not 1; about 7 for water
  template <Real T>
  T operator()(T const& J) const {
    using std::pow;
    return ((pow(J, Base<T>(S(1) - gamma)) - Base<T>(1)) / Base<T>(gamma - S(1)) + J - Base<T>(1)) *
           Base<T>(B);
  }
};

/// The same with a whole exponent \f$\gamma = m + 1\f$, over any field.
template <class S, int m>
struct WholeTait {
  S B;  ///< modulus over mass density, speed squared; positive, \f$c^2/\gamma\f$ for the speed of sound c
  template <class T>
  T operator()(T const& J) const {
    return ((T(1) / detail::whole_power<m>(J) - Base<T>(1)) / Base<T>(m) + J - Base<T>(1)) * Base<T>(B);
  }
};

// ---- Solids.

/// A solid whose energy is a function of the Green tensor with its first index raised: \f$W = w(G^{-1}C)\f$,
/// written for any scalar. Made in braces of its law:
/// `OfGreenTensor{NeoHookean{mu, LogarithmicVolume{lambda}}}`.
template <class Law>
struct OfGreenTensor {
  Law w;  ///< stored energy per unit mass as a function of the matrix \f$C^i{}_j\f$

  template <class BodyMetric, class SpaceMetric, class S, int N, int n>
  S operator()(Matrix<S, n, 1> const&, BodyMetric const& G, SpaceMetric const& g,
               Matrix<S, N, n> const& F) const {
    return w(raised(G, green_tensor(g, F)));
  }

  /// Where the law resists collapse, refuses a body without volume, or turned inside out.
  /// @throws NotOrientationPreserving  with det F, or det C where space has more dimensions than the body
  template <class BodyMetric, class SpaceMetric, class S, int N, int n>
  void examine(Matrix<S, n, 1> const& x, BodyMetric const&, SpaceMetric const& g,
               Matrix<S, N, n> const& F) const {
    if constexpr (requires { Law::resists_collapse; }) {
      if constexpr (n == N)
        require_orientation(S(determinant(F)), x, "solid");
      else
        require_orientation(S(determinant(green_tensor(g, F))), x, "solid");
    }
  }
};
template <class Law>
OfGreenTensor(Law) -> OfGreenTensor<Law>;

namespace detail {
/// \f$\mathrm{tr}\,C\f$ and \f$\mathrm{tr}\,C^2\f$.
template <class T, int n>
std::array<T, 2> traces(Matrix<T, n, n> const& C) {
  T trace(0), square(0), crossed(0);
  for (int i = 0; i < n; ++i) {
    trace += C(i, i);
    add_product(square, C(i, i), C(i, i));
    for (int k = 0; k < i; ++k) add_product(crossed, C(i, k), C(k, i));
  }
  square += crossed;
  square += crossed;
  return {trace, square};
}
}  // namespace detail

/// St Venant and Kirchhoff's solid: \f$w = \tfrac\lambda2(\Tr E)^2 + \mu\Tr E^2\f$ with
/// \f$E = \tfrac12(C - 1)\f$. It does not resist collapse: it is for strains well below 1.
template <class S>
struct StVenantKirchhoff {
  S lambda;  ///< Lame's first modulus over the mass density, speed squared; above \f$-2\mu/n\f$
  S mu;      ///< shear modulus over the mass density, speed squared; positive
  template <class T, int n>
  T operator()(Matrix<T, n, n> const& C) const {
    Matrix<T, n, n> E = C;
    for (int i = 0; i < n; ++i) E(i, i) = E(i, i) - Base<T>(1);
    auto const [trace, square] = detail::traces(E);
    return trace * trace * Base<T>(lambda / S(8)) + square * Base<T>(mu / S(4));
  }
};

/// The part of a solid's energy that knows the volume, \f$U = -s\log I + \tfrac\lambda8\log^2 I\f$ with
/// \f$I = J^2 = \det C\f$; s is the slope that leaves the solid free of stress at rest, and comes from the
/// solid: \f$\mu/2\f$ for \ref NeoHookean.
template <class S>
struct LogarithmicVolume {
  S lambda;  ///< Lame's first modulus over the mass density, speed squared; zero or more
  template <Real T>
  T operator()(T const& I, Base<T> const& slope) const {
    using std::log;
    T const l = log(I);
    return l * l * Base<T>(lambda / S(8)) - l * slope;
  }
};

/// The same by a power, over any field: \f$U = \tfrac sm(I^{-m} - 1)\f$, with \f$\lambda = 2m\mu\f$ for a
/// neo-Hookean solid (Blatz and Ko's).
/// @tparam m  a whole number, 1 or more: the larger, the less the volume changes
template <int m>
struct PowerVolume {
  template <class T>
  T operator()(T const& I, Base<T> const& slope) const {
    return (T(1) / detail::whole_power<m>(I) - Base<T>(1)) * Base<T>(slope / Base<T>(m));
  }
};

/// A neo-Hookean solid: \f$w = \tfrac\mu2(\Tr C - n) + U(\det C)\f$. Energy and stress vanish at rest.
///
/// Made in braces, the shear modulus first: `NeoHookean{mu, LogarithmicVolume<double>{lambda}}` has
/// \f$w = \tfrac\mu2(\Tr C - n) - \mu\log J + \tfrac\lambda2\log^2J\f$, and Lame's moduli
/// \f$\rho\lambda\f$, \f$\rho\mu\f$ at small strains; `NeoHookean{mu, PowerVolume<m>{}}` is Blatz and Ko's.
template <class S, class Volume = LogarithmicVolume<S>>
struct NeoHookean {
  static constexpr bool resists_collapse = true;  ///< there is no energy without volume
  S mu;           ///< shear modulus over the mass density, speed squared; positive
  Volume volume;  ///< U, given \f$\det C\f$ and its slope at rest, speed squared
  template <class T, int n>
  T operator()(Matrix<T, n, n> const& C) const {
    Base<T> const half = Base<T>(mu) / Base<T>(2);
    return (C.trace() - Base<T>(n)) * half + volume(determinant(C), half);
  }
};
template <class S, class Volume>
NeoHookean(S, Volume) -> NeoHookean<S, Volume>;

/// Mooney and Rivlin's solid: \f$w = c_1(I_1 - n) + c_2\bigl(I_2 - \tfrac{n(n-1)}2\bigr) + U(\det C)\f$ with
/// \f$I_1 = \Tr C\f$, \f$I_2 = \tfrac12(I_1^2 - \Tr C^2)\f$; its shear modulus is
/// \f$2(c_1 + (n - 2)\,c_2)\f$, positive. Energy and stress vanish at rest. Made in braces:
/// `MooneyRivlin{c1, c2, LogarithmicVolume<double>{lambda}}`.
template <class S, class Volume = LogarithmicVolume<S>>
struct MooneyRivlin {
  static constexpr bool resists_collapse = true;  ///< there is no energy without volume
  S c1;           ///< modulus of the first invariant over the mass density, speed squared; positive
  S c2;           ///< modulus of the second over the mass density, speed squared; zero or more
  Volume volume;  ///< U, given \f$\det C\f$ and its slope at rest, speed squared
  template <class T, int n>
  T operator()(Matrix<T, n, n> const& C) const {
    auto const [trace, square] = detail::traces(C);
    T const second = (trace * trace - square) / Base<T>(2) - Base<T>(n * (n - 1) / 2);
    Base<T> const slope = Base<T>(c1) + Base<T>(c2) * Base<T>(n - 1);
    return (trace - Base<T>(n)) * Base<T>(c1) + second * Base<T>(c2) + volume(determinant(C), slope);
  }
};
template <class S, class Volume>
MooneyRivlin(S, S, Volume) -> MooneyRivlin<S, Volume>;

}  // namespace actio
