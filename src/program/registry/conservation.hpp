// Which quantities a motion conserves, and what a scene may have that ends it: one table. It marks the
// quantities of a run, so that a drift is printed of what is conserved and of nothing else.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "program/registry/quantity.hpp"

namespace actio::scene {

/// What a scene may have that ends the conservation of something.
enum class Feature {
  torque,                    ///< on a rigid body
  torque_depends_on_time,    ///< of whatever kind
  torque_of_time,            ///< by a formula, not by turning at a rate
  torque_without_axis,       ///< turns about the axis of the torque change it
  torque_without_potential,  ///< of formulas: friction, a jet
  gravity,                   ///< on a top or a rod
  left_invariance,           ///< of the Lagrangian
  right_invariance,          ///< of the Lagrangian
  carried_vector,            ///< in the Lagrangian
  force,                     ///< on a Lagrangian of one's own
  damping,                   ///< of the momentum, in proportion to it
  friction_on_the_orbit,     ///< which turns the momentum
  constraint_on_velocity,    ///< of a Lagrangian of one's own
  moving_constraint,         ///< which does not hold at rest
  periodic_box,              ///< along some direction
  held_side,                 ///< fixed, sliding or moved
  moved_side,                ///< as its formulas have it
  driven_side,               ///< fixed or sliding, and held to a velocity that it has at the start
  potential,                 ///< gravity or an obstacle
  potential_around_a_loop,   ///< which grows once around the box, along a loop that goes there
  traction,                  ///< on a side
  pressure_on_a_side,        ///< and not all around
  viscosity,                 ///< of the method
  loop_at_a_side,            ///< that is moved, pulled or pressed, or in part at one that is fixed
  third_body,                ///< attracts two bodies
  tides,                     ///< on two bodies
  held_end,                  ///< of a rod
  moved_end,                 ///< of a rod
  end_load,                  ///< a force or a moment on an end of a rod
  pressure_of_the_jacobian   ///< alone, where the density varies: the fluid is not barotropic
};

/// In words, as a clause: "a side is moved".
char const* in_words(Feature feature);

/// A quantity that the motions of a system conserve.
struct ConservationLaw {
  std::string system,           ///< its name
      quantity;                 ///< its name
  std::vector<Feature> unless;  ///< the scene has one of these
};

/// All of them.
std::vector<ConservationLaw> const& conservation_laws();
/// The law of a quantity; null where it is not conserved.
ConservationLaw const* find_law(std::string const& system, std::string const& quantity);
/// Whether the motion conserves it in a scene that has these features.
bool is_conserved(std::string const& system, std::string const& quantity, std::set<Feature> const& here = {});
/// The same quantities, each marked.
std::vector<Quantity> with_conserved(std::string const& system, std::vector<Quantity> all,
                                     std::set<Feature> const& here = {});

}  // namespace actio::scene
