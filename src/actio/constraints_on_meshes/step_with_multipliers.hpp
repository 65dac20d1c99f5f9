// A step with multipliers: the discrete field equations of an augmented density solved for the multipliers of
// the last level and the values of the next one (chapters 7, 8 and 10 of the thesis).
//
// The forces of the multipliers act at the last level along the slopes of the constraint there, and the
// constraint holds at the next level: for a medium the scheme of Ryckaert, Ciccotti and Berendsen (SHAKE),
// for any density of first jets. Newton's method with exact derivatives and elimination of full matrices: for
// small meshes.
#pragma once

#include "actio/constraints_on_meshes/equations_of_step.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"

namespace actio::media {

namespace detail {

/// Appends a level with a guess, solves, and takes the level back where that fails.
template <class L, class Phi, class S, int n, int N, class Wall, class Guess>
StepReport append_level(AugmentedDensity<L, Phi> const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                        DiscreteExtendedSection<S, n, N, Phi::components>& section, Wall const& wall,
                        Pinned pinned, Guess const& guess,
                        std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> momenta) {
  if (pinned.cell >= mesh.cell_count())
    throw NotAMesh("step", "the pinned cell is one of the mesh; cell", double(pinned.cell),
                   double(mesh.cell_count() - 1));
  auto const saved = section.lambda;
  Level<S, N> level;
  std::vector<unsigned> held;
  for (Index node = 0; node < mesh.node_count(); ++node) {
    held.push_back(components_held<N>(mesh, node));
    Matrix<S, N, 1> y = guess(node);
    if (held.back() != 0) {
      auto const given = given_value(mesh, section.phi, wall, node);
      for (int a = 0; a < N; ++a)
        if (held.back() >> a & 1) y[a] = given[a];
    }
    level.push_back(y);
  }
  section.phi.levels.push_back(std::move(level));
  section.lambda.push_back(section.lambda.back());
  try {
    EquationsOfStep<L, Phi, S, n, N> equations(density, mesh, section, held, std::move(momenta), pinned);
    if constexpr (ConstraintOver<Phi, S, n, N>)
      mesh.for_cells([&](GridIndex<n> const& cell) {
        require_spatial(density.constraint,
                        discrete_jet(cell_of(mesh, section.phi, section.last() - 1, cell), 0));
      });
    constexpr int most = 30;
    std::vector<double> history;
    Base<S> worst(0), last_size(0);
    for (bool done = false; !done;) {
      if (history.size() == most)
        throw NotConverged("step with multipliers", std::move(history), 8 * to_double(epsilon<S>()));
      auto const r = equations.residual(worst);
      history.push_back(to_double(worst));
      auto const change =
          solve_linear(equations.slope(), r,
                       "step with multipliers: constraints of cells depend on each other (pin a "
                       "cell where the sides are closed), or the Lagrangian is not regular");
      equations.correct(change);
      Base<S> largest(0);
      for (auto const& y : section.phi.levels.back()) largest = std::max(largest, magnitude(y));
      Base<S> const size = magnitude(change.head(equations.values()));
      // A rounding or so of the values for each of the edges at a node; or where the constraints magnify it,
      // corrections that get no smaller.
      done = size <= Base<S>(16 * (n + 1)) * epsilon<S>() * largest ||
             (history.size() > 1 && size > last_size / Base<S>(2) &&
              size * size <= epsilon<S>() * largest * largest);
      last_size = size;
    }
    equations.residual(worst);
    equations.examine_next();
    section.lambda.back() = section.lambda[section.last() - 1];
    return {int(history.size()), to_double(worst)};
  } catch (...) {
    section.phi.levels.pop_back();
    section.lambda = saved;
    throw;
  }
}

}  // namespace detail

/// The next level of an extended section: solves \ref discrete_euler_lagrange at the last level for the
/// multipliers there and the values of the next level, at which the constraint of each cell holds, and
/// appends them. The multipliers of the new level are a copy until the next step.
///
/// \snippet ch10_outlook/try_it.cpp step_with_multipliers
/// @param density  an augmented density, energy per volume of space-time; its constraint contains no velocity
/// @param mesh     of space-time; it has the lengths of the steps
/// @param section  at least two levels, and fewer than the mesh has; the constraint holds at both
/// @param wall     where the nodes of fixed sides are, and those of sliding sides across them: a section, or
///                 `AtRest{}`
/// @param pinned   a cell whose constraint follows from the others, where the sides are closed
/// @throws NotConverged, Singular, NotFinite  where the step is too long or constraints are not independent;
///         InconsistentConstraints where that of the pinned cell does not follow; NotSpatial; and what
///         density and constraint refuse at the new level. The section stays as it was. Accuracy: rounding of
///         the equations and of the values. A dense elimination in each of some five iterations: for a few
///         hundred unknowns.
template <class L, class Phi, class S, int n, int N, class Wall = AtRest>
StepReport step(AugmentedDensity<L, Phi> const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                DiscreteExtendedSection<S, n, N, Phi::components>& section, Wall const& wall = {},
                Pinned pinned = {}) {
  require_section(mesh, section);
  auto const guess = detail::guess_of_step(mesh, section.phi);
  return detail::append_level(density, mesh, section, wall, pinned, guess, {});
}

/// The first step from places and velocities: the first multipliers and the values at the end of the first
/// slab whose discrete momentum at its start is the momentum \f$\partial L/\partial v_0\f$ of the density.
///
/// Where the velocities change the constraint, the first multipliers take that part away, in half a step;
/// then they are no pressure.
/// @param section     its first level, alone, at which the constraint holds
/// @param velocities  at the nodes
/// @throws as \ref step
template <class L, class Phi, class S, int n, int N, class Wall = AtRest>
StepReport first_step(AugmentedDensity<L, Phi> const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                      DiscreteExtendedSection<S, n, N, Phi::components>& section,
                      std::type_identity_t<Level<S, N>> const& velocities, Wall const& wall = {},
                      Pinned pinned = {}) {
  require_section(mesh, section);
  auto const moving = detail::moving_through_first_slab(mesh, section.phi, velocities);
  std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> momenta;
  for (Index node = 0; node < mesh.node_count(); ++node)
    momenta.push_back(detail::momentum_of_velocity(density.density, mesh, moving, node));
  return detail::append_level(
      density, mesh, section, wall, pinned, [&](Index node) { return moving(1, node); }, std::move(momenta));
}

}  // namespace actio::media
