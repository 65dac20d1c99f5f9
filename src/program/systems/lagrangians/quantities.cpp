#include "program/systems/lagrangians/quantities.hpp"

#include <utility>

#include "program/registry/conservation.hpp"
#include "program/systems/lagrangians/constrained_input.hpp"
#include "program/systems/lagrangians/shown.hpp"

namespace actio::scene {

namespace {

/// What a state has: velocity, momenta, configuration and what is conserved.
std::vector<Quantity> quantities_of_states() {
  using Kind = Quantity::Kind;
  return {
      {"velocity", Kind::list,
       "The velocity: of the body on the left, in space on the right; that which has the momentum.",
       "v = g^{-1}\\dot g,\\ \\dot g g^{-1}", "of the component over time", "eq_2_16"},
      {"body_momentum", Kind::list, "The momentum of the body, dl/dv on the left.",
       "\\Pi = \\partial l/\\partial v = \\mathrm{Ad}^*_g\\,\\mu", "energy x time", "eq_2_16"},
      {"spatial_momentum", Kind::list, "The momentum in space, dl/dv on the right.",
       "\\mu = \\mathrm{Ad}^*_{g^{-1}}\\,\\Pi", "energy x time", "eq_3_8"},
      {"energy", Kind::scalar, "The energy.", "\\langle\\partial l/\\partial v, v\\rangle - l", "energy"},
      {"configuration", Kind::matrix, "The configuration, an element of the group, as a matrix.", "g", "1"},
      {"casimir", Kind::list,
       "The functions of degree one and two that every motion on the dual of the algebra "
       "conserves, as far as there are any, with the carried vectors where there are some: `actio "
       "run SCENE --dry-run` writes them out.",
       "C(\\Pi, a)", "of the momentum, or its square"},
  };
}

/// What the forces do.
std::vector<Quantity> quantities_of_forces() {
  using Kind = Quantity::Kind;
  return {
      {"force", Kind::list, "The force, in the components of the velocity; 0 where the scene has none.",
       "F(v, a, p, t)", "energy over that of the velocity"},
      {"work", Kind::scalar,
       "The work of the force since the start, and of the reactions of constraints that move. The energy "
       "less the work changes as the square of the step, or as the power that is the order of the method; "
       "with method.conserve to rounding.",
       "\\sum\\tfrac h2\\langle F_k + F_{k+1}, v\\rangle + \\sum\\lambda_k\\cdot b_k", "energy"},
      {"impulse", Kind::list,
       "What the force and the reactions of constraints have added since the start to the momentum that the "
       "symmetry conserves, in space on the left and of the body on the right.",
       "\\sum\\tfrac h2(\\mathrm{Ad}^*_{g_k^{-1}}F_k + \\mathrm{Ad}^*_{g_{k+1}^{-1}}F_{k+1})",
       "energy x time"},
      {"momentum_balance", Kind::list,
       "The momentum that the symmetry conserves without force and reactions, less the impulse: conserved "
       "to rounding with any of them. Of its components those of the basis whose motions change no carried "
       "vector in the Lagrangian.",
       "\\mathrm{Ad}^*_{g^{-1}}\\,\\Pi - I", "energy x time"},
  };
}

/// What constraints on the velocity have.
std::vector<Quantity> quantities_of_constraints() {
  using Kind = Quantity::Kind;
  return {
      {"reaction", Kind::list,
       "The reactions of system.constraints, the force along each row: a function of the state, and as "
       "accurate.",
       "\\tfrac{d}{dt}\\partial l/\\partial v = \\mathrm{ad}^*_vp - J + A^T\\lambda",
       "energy over that of the formula", "claim_10_0_nonholonomic_constraints"},
      {"constraint", Kind::list, "The values of system.constraints, which vanish to rounding.",
       "A(a, t)\\,v - b(a, t)", "of the formula", "claim_10_0_nonholonomic_constraints"},
      {"contact", Kind::list, "The place in space where the body touches, of system.contact.", "g\\,r(a)",
       "of the place"},
  };
}

/// What the method shows in a step from there, and in those behind it.
std::vector<Quantity> quantities_of_steps() {
  using Kind = Quantity::Kind;
  return {
      {"poisson_defect", Kind::scalar,
       "How far the next step is from preserving the Lie-Poisson bracket: 0 to rounding where it "
       "does, 1 where nothing cancels.",
       "|A B A^T - B|/(|A B A^T| + |B|)", "1", "thm_3_2_1"},
      {"symplectic_defect", Kind::scalar,
       "How far the next step is from preserving the canonical two-form of configurations and momenta.",
       "|A^T\\Omega A - \\Omega|/(|A^T\\Omega A| + |\\Omega|)", "1", "eq_3_5"},
      {"leaf_defect", Kind::scalar,
       "How far the next step leads away from the coadjoint orbit, relative to the momentum.",
       "\\min_g|\\Pi_1 - \\mathrm{Ad}^*_g\\Pi_0|/|\\Pi_0|", "1", "thm_3_2_1"},
      {"order", Kind::scalar,
       "The order that the method shows here: from one step, two of half its length and four of a quarter; "
       "of a longer step where its error is lost in rounding.",
       "\\log_2(|\\Phi_h - \\Phi_{h/2}^2|/|\\Phi_{h/2}^2 - \\Phi_{h/4}^4|)", "1"},
      {"tangent_map", Kind::matrix,
       "How momentum and carried vectors now change with those at the start: the product of the "
       "exact derivatives of all steps.",
       "\\partial(\\Pi, a)(t)/\\partial(\\Pi, a)(0)", "1"},
  };
}

}  // namespace

std::vector<Quantity> reduced_quantities() {
  auto all = quantities_of_states();
  for (auto& quantity : quantities_of_forces()) all.push_back(std::move(quantity));
  for (auto& quantity : quantities_of_constraints()) all.push_back(std::move(quantity));
  for (auto& quantity : quantities_of_steps()) all.push_back(std::move(quantity));
  return all;
}

std::vector<Quantity> named_quantities(SceneFile const& file) {
  std::vector<Quantity> out;
  if (file.section("system").has("shape"))
    out.push_back({"shape", Quantity::Kind::list, "The shape variables.", "x", "1"});
  for (auto const& name : carried_names(file))
    out.push_back({name, Quantity::Kind::list, "The carried vector of that name.", "g^{-1}c,\\ g\\,c", "1"});
  return out;
}

/// Those of the scene: what the symmetry conserves depends on the side, and on whether a vector breaks it.
std::vector<Quantity> quantities_of(SceneFile const& file, ReducedScene const& scene) {
  std::set<Feature> here{scene.system->side == systems::Side::left ? Feature::left_invariance
                                                                   : Feature::right_invariance};
  if (scene.system->force) here.insert(Feature::force);
  if (auto const& friction = scene.system->dissipation)
    here.insert(friction->kind == systems::Dissipation::Kind::orbit ? Feature::friction_on_the_orbit
                                                                    : Feature::damping);
  Tape const& l = scene.system->lagrangian;
  for (int i = scene.system->dimension(); i < l.inputs; ++i)
    if (l.depends_on(i)) here.insert(Feature::carried_vector);
  if (scene.constraints) here.insert(Feature::constraint_on_velocity);
  if (scene.constraints && constraints_move(scene)) here.insert(Feature::moving_constraint);
  auto all = with_conserved("euler_poincare", reduced_quantities(), here);
  for (auto& own : named_quantities(file)) all.push_back(std::move(own));
  show_reduced(all, scene);
  return all;
}

}  // namespace actio::scene
