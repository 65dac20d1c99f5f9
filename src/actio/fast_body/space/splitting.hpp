// Splitting methods: steps that compose kicks, the flow of the potential, and drifts, the exact flow of the
// free body.
//
// A kick changes the momentum by the torque times a time and leaves the attitude; a drift is the free motion
// over a time. Where the torque comes from a potential, both are exact flows of two parts of the energy,
// kinetic and potential, and every product of them is symplectic. Kinetic energy is quadratic in the
// momentum, so that the bracket {V, {V, {V, T}}} vanishes: methods of Runge-Kutta-Nystrom type need no more,
// and have fewer stages.
#pragma once

#include <string>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio::bodies {

/// A step: kick, drift, kick, ..., drift, kick, by parts of the step length. The last kick and the first of
/// the next step are one.
struct Splitting {
  std::string name;            ///< for people
  int order;                   ///< of the error in the step
  std::vector<double> kicks;   ///< one more than drifts; their sum is 1
  std::vector<double> drifts;  ///< their sum is 1
};

/// Order 2: half a kick, a drift, half a kick \cite strang_1968. One kick and one drift a step.
inline Splitting strang_splitting() { return {"Strang", 2, {0.5, 0.5}, {1}}; }

/// Strang's splitting with substeps by these fractions of the step (composition.hpp has some:
/// \ref triple_jump, \ref suzuki, \ref kahan_li).
/// @throws OutsideDomain, NotFinite  where they do not add up to 1, or are no numbers
Splitting composed_splitting(std::string name, int order, std::vector<double> const& fractions);

/// Order 4 of Blanes and Moan \cite blanes_moan_2002, of Runge-Kutta-Nystrom type: six drifts and six kicks a
/// step.
///
/// The free coefficients were used to make the terms of order 5 small: against Suzuki's composition, which
/// has five drifts, the error for as many drifts is smaller by a factor of fifty to a hundred. The
/// coefficients are printed with 15 digits, and what they miss the conditions by is at rounding.
Splitting blanes_moan_splitting();

}  // namespace actio::bodies
