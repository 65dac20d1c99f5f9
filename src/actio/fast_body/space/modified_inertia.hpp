// Moments of inertia with which the Moser-Veselov scheme is of any order.
//
// With 1/I_i replaced by s/I_i + d, where s = 1 + O(h^2) and d = O(h^2) depend on the orbit and the step
// alone, the scheme makes the exact step \cite hairer_vilmart_2006. Both are known here in closed form: in
// j_i = hL/(2I_i) the replacement for parameters delta, T is cos T (sin T + cos T delta_i). Cut off after
// h^{r-2} the power series of s and d give order r. They come from those of short_flow.hpp, by arithmetic of
// series; with 2|p| rho = h^2 H, |p|^2 = h^2 C/2 the first terms are those of Hairer and Vilmart.
#pragma once

#include "actio/fast_body/space/explicit_moser_veselov.hpp"
#include "actio/fast_body/space/short_flow.hpp"
#include "actio/numbers/taylor.hpp"

namespace actio::bodies {

/// \f$\tilde j_i = s\,j_i + d\f$: the replaced moments.
template <class S>
struct ModifiedInertia {
  S s;  ///< factor of the inverse moments; 1 for the scheme as it is
  S d;  ///< what is added to \f$hL/(2I_i)\f$
};

/// The series of s and of d/t, in powers of t^2, t = hL/2.
template <Scalar S>
struct ModifiedInertiaSeries {
  Taylor<S> s;  ///< factor of the inverse moments
  Taylor<S> d;  ///< what is added, over t

  /// @param terms  how many are wanted
  ModifiedInertiaSeries(InverseMoments<S> const& body, Orbit<S> const& orbit, int terms) {
    // x = t^2; z'' = 2 - 4 s1 z + 6 s2 z^2 for t^2 z(x).
    S const ab = orbit.a * orbit.b;
    Taylor<S> const x = Taylor<S>::series([&] {
      std::vector<S> c(terms, S(0));
      if (terms > 1) c[1] = S(1);
      return c;
    }());
    auto const z = from_recurrence(x, S(1), [&](Taylor<S> const& y, int n) {
      S product(0);
      for (int i = 0; i + 2 <= n; ++i) product += y.coefficients[i] * y.coefficients[n - 2 - i];
      return S((S(6) * orbit.s2 * product - S(4) * orbit.s1 * y.coefficients[n - 1]) /
               S((2 * n + 2) * (2 * n + 1)));
    });
    // m/m' over t, and the rate of the twist.
    auto const slope =
        from_recurrence(x, S(1), [&](Taylor<S> const&, int n) { return S(z.coefficient(n) * S(n + 1)); });
    Taylor<S> const lever = z / slope, rest = Taylor<S>(S(1)) - Taylor<S>(ab) * x * z,
                    rate = Taylor<S>(body.J[1]) + Taylor<S>(orbit.beside) / rest;
    // kappa' = (1 + kappa^2) T' for kappa = t k(x).
    auto const k = from_recurrence(x, rate.coefficient(0), [&](Taylor<S> const& y, int n) {
      S sum = rate.coefficient(n);
      for (int l = 0; l < n; ++l) {
        S square(0);
        for (int i = 0; i <= l; ++i) square += y.coefficients[i] * y.coefficients[l - i];
        sum += square * rate.coefficient(n - 1 - l);
      }
      return S(sum / S(2 * n + 1));
    });
    Taylor<S> const cosine_squared = Taylor<S>(S(1)) / (Taylor<S>(S(1)) + x * k * k);
    s = lever * rest * cosine_squared;
    d = (k - lever * Taylor<S>(orbit.beside)) * cosine_squared - s * Taylor<S>(body.J[1]);
  }
};

/// What to replace the moments by for a scheme of order 2, 4, 6, ...
/// @param t  half the step times the magnitude of the momentum
template <Real S>
ModifiedInertia<S> modified_inertia(InverseMoments<S> const& body, Three<S> const& u, S const& t, int order) {
  ModifiedInertiaSeries<S> const series(body, Orbit<S>(body, u), order / 2);
  return {series.s.at(t * t), t * series.d.at(t * t)};
}

/// \f$\tilde j_i = \cos T(\sin T+\cos T\,\delta_i)\f$: the moments with which the Moser-Veselov scheme makes
/// this step.
template <class S>
Three<S> inertia_of(StepParameters<S> const& parameters) {
  Three<S> j;
  for (int i = 0; i < 3; ++i)
    j[i] = parameters.cos_twist * (parameters.sin_twist + parameters.cos_twist * parameters.delta[i]);
  return j;
}

/// The numbers that the scheme with replaced moments works with.
/// @param t  half the step times the magnitude of the momentum
template <Real S>
HalfStep<S> half_step(InverseMoments<S> const& body, ModifiedInertia<S> const& modified, S const& t) {
  S const st = modified.s * t;
  return {{st * body.J[0] + modified.d, st * body.J[1] + modified.d, st * body.J[2] + modified.d},
          st * body.d12,
          st * body.d23};
}

/// The parameters of a step of the Moser-Veselov scheme with these moments, \f$j_i = hL/(2\tilde I_i)\f$;
/// `found` tells whether there is one.
template <Real S>
StepParameters<S> moser_veselov_parameters(Three<S> const& j, Three<S> const& u, bool& found) {
  return moser_veselov_parameters<S>(HalfStep<S>{j, j[0] - j[1], j[1] - j[2]}, u, found);
}

}  // namespace actio::bodies
