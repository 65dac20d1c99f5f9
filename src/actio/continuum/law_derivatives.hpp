// What the field equations need of a law of elasticity: its derivatives, written out for the laws of
// materials.hpp.
//
// Each of them is \f$w = f(\Tr C) + \tfrac b4\Tr C^2 + U(J)\f$. Between Euclidean spaces the divergence of
// its stress knows \f$2f'\f$ and \f$2f''\f$, b and \f$U''\f$; not \f$U'\f$, since the cofactors of a
// deformation gradient have no divergence (Piola's identity).
#pragma once

#include "actio/continuum/materials.hpp"

namespace actio {

/// Where a law has no such part.
struct Absent {};

/// A law \f$w = f(\Tr C) + \tfrac b4\Tr C^2 + U(J)\f$ at a deformation.
/// @tparam Square  the plain number of S, or Absent
/// @tparam Volume  a callable, or Absent
template <class S, class Square, class Volume>
struct SplitLaw {
  S stretch;      ///< \f$2f'\f$
  Base<S> slope;  ///< \f$4f''\f$, a constant
  Square square;  ///< b
  Volume volume;  ///< U, a callable on J over any scalar
};

/// St Venant and Kirchhoff's solid: \f$f = \tfrac\lambda8(\Tr C - n)^2 - \tfrac\mu2\Tr C\f$ and
/// \f$b = \mu\f$. Overload this for a law of your own that has this form.
/// @param trace  \f$\Tr C\f$, @param n dimension of the body
template <class S, class R>
auto split_law(StVenantKirchhoff<R> const& law, S const& trace, int n) {
  using B = Base<S>;
  return SplitLaw<S, B, Absent>{
      (trace - B(n)) * B(law.lambda / R(2)) - B(law.mu), B(law.lambda), B(law.mu), {}};
}

/// A neo-Hookean solid: \f$f = \tfrac\mu2\Tr C\f$ and U.
template <class S, class R, class Volume>
auto split_law(NeoHookean<R, Volume> const& law, S const&, int) {
  auto const volume = [&law]<class T>(T const& J) {
    return law.volume(T(J * J), Base<T>(law.mu) / Base<T>(2));
  };
  return SplitLaw<S, Absent, decltype(volume)>{S(Base<S>(law.mu)), Base<S>(0), {}, volume};
}

/// Mooney and Rivlin's solid: \f$f = c_1\Tr C + \tfrac{c_2}2(\Tr C)^2\f$, \f$b = -2c_2\f$ and U.
template <class S, class R, class Volume>
auto split_law(MooneyRivlin<R, Volume> const& law, S const& trace, int n) {
  using B = Base<S>;
  auto const volume = [&law, n]<class T>(T const& J) {
    return law.volume(T(J * J), Base<T>(law.c1) + Base<T>(law.c2) * Base<T>(n - 1));
  };
  return SplitLaw<S, B, decltype(volume)>{trace * B(R(2) * law.c2) + B(R(2) * law.c1), B(R(4) * law.c2),
                                          B(R(-2) * law.c2), volume};
}

/// The second derivative of a function of one number, any callable, by one evaluation.
template <class S, class F>
S second_derivative(F const& f, S const& x) { return f(SecondOrder<S, 1>::variable(x, 0)).second[0]; }

}  // namespace actio
