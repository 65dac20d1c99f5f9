// How a step of two bodies is made: drifts, in which the bodies turn freely and the orbit is straight or
// Kepler's, and kicks by the rest of the mutual potential.
//
// A drift is the exact flow of the kinetic energy, of the orbit by Kepler with the attraction of the masses
// as points, or of a discrete Lagrangian (Moser and Veselov); a kick that of a potential. So each step is
// symplectic, conserves the momentum of the whole to rounding, and a step by -h undoes it.
#pragma once

#include "actio/fast_body/space/splitting.hpp"

namespace actio::bodies {

/// How a body turns in a drift.
enum class Rotor {
  exact,         ///< as a free body does
  moser_veselov  ///< by the scheme of Moser and Veselov, order 2
};

/// A method for two bodies.
struct PairMethod {
  Splitting splitting;         ///< into kicks and drifts
  bool kepler = false;         ///< whether orbits between kicks are Kepler's
  Rotor rotor = Rotor::exact;  ///< how bodies turn between kicks
};

/// Straight orbits and exact rotors: order 2 (\ref strang_splitting) or 4 (\ref blanes_moan_splitting), one
/// or six kicks a step.
/// @throws OutsideDomain  for another order
PairMethod pair_splitting(int order = 2);

/// The method ABA(8,6,4) of Blanes and others \cite blanes_2013, drift first: where the kicks are small, of
/// size \f$\epsilon\f$, the error of a step of length h is \f$\epsilon h^8+\epsilon^2h^6+\epsilon^3h^4\f$.
/// Seven kicks a step.
Splitting aba_864_splitting();

/// Kepler's orbits and exact rotors as drifts, composed by \ref aba_864_splitting. Between real binaries the
/// rest of the potential is a small part: steps may be as long as a quarter of a radian of the orbit.
PairMethod kepler_splitting();

/// The Lie group variational integrator of two bodies: straight orbits, rotors by Moser and Veselov, order 2.
/// Its discrete Lagrangian is
/// \f[ L_d=\sum_i\Big[\frac{m_i|\Delta x_i|^2}{2h}+\frac{\mathrm{tr}((1-F_i)J_i)}h\Big]-\frac h2(V_0+V_1).
///   \f]
/// Known as LGVI \cite lee_leok_mcclamroch_2007; here without an iteration on the group.
PairMethod moser_veselov_pair();

}  // namespace actio::bodies
