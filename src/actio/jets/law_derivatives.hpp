// What the field equations need of a law of elasticity: its derivatives, written out for the laws of materials.hpp.
//
// Each of them is \f$w = f(\Tr C) + \tfrac b4\Tr C^2 + U(J)\f$. Between Euclidean spaces the divergence of its stress knows \f$2f'\f$ and \f$2f''\f$, b and \f$U''\f$; not
// \f$U'\f$, since the cofactors of a deformation gradient have no divergence (Piola's identity).
#pragma once

#include "actio/jets/materials.hpp"

namespace actio {

/// A law \f$w = f(\Tr C) + \tfrac b4\Tr C^2 + U(J)\f$ by its derivatives. Specialise it for a law of your own that has this form:
/// `stretch(law, trace)` is \f$2f'\f$ and `stretch_slope(law)` is \f$4f''\f$, a constant; `square(law)` is b where `has_square`; `volume(law, J)` is U where `has_volume`.
template <class Law>
struct SplitLaw {
  static constexpr bool known = false;
};

/// f and b of St Venant and Kirchhoff's solid: \f$f = \tfrac\lambda8(\Tr C - n)^2 - \tfrac\mu2\Tr C\f$, \f$b = \mu\f$.
template <class R>
struct SplitLaw<StVenantKirchhoff<R>> {
  static constexpr bool known = true, has_square = true, has_volume = false;
  template <int n, class S>
  static S stretch(StVenantKirchhoff<R> const& law, S const& trace) {
    return (trace - Base<S>(n)) * Base<S>(law.lambda / R(2)) - Base<S>(law.mu);
  }
  template <int n>
  static R stretch_slope(StVenantKirchhoff<R> const& law) {
    return law.lambda;
  }
  static R square(StVenantKirchhoff<R> const& law) { return law.mu; }
};

/// f and U of a neo-Hookean solid: \f$f = \tfrac\mu2\Tr C\f$.
template <class R, class Volume>
struct SplitLaw<NeoHookean<R, Volume>> {
  static constexpr bool known = true, has_square = false, has_volume = true;
  template <int n, class S>
  static S stretch(NeoHookean<R, Volume> const& law, S const&) {
    return S(Base<S>(law.mu));
  }
  template <int n>
  static R stretch_slope(NeoHookean<R, Volume> const&) {
    return R(0);
  }
  template <int n, class T>
  static T volume(NeoHookean<R, Volume> const& law, T const& J) {
    return law.volume(T(J * J), Base<T>(law.mu) / Base<T>(2));
  }
};

/// f, b and U of Mooney and Rivlin's solid: \f$f = c_1\Tr C + \tfrac{c_2}2(\Tr C)^2\f$, \f$b = -2c_2\f$.
template <class R, class Volume>
struct SplitLaw<MooneyRivlin<R, Volume>> {
  static constexpr bool known = true, has_square = true, has_volume = true;
  template <int n, class S>
  static S stretch(MooneyRivlin<R, Volume> const& law, S const& trace) {
    return trace * Base<S>(R(2) * law.c2) + Base<S>(R(2) * law.c1);
  }
  template <int n>
  static R stretch_slope(MooneyRivlin<R, Volume> const& law) {
    return R(4) * law.c2;
  }
  static R square(MooneyRivlin<R, Volume> const& law) { return R(-2) * law.c2; }
  template <int n, class T>
  static T volume(MooneyRivlin<R, Volume> const& law, T const& J) {
    return law.volume(T(J * J), Base<T>(law.c1) + Base<T>(law.c2) * Base<T>(n - 1));
  }
};

/// The second derivative of a function of one number, any callable, by one evaluation.
template <class S, class F>
S second_derivative(F const& f, S const& x) {
  return f(SecondOrder<S, 1>::variable(x, 0)).second[0];
}

}  // namespace actio
