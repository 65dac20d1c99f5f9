// Circulation along closed loops of particles (Kelvin's theorem, from the relabelling current of section 9.1
// of the thesis).
//
// The time component of the relabelling current is -rho u_k sqrt(det G) xi^k with u_k = g_ab phidot^a
// phi^b_,k, the velocity carried back to the body. For a field that runs along a closed loop, all the more
// concentrated on it, the current's integral over the body becomes -rho times the circulation of u along the
// loop: closed current, constant circulation.
#pragma once

#include <numbers>

#include "actio/forms/metric.hpp"
#include "actio/jets/jet.hpp"

namespace actio {

/// The velocity carried back to the body, \f$u_k = g_{ab}\,\dot\phi^a\phi^b{}_{,k}\f$: \f$p_a{}^0v^a{}_k\f$
/// over \f$\rho\sqrt{\det G}\f$.
template <class SpaceMetric, class S, int n, int N>
Matrix<S, n, 1> material_velocity_form(SpaceMetric const& g, Jet<S, n, N> const& j) {
  Matrix<S, N, 1> const lower = lowered(g(j.y), j.velocity());
  // [circulation_form]
  return j.gradient().transpose() * lower;
  // [circulation_form]
}

/// The circulation \f$\oint u_k\,dx^k\f$ along a closed loop of particles at time t.
///
/// \snippet fields.cpp circulation
/// @param phi     section, @param g metric of space
/// @param loop    a callable from an angle in \f$[0, 2\pi]\f$ to points of the body, over any scalar;
///                periodic but for jumps of angular coordinates by their period
/// @param points  of the trapezoidal rule, which is as good as any for periodic functions
/// Accuracy: falls faster than any power of `points` for analytic loops; rounding from some tens on.
template <class Phi, class SpaceMetric, class Loop, class S>
S circulation(Phi const& phi, SpaceMetric const& g, Loop const& loop, S const& t, int points = 64) {
  S sum(0);
  S const step = S(2) * std::numbers::pi_v<double> / S(points);
  for (int i = 0; i < points; ++i) {
    auto const [place, tangent] = derivative(loop, S(step * S(i)));
    constexpr int n = std::remove_cvref_t<decltype(place)>::RowsAtCompileTime;
    Event<S, n> x;
    x << t, place;
    // [circulation]
    sum += material_velocity_form(g, first_jet(phi, x)).dot(tangent) * step;
    // [circulation]
  }
  return sum;
}

/// The vorticity \f$\partial_ju_k - \partial_ku_j\f$ of the velocity form along a section, from its second
/// jet: a skew matrix, in (j, k).
template <class SpaceMetric, class S, int n, int N>
Matrix<S, n, n> material_vorticity(SpaceMetric const& g, SecondJet<S, n, N> const& j) {
  Matrix<S, n, n> slope;
  for (int i = 0; i < n; ++i)
    slope.row(i) = total_derivative(
                       i + 1, [&g](auto const& jet) { return material_velocity_form(g, jet); }, j)
                       .transpose();
  return slope - slope.transpose();
}

}  // namespace actio
