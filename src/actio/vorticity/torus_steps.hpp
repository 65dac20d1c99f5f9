// The steps of a flow on the torus: those of the sphere, without its rotations.
//
// The equations are dW/dt = [P, W]/hbar with (Delta - gamma) P = W, and the steps of vorticity_step.hpp and
// fast_vorticity_step.hpp serve as they are. There is no angular momentum, and no frame that turns with the
// flow: the forms energy_casimir and all_invariants are the same one here.
#pragma once

#include "actio/quantized_torus/torus_stream.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio::torus {

/// Steps to rounding.
///
/// \snippet torus.cpp torus_step
using TorusStep = sphere::VorticityStep<TorusStream>;
/// Steps in mixed precision, with the same invariants.
using FastTorusStep = sphere::FastVorticityStep<TorusStream>;

}  // namespace actio::torus

namespace actio::sphere {
// Our own programs have them compiled once (compiled_torus_steps.cpp).
extern template class VorticityStep<torus::TorusStream>;
extern template class FastVorticityStep<torus::TorusStream>;
}  // namespace actio::sphere
