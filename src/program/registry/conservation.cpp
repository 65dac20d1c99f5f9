#include "program/registry/conservation.hpp"

#include <algorithm>

namespace actio::scene {

char const* in_words(Feature feature) {
  switch (feature) {
    case Feature::torque:
      return "a torque acts";
    case Feature::torque_depends_on_time:
      return "the torque depends on time";
    case Feature::torque_of_time:
      return "the potential is a formula in the time";
    case Feature::torque_without_axis:
      return "turns about the axis change the potential";
    case Feature::torque_without_potential:
      return "a part of the torque has no potential";
    case Feature::gravity:
      return "gravity acts";
    case Feature::left_invariance:
      return "the Lagrangian is left-invariant";
    case Feature::right_invariance:
      return "the Lagrangian is right-invariant";
    case Feature::carried_vector:
      return "a carried vector is in the Lagrangian";
    case Feature::force:
      return "a force acts";
    case Feature::damping:
      return "the momentum is damped";
    case Feature::friction_on_the_orbit:
      return "friction turns the momentum";
    case Feature::constraint_on_velocity:
      return "the velocity is constrained";
    case Feature::moving_constraint:
      return "a constraint on the velocity moves";
    case Feature::periodic_box:
      return "the box is periodic";
    case Feature::held_side:
      return "a side is fixed, sliding or moved";
    case Feature::moved_side:
      return "a side is moved";
    case Feature::driven_side:
      return "a side that is fixed has a velocity at the start, or one that is sliding has one across it";
    case Feature::potential:
      return "gravity or an obstacle acts";
    case Feature::potential_around_a_loop:
      return "a potential grows once around the box, where a loop goes";
    case Feature::traction:
      return "a traction acts";
    case Feature::pressure_on_a_side:
      return "a pressure acts on one side alone";
    case Feature::viscosity:
      return "the method has viscosity";
    case Feature::loop_at_a_side:
      return "a loop runs through nodes of a side that is moved, pulled or pressed, or partly of one that is "
             "fixed";
    case Feature::pressure_of_the_jacobian:
      return "the density varies and the pressure depends on the Jacobian alone";
    case Feature::third_body:
      return "a third body attracts them";
    case Feature::tides:
      return "there are tides";
    case Feature::held_end:
      return "an end is held";
    case Feature::moved_end:
      return "an end is moved";
    case Feature::end_load:
      return "a force or a moment acts on an end";
  }
  return "";
}

std::vector<ConservationLaw> const& conservation_laws() {
  using enum Feature;
  static std::vector<ConservationLaw> const all = [] {
    std::vector<ConservationLaw> laws{
        {"rigid_body", "energy", {torque_depends_on_time, torque_without_potential}},
        {"rigid_body", "casimir", {torque}},
        {"rigid_body", "spatial_momentum", {torque}},
        {"rigid_body", "axial_momentum", {torque_without_axis, torque_without_potential}},
        {"rigid_body", "jacobi_integral", {torque_of_time, torque_without_potential}},
        {"rigid_body_n", "energy", {}},
        {"rigid_body_n", "spectrum", {}},
        {"rigid_body_n", "casimir", {}},
        {"heavy_top", "energy", {}},
        {"heavy_top", "casimir", {}},
        {"heavy_top", "vertical_momentum", {}},
        {"heavy_top", "spatial_momentum", {gravity}},
        {"euler_poincare", "energy", {force, damping, friction_on_the_orbit, moving_constraint}},
        {"euler_poincare", "casimir", {force, damping, constraint_on_velocity}},
        {"euler_poincare",
         "spatial_momentum",
         {right_invariance, carried_vector, force, damping, friction_on_the_orbit, constraint_on_velocity}},
        {"euler_poincare",
         "body_momentum",
         {left_invariance, carried_vector, force, damping, friction_on_the_orbit, constraint_on_velocity}},
        {"euler_poincare", "momentum_balance", {damping, friction_on_the_orbit}},
        {"vorticity_sphere", "energy", {}},
        {"vorticity_sphere", "enstrophy", {}},
        {"vorticity_sphere", "angular_momentum", {}},
        {"vorticity_sphere", "casimirs", {}},
        {"vorticity_sphere", "extrema", {}},
        {"vorticity_torus", "energy", {}},
        {"vorticity_torus", "enstrophy", {}},
        {"vorticity_torus", "casimirs", {}},
        {"vorticity_torus", "extrema", {}},
        {"two_bodies", "energy", {third_body, tides}},
        {"two_bodies", "momentum", {third_body}},
        {"rod", "energy", {moved_end, end_load}},
        {"rod", "momentum", {gravity, held_end, end_load}},
        {"rod", "angular_momentum", {gravity, held_end, end_load}},
        {"fluid_on_sphere", "energy", {}},
        {"fluid_on_sphere", "angular_momentum", {}},
        {"barotropic_fluid",
         "circulation",
         {loop_at_a_side, potential_around_a_loop, viscosity, pressure_of_the_jacobian}},
    };
    for (char const* medium :
         {"barotropic_fluid", "elastic_body", "incompressible_fluid", "incompressible_body"}) {
      laws.push_back({medium, "energy", {moved_side, driven_side, pressure_on_a_side}});
      if (!laws.back().system.starts_with("incompressible")) laws.back().unless.push_back(viscosity);
      laws.push_back({medium, "momentum", {held_side, potential, traction, pressure_on_a_side}});
      laws.push_back(
          {medium, "angular_momentum", {periodic_box, held_side, potential, traction, pressure_on_a_side}});
    }
    return laws;
  }();
  return all;
}

ConservationLaw const* find_law(std::string const& system, std::string const& quantity) {
  for (auto const& law : conservation_laws())
    if (law.system == system && law.quantity == quantity) return &law;
  return nullptr;
}

bool is_conserved(std::string const& system, std::string const& quantity, std::set<Feature> const& here) {
  ConservationLaw const* const law = find_law(system, quantity);
  return law && std::ranges::none_of(law->unless, [&here](Feature one) { return here.contains(one); });
}

std::vector<Quantity> with_conserved(std::string const& system, std::vector<Quantity> all,
                                     std::set<Feature> const& here) {
  for (auto& quantity : all) quantity.conserved = is_conserved(system, quantity.name, here);
  return all;
}

}  // namespace actio::scene
