// The two systems that Part I carries through its definitions and theorems.
//
// A book thrown into the air is left-invariant: its energy depends on the angular velocity as the book itself
// experiences it, Omega = g^-1 g', and not on the attitude g. A homogeneous charged ball in a magnetic field
// is right-invariant: the field singles out a direction of space, so the energy depends on the spatial
// angular velocity xi = g' g^-1; how the ball was turned beforehand does not matter, because it is round.
//
//   Omega, xi   velocities in so(3), 1/s         l   reduced Lagrangian, J
#pragma once

#include "actio/groups/group.hpp"
#include "actio/groups/rotations.hpp"

namespace actio {

/// Principal moments of inertia of a book of 0.8 kg, 24 cm by 16 cm by 3 cm, kg m^2: about its spine's
/// direction, across the cover, and through the cover.
inline Vector<double, 3> const book_inertia(0.8 * (0.16 * 0.16 + 0.03 * 0.03) / 12,
                                            0.8 * (0.24 * 0.24 + 0.03 * 0.03) / 12,
                                            0.8 * (0.24 * 0.24 + 0.16 * 0.16) / 12);

/// The reduced Lagrangian of the book: l(Omega) = (I1 Omega1^2 + I2 Omega2^2 + I3 Omega3^2) / 2, a function
/// of the body velocity, J.
inline auto thrown_book() {
  return [](auto const& Omega) {
    auto const& w = Omega.coordinates;
    return (w[0] * w[0] * book_inertia[0] + w[1] * w[1] * book_inertia[1] + w[2] * w[2] * book_inertia[2]) /
           2.0;
  };
}

/// Moment of inertia of a homogeneous ball of 0.2 kg and radius 5 cm, kg m^2.
inline double const ball_inertia = 0.4 * 0.2 * 0.05 * 0.05;
/// The field times the ball's ratio of magnetic moment to angular velocity: a momentum along the vertical, kg
/// m^2/s.
inline Vector<double, 3> const ball_field(0, 0, 3e-4);

/// The turn that a momentum, if it is constant, gives the ball in the time t, s: exp(t mu / I).
inline auto ball_turned(Vector<double, 3> const& mu, double t) {
  return exp(velocity(SO<3>{}, Vector<double, 3>(t / ball_inertia * mu)));
}

/// The reduced Lagrangian of the ball: l(xi) = I |xi|^2 / 2 + <b, xi> with b = `ball_field`, a function of
/// the spatial velocity, J. The second term is the magnetic energy of the turning charge; it makes l uneven
/// in xi.
///
/// The momentum mu = I xi + b precesses about the field: dmu/dt = mu x b / I (Larmor).
inline auto ball_in_field() {
  return [](auto const& xi) {
    auto const& w = xi.coordinates;
    return (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) * (ball_inertia / 2) + w[0] * ball_field[0] +
           w[1] * ball_field[1] + w[2] * ball_field[2];
  };
}

}  // namespace actio
