// The two sweeps of a step over a rod, some sections side by side: forces of elements, then sections.
//
//     v+ = v + k ((f_a - f_{a-1})/m + g),            x+ = x + h v+,
//     M -> M + k (first_a - second_{a-1}),           q+ = q e,  M+ = e^-1 M e
//
// with the length h of the step, the mean k of that and the one of the step before, and the relative rotation
// e of the scheme of Moser and Veselov for the momentum after the kick. These are the equations (3.11) in
// time and in space: momenta and places of a section see those of two elements and of two steps, and nothing
// else.
//
// In a unit of its own: rod_sweeps.cpp compiles them for every kind of register.
#pragma once

#include "actio/numbers/registers.hpp"
#include "actio/rods/rod_arrays.hpp"

namespace actio::rods {

/// Which elements, or sections, a sweep goes over: from a multiple of `most_lanes` to before `end`.
struct Range {
  std::size_t begin;  ///< the first
  std::size_t end;    ///< before which one it ends
};

/// Forces of elements with the stresses of their strains.
/// @return  whether no element is turned by more than a right angle, and all is finite
bool sweep_elements(Registers registers, RodConstants const& rod, RodState const& state, RodForces& out,
                    Range elements);
/// The same with contact forces that are given: `state.N`.
bool sweep_elements_with(Registers registers, RodConstants const& rod, RodState const& state,
                         Rows<3> const& N, RodForces& out, Range elements);
/// A step of sections.
/// @param kick  k, time
/// @param step  h, time
/// @param from  the state before
/// @param to    that after it; may be the same
/// @return      whether the scheme has a solution for all of them
bool sweep_sections(Registers registers, RodConstants const& rod, RodForces const& forces, double kick,
                    double step, RodState const& from, RodState& to, Range sections);
/// How far elements are from the strain \f$\Gamma_0\f$: \f$\epsilon-\tfrac12w\times\epsilon-D\Gamma_0\f$,
/// length.
/// @return  the largest component; NaN where there is one
double sweep_stretches(Registers registers, RodConstants const& rod, RodState const& state, Rows<3>& out,
                       Range elements);

}  // namespace actio::rods
