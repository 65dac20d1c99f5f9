#include "program/registry/conservation.hpp"

#include <algorithm>
#include <utility>

namespace actio::scene {

namespace {

using enum Feature;

/// In the order of the features.
constexpr std::pair<Feature, char const*> clauses[] = {
    {torque, "a torque acts"},
    {torque_depends_on_time, "the torque depends on time"},
    {torque_of_time, "the potential is a formula in the time"},
    {torque_without_axis, "turns about the axis change the potential"},
    {torque_without_potential, "a part of the torque has no potential"},
    {gravity, "gravity acts"},
    {left_invariance, "the Lagrangian is left-invariant"},
    {right_invariance, "the Lagrangian is right-invariant"},
    {carried_vector, "a carried vector is in the Lagrangian"},
    {force, "a force acts"},
    {damping, "the momentum is damped"},
    {friction_on_the_orbit, "friction turns the momentum"},
    {constraint_on_velocity, "the velocity is constrained"},
    {moving_constraint, "a constraint on the velocity moves"},
    {periodic_box, "the box is periodic"},
    {held_side, "a side is fixed, sliding or moved"},
    {moved_side, "a side is moved"},
    {driven_side,
     "a side that is fixed has a velocity at the start, or one that is sliding has one across it"},
    {potential, "gravity or an obstacle acts"},
    {potential_around_a_loop, "a potential grows once around the box, where a loop goes"},
    {traction, "a traction acts"},
    {pressure_on_a_side, "a pressure acts on one side alone"},
    {viscosity, "the method has viscosity"},
    {loop_at_a_side,
     "a loop runs through nodes of a side that is moved, pulled or pressed, or partly of one that is fixed"},
    {third_body, "a third body attracts them"},
    {tides, "there are tides"},
    {held_end, "an end is held"},
    {moved_end, "an end is moved"},
    {end_load, "a force or a moment acts on an end"},
    {pressure_of_the_jacobian, "the density varies and the pressure depends on the Jacobian alone"}};
static_assert([] {
  std::size_t k = 0;
  for (auto const& [feature, words] : clauses)
    if (feature != static_cast<Feature>(k++)) return false;
  return clauses[k - 1].first == pressure_of_the_jacobian;
}());

}  // namespace

char const* in_words(Feature feature) { return clauses[static_cast<std::size_t>(feature)].second; }

std::vector<ConservationLaw> const& conservation_laws() {
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
