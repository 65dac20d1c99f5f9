// The heavy top: a rigid body held at a point, under gravity. Discrete mechanics with an advected vector,
// which is the vertical in the body frame.
//
// The state is (Pi, Gamma): the body momentum about the fixed point, and the unit vector against gravity in
// the body frame, Gamma = g^T k. The attitude g is not part of it. With the weight times the centre of mass,
// p = m |gravity| chi, the Lagrangian is l = <I Omega, Omega>/2 - <p, Gamma>, and the equations of Euler and
// Poisson are
//
//     Pi' = Pi x Omega + Gamma x p,        Gamma' = Gamma x Omega.
//
// (Pi, Gamma) is an element of the dual of se(3), the semidirect product of so(3) with 3-space, and moves on
// a coadjoint orbit of SE(3): |Gamma| and <Pi, Gamma>, the momentum about the vertical, are the Casimirs. The
// frame of the body is that of its principal axes at the fixed point.
#pragma once

#include <Eigen/Core>

#include "actio/groups/motions.hpp"
#include "actio/reduction/advected.hpp"
#include "actio/rigid_body/principal_inertia.hpp"

namespace actio {

/// The state of a heavy top, an \ref AdvectedState of SO(3): its member `momentum` is the body momentum about
/// the fixed point, energy x time, and `vector` is the vertical in the body frame, a unit vector against
/// gravity. Made by \ref release, or in braces: `HeavyTopState<>{momentum, vertical}`, which checks nothing.
template <Real S = double>
using HeavyTopState = AdvectedState<SO<3>, S, 3>;

/// A body held at a point under gravity. Made by \ref heavy_top or \ref held_at_a_point, which check it.
template <Real S = double>
struct HeavyTop {
  using Vector = actio::Matrix<S, 3, 1>;  ///< of 3-space

  S mass;                 ///< not negative; zero for a free body
  Inertia<3, S> inertia;  ///< about the fixed point, in the body frame; mass x length^2
  Vector centre;          ///< centre of mass from the fixed point, in the body frame; length
  Vector gravity;         ///< acceleration, in the frame of space; length/time^2. Zero for a free body

  /// \f$|g|\f$.
  S pull() const {
    using std::sqrt;
    S const scale = magnitude(gravity);
    return scale > S(0) ? S(scale * sqrt((gravity / scale).squaredNorm())) : S(0);
  }
  /// The unit vector against gravity, in the frame of space; the third axis where there is no gravity.
  Vector vertical() const { return pull() > S(0) ? Vector(-gravity / pull()) : Vector(Vector::Unit(2)); }
  /// \f$p = m|g|\chi\f$: weight times centre of mass; energy.
  Vector lever() const { return centre * S(mass * pull()); }
  /// \f$\langle p, \Gamma\rangle\f$: the potential energy, zero with the centre of mass as high as the fixed
  /// point.
  S potential(Vector const& gamma) const { return lever().dot(gamma); }
  /// Kinetic and potential energy. No discrete motion conserves it exactly: its error is bounded, of second
  /// order in the step.
  S energy(HeavyTopState<S> const& state) const {
    return kinetic_energy(inertia, state.momentum) + potential(state.vector);
  }
  /// The same top over another scalar.
  template <Real T>
  HeavyTop<T> over() const {
    return {T(mass), inertia.template over<T>(), centre.template cast<T>(), gravity.template cast<T>()};
  }
};

/// A heavy top from its inertia about the fixed point.
///
/// \snippet bodies.cpp heavy_top
/// @param mass     not negative
/// @param inertia  about the fixed point, in the frame of the principal axes there
/// @param centre   centre of mass from the fixed point, in that frame
/// @param gravity  acceleration, in the frame of space
/// @throws NotFinite          where one of them is no number
/// @throws OutsideDomain      where the mass is negative
/// @throws UnphysicalInertia  where a \f$\Lambda_i\f$ is negative, or where no body of that mass with that
///                            centre has so little inertia: the second moments about the centre,
///                            \f$\Lambda - m\chi\chi^T\f$, must not be negative,
///                            \f$m\sum_i\chi_i^2/\Lambda_i \le 1\f$. Equality is a body without extent in one
///                            direction
template <Real S>
HeavyTop<S> heavy_top(S const& mass, Inertia<3, S> const& inertia, Matrix<S, 3, 1> const& centre,
                      Matrix<S, 3, 1> const& gravity) {
  if (!is_finite(mass) || !is_finite(centre) || !is_finite(gravity) || !is_finite(inertia.lambda))
    throw NotFinite("heavy top: mass, inertia, centre of mass or gravity");
  if (mass < S(0)) throw OutsideDomain("heavy top", "the mass must not be negative", to_double(mass), 0);
  HeavyTop<S> const top{mass, inertia, centre, gravity};
  if (!is_finite(top.lever())) throw NotFinite("heavy top: weight times centre of mass");
  S const scale = magnitude(inertia.lambda), rounding = inertia_tolerance<S>() * scale;
  S share(0);
  for (int i = 0; i < 3; ++i) {
    if (inertia.lambda[i] < S(0))
      throw UnphysicalInertia("heavy top",
                              "no Lambda_i of a body in space is negative; Lambda_" + std::to_string(i + 1) +
                                  " in units of the largest",
                              to_double(S(inertia.lambda[i] / scale)), 0);
    share += mass * (centre[i] / (inertia.lambda[i] + rounding)) * centre[i];
  }
  if (!(share <= S(1)))
    throw UnphysicalInertia("heavy top",
                            "inertia about the fixed point must be at least that of the whole mass at its "
                            "centre; m sum chi_i^2/Lambda_i",
                            to_double(share), 1);
  return top;
}

/// A body with known inertia about its centre of mass, held at a point on one of its principal axes there:
/// \f$\Lambda_i\f$ grows by \f$m\chi_i^2\f$.
///
/// @param about_centre  inertia about the centre of mass; a flat body, with a \f$\Lambda_i\f$ of zero, is one
/// @param centre        centre of mass from the fixed point, with one component that is not zero, or none
/// @throws OutsideDomain  where the centre is on no axis: the principal axes at the fixed point are others
///                        then (\ref held_anywhere finds them)
template <Real S>
HeavyTop<S> held_at_a_point(S const& mass, Inertia<3, S> const& about_centre, Matrix<S, 3, 1> const& centre,
                            Matrix<S, 3, 1> const& gravity) {
  if (!is_finite(mass) || !is_finite(centre)) throw NotFinite("heavy top: mass or centre of mass");
  int off = -1;
  for (int i = 0; i < 3; ++i) off += centre[i] != S(0);
  if (off > 0)
    throw OutsideDomain("heavy top",
                        "the fixed point must lie on a principal axis through the centre of mass; "
                        "components of the way beside it",
                        off, 0);
  if (mass < S(0)) throw OutsideDomain("heavy top", "the mass must not be negative", to_double(mass), 0);
  return heavy_top(mass, inertia_from_lambda<3, S>(about_centre.lambda + mass * centre.cwiseProduct(centre)),
                   centre, gravity);
}

/// A top, and the frame that it is described in.
struct TurnedHeavyTop {
  HeavyTop<double> top;  ///< in the frame of its principal axes at the fixed point
  Eigen::Matrix3d axes;  ///< these axes as columns, in the frame that everything was given in; a rotation
};
/// A body held at any point of it.
///
/// @param tensor  inertia about the centre of mass, 3 by 3, symmetric, in any body frame
/// @param centre  centre of mass from the fixed point, in that frame
/// @throws NotFinite, OutsideDomain, UnphysicalInertia  as \ref heavy_top and \ref principal_inertia
TurnedHeavyTop held_anywhere(double mass, Eigen::Matrix3d const& tensor, Eigen::Vector3d const& centre,
                             Eigen::Vector3d const& gravity);

/// The state of a top that is let go with attitude g and body velocity xi.
template <Real S>
HeavyTopState<S> release(HeavyTop<S> const& top, Element<SO<3>, S> const& g, Velocity<SO<3>, S> const& xi) {
  return {body_momentum(top.inertia, xi), g.value.transpose() * top.vertical()};
}

}  // namespace actio
