// When the characteristics of a plane wave cross, so that a shock follows: what a start lets one know of it.
#pragma once

#include <optional>

#include "actio/stored_energy/stored_energies.hpp"
#include "program/systems/media/input.hpp"

namespace actio::scene {

/// When characteristics cross.
struct Crossing {
  double time;  ///< at that time; where it is not exact, not before it
  bool exact;   ///< the start is a simple wave in a periodic direction
};

/// Of a start in a box that depends on one coordinate alone and has velocities along it, with uniform density
/// and without loads. None where the start is none of this kind, or nothing steepens.
///
/// With J the stretch along that coordinate, v the velocity and \f$C^2 = \sigma'(J)/\rho\f$ the square of the
/// speed of characteristics, \f$r = v-\int C\,dJ\f$ runs to the right and \f$s = v+\int C\,dJ\f$ to the left.
/// Along its characteristic \f$Y = \sqrt C\,r_X\f$, and \f$\sqrt C\,s_X\f$ as well, obeys
/// \f$\dot Y = aY^2\f$ with \f$a = C'/(2C^{3/2})\f$ (Lax 1964). In a simple wave a is constant along it, and
/// characteristics cross at the least 1/(aY); otherwise not before one over the largest aY that values of r,
/// s and Y at the start allow, as long as no wave comes from a side.
/// Accuracy: four digits, by differences of the formulas.
template <int d>
std::optional<Crossing> crossing_of_characteristics(MediumMesh const& mesh, MediumStart const& start,
                                                    media::StoredEnergy<d> const& law);

}  // namespace actio::scene
