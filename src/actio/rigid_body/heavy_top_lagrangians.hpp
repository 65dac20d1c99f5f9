// Discrete Lagrangians l(f, Gamma) of the heavy top, Gamma before the step: chords and arcs, for the general
// way.
#pragma once

#include "actio/rigid_body/heavy_top_body.hpp"

namespace actio {

/// Chords: \f$\ell(f, \Gamma) = \tfrac1h\mathrm{Tr}((1-f)\Lambda) - \tfrac h2\langle p,
/// \Gamma + f\Gamma\rangle\f$, energy x time. The kinetic part is that of Moser and Veselov.
/// @param h  step, time; not zero
/// @throws OutsideDomain, NotFinite  where it is zero, or no number
template <Real S>
auto trace_lagrangian(HeavyTop<S> const& top, S const& h) {
  if (!is_finite(h)) throw NotFinite("heavy top: step");
  if (h == S(0)) throw OutsideDomain("heavy top", "the step must differ from zero", 0, 0);
  return [lambda = top.inertia.lambda, p = top.lever(), h](auto const& f, auto const& gamma) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    Matrix<T, 3, 1> const after = f.value * gamma;
    T sum(0);
    for (int i = 0; i < 3; ++i)
      sum += (T(1) - f.value(i, i)) * (lambda[i] / h) - (gamma[i] + after[i]) * (p[i] * h / S(2));
    return sum;
  };
}
/// Arcs: \f$\ell(f, \Gamma) = \tfrac1{2h}\langle I\log f, \log f\rangle - h\langle p,
/// f^{1/2}\Gamma\rangle\f$, the Lagrangian in the natural chart, half way between the configurations.
/// @param h  step, time; positive
/// @throws OutsideDomain, NotFinite  where it is not positive, or no number
template <Real S>
auto natural_chart_lagrangian(HeavyTop<S> const& top, S const& h) {
  if (!is_finite(h)) throw NotFinite("heavy top: step");
  if (!(h > S(0)))
    throw OutsideDomain("heavy top", "a step in the natural chart must be positive", to_double(h), 0);
  return [inertia = top.inertia, p = top.lever(), h](auto const& f, auto const& gamma) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    auto const turn = log(f);
    Matrix<T, 3, 1> const between = exp(turn / T(2)).value * gamma;
    T sum = kinetic_energy(inertia, turn) / T(h);
    for (int i = 0; i < 3; ++i) sum -= between[i] * S(p[i] * h);
    return sum;
  };
}

}  // namespace actio
