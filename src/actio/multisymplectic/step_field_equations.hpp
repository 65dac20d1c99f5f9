// Steps of a multisymplectic integrator: the discrete field equations solved for the next level of time.
//
// With masses lumped at the nodes the equations of a medium are explicit: the next value at a node is the
// solution of N equations of its own. A density in which velocities meet gradients couples neighbours; then
// the nodes are gone through again until all equations hold.
#pragma once

#include "actio/multisymplectic/discrete_field_equations.hpp"

namespace actio::media {

/// Where the nodes of fixed sides are if no motion is prescribed, and those of sliding sides across them:
/// where they were.
struct AtRest {};

/// How a level was solved for.
struct StepReport {
  int sweeps = 0;       ///< times that the nodes were gone through
  double residual = 0;  ///< the largest, over the terms that it is made from
};

namespace detail {

/// Where a node that is held is at the next level: on a sliding side this counts across the side alone.
template <class S, int n, int N, class Wall>
Matrix<S, N, 1> given_value(SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N> const& section,
                            Wall const& wall, Index node) {
  int const next = section.last() + 1;
  if constexpr (std::same_as<Wall, AtRest>) {
    return section(next - 1, node);
  } else {
    Matrix<S, N, 1> const y = wall(mesh.event(next, node)).template cast<S>();
    require_finite(y, "motion of a fixed side");
    return y;
  }
}

/// One Newton step for the value at a node of the last level, with the others held: the equations are
/// momentum = momentum at the start of the slab.
/// @return whether the value was right as it was
template <class S, int n, int N, class L>
bool correct_node(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N>& section,
                  Index node, SumOfTerms<Matrix<S, N, 1>, Base<S>> const& momentum, bool at_least_once,
                  Base<S>& worst) {
  int const slab = section.last() - 1;
  auto r = cartan_forms_of_slab(density, mesh, section, slab, node, 0);
  r.add(momentum.sum);
  r.terms += momentum.terms;
  unsigned const held = mesh.held_across(node);
  for (int a = 0; a < N; ++a)
    if (held >> a & 1) r.sum[a] = S(0);
  require_finite(r.sum, "step: the density is not defined near the next level; the step may be too long");
  // Each of the forms is a sum of 2^(n+1) (n+2) terms at most, and each term carries a few roundings.
  Base<S> const size = magnitude(r.sum);
  // Over a field without order a residual is there or not, and has no size.
  if (!ordered_arithmetic<Base<S>>())
    worst = std::max(worst, size);
  else if (r.terms > Base<S>(0))
    worst = std::max(worst, Base<S>(size / r.terms));
  if (!at_least_once && size <= Base<S>(8) * epsilon<S>() * r.terms) return true;

  // [step_field_equations]
  Matrix<S, N, N> slope = Matrix<S, N, N>::Zero();
  Base<S> largest(0);
  mesh.for_cells_at(node, [&](GridIndex<n> const& cell, int b) {
    auto const here = cell_of(mesh, section, slab, cell);
    slope += discrete_mixed_derivative(density, here, node_of_corner<n>(b, 0), node_of_corner<n>(b, 1));
    largest = std::max(largest, magnitude(here.y));
  });
  // What a sliding side holds does not change, and asks nothing of the others.
  for (int a = 0; a < N; ++a)
    if (held >> a & 1) slope.row(a) = Matrix<S, 1, N>::Unit(a);
  auto const change = solve_linear(slope, r.sum, "step: the discrete Lagrangian is not regular");
  section(slab + 1, node) -= change;
  // [step_field_equations]
  // Differences of values are told to the rounding of these, and below the step at which the scheme is
  // unstable no force moves a value by more: a rounding or so for each of the edges at the node.
  return !at_least_once && magnitude(change) <= Base<S>(16 * (n + 1)) * epsilon<S>() * largest;
}

/// Solves for the last level of a section, which holds a guess, given the momenta at the start of its slab.
template <class S, int n, int N, class L>
StepReport solve_level(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                       DiscreteSection<S, n, N>& section,
                       std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> const& momenta) {
  constexpr int most = 100;
  StepReport report;
  std::vector<double> history;
  for (bool done = false; !done;) {
    if (report.sweeps == most)
      throw NotConverged("step of the discrete field equations", std::move(history),
                         8 * to_double(epsilon<S>()));
    done = true;
    Base<S> worst(0);
    for (Index node = 0; node < mesh.node_count(); ++node)
      if (!mesh.fixed(node) &&
          !correct_node(density, mesh, section, node, momenta[node], report.sweeps == 0, worst))
        done = false;
    ++report.sweeps;
    history.push_back(to_double(worst));
  }
  report.residual = history.back();
  examine_slab(density, mesh, section, section.last() - 1);
  return report;
}

/// Which components of the value at a node are given: bit a for component a.
/// @throws NotAMesh  where a side holds a component that sections do not have
template <int N, class S, int n>
unsigned components_held(SpaceTimeMesh<S, n> const& mesh, Index node) {
  if (mesh.fixed(node)) return ~0u;
  unsigned const held = mesh.held_across(node);
  if (held >> N != 0)
    throw NotAMesh("step", "sections slide along sides across their own components; components", N, n);
  return held;
}

/// Where nodes come to at the next level with the velocities of the last slab: a callable on nodes.
/// @throws NotAMesh  where there is no such slab, or no next level
template <class S, int n, int N>
auto guess_of_step(SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N> const& section) {
  int const now = section.last();
  if (now < 1) throw NotAMesh("step", "two levels determine the next one; levels", now + 1, 2);
  if (now + 1 >= mesh.levels())
    throw NotAMesh("step", "the mesh has a level to step to; level", now + 1, mesh.levels() - 1);
  Base<S> const ratio_of_steps =
      (mesh.time(now + 1) - mesh.time(now)) / (mesh.time(now) - mesh.time(now - 1));
  return [&section, now, ratio_of_steps](Index node) -> Matrix<S, N, 1> {
    return section(now, node) + (section(now, node) - section(now - 1, node)) * ratio_of_steps;
  };
}

/// Appends a guess for the next level, which the mesh has, solves for it, and takes it back where that fails.
template <class S, int n, int N, class L, class Wall, class Guess, class Momenta>
StepReport append_level(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                        DiscreteSection<S, n, N>& section, Wall const& wall, Guess const& guess,
                        Momenta const& momentum) {
  Level<S, N> level;
  std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> momenta;
  for (Index node = 0; node < mesh.node_count(); ++node) {
    unsigned const held = components_held<N>(mesh, node);
    Matrix<S, N, 1> y = guess(node);
    if (held != 0) {
      auto const given = given_value(mesh, section, wall, node);
      for (int a = 0; a < N; ++a)
        if (held >> a & 1) y[a] = given[a];
    }
    level.push_back(y);
    momenta.push_back(momentum(node));
  }
  section.levels.push_back(std::move(level));
  try {
    return solve_level(density, mesh, section, momenta);
  } catch (...) {
    section.levels.pop_back();
    throw;
  }
}

/// A section that moves with these velocities through the first slab: its first two levels.
/// @throws NotAMesh  where a section is not one level, or velocities are not those of its nodes
template <class S, int n, int N>
DiscreteSection<S, n, N> moving_through_first_slab(SpaceTimeMesh<Base<S>, n> const& mesh,
                                                   DiscreteSection<S, n, N> section,
                                                   Level<S, N> const& velocities) {
  require_section(mesh, section);
  if (section.last() != 0) throw NotAMesh("first_step", "one level is given; levels", section.last() + 1, 1);
  if (velocities.size() != section.levels[0].size())
    throw NotAMesh("first_step", "each node has a velocity; velocities", double(velocities.size()),
                   double(section.levels[0].size()));
  if (mesh.levels() < 2) throw NotAMesh("first_step", "the mesh has a level to step to; level", 1, 0);
  Base<S> const h = mesh.time(1) - mesh.time(0);
  section.levels.push_back(section.levels[0]);
  for (std::size_t i = 0; i < velocities.size(); ++i) section.levels[1][i] += velocities[i] * h;
  return section;
}

/// The momentum \f$\partial L/\partial v_0\f$ at a node of such a section, lumped at the nodes.
template <class S, int n, int N, class L>
SumOfTerms<Matrix<S, N, 1>, Base<S>> momentum_of_velocity(L const& density,
                                                          SpaceTimeMesh<Base<S>, n> const& mesh,
                                                          DiscreteSection<S, n, N> const& moving,
                                                          Index node) {
  SumOfTerms<Matrix<S, N, 1>, Base<S>> p{Matrix<S, N, 1>::Zero()};
  mesh.for_cells_at(node, [&](GridIndex<n> const& cell, int b) {
    auto const j = discrete_jet(cell_of(mesh, moving, 0, cell), node_of_corner<n>(b, 0));
    examine(density, j);
    p.add(partial_v(density, j, 0) * mesh.geometry(cell).volume[b]);
  });
  return p;
}

}  // namespace detail

/// The next level of time: solves \ref discrete_euler_lagrange at the last level of a section for the values
/// at the level after it, and appends them.
///
/// \snippet ch10_outlook/try_it.cpp step_of_a_section
/// @param density  over jets and any scalar: energy per volume of space-time
/// @param mesh     of space-time; it has the lengths of the steps
/// @param section  at least two levels, and fewer than the mesh has
/// @param wall     where the nodes of fixed sides are, and those of sliding sides across them: a section, or
///                 `AtRest{}`
/// @throws NotConverged, Singular, NotFinite  where the step is too long for the discrete Lagrangian to be
///         regular; and what the density refuses at the new level, a cell turned inside out for instance. The
///         section stays as it was.
/// Accuracy: rounding of the equations, or of the values where these are large beside their change. Over the
/// rationals exact, for densities whose equations are linear in the next level.
template <class S, int n, int N, class L, class Wall = AtRest>
  requires DensityOver<L, S, n, N>
StepReport step(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N>& section,
                Wall const& wall = {}) {
  require_section(mesh, section);
  auto const guess = detail::guess_of_step(mesh, section);
  int const slab = section.last() - 1;
  auto const momentum = [&](Index node) {
    return detail::cartan_forms_of_slab(density, mesh, section, slab, node, 1);
  };
  return detail::append_level(density, mesh, section, wall, guess, momentum);
}

/// The first step from places and velocities: the values whose discrete momentum at the start of the first
/// slab is the momentum \f$\partial L/\partial v_0\f$ of the density, lumped at the nodes.
///
/// @param section     its first level, alone
/// @param velocities  at the nodes
/// @throws as \ref step
/// Accuracy: of second order, as the steps that follow.
template <class S, int n, int N, class L, class Wall = AtRest>
  requires DensityOver<L, S, n, N>
StepReport first_step(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                      DiscreteSection<S, n, N>& section, Level<S, N> const& velocities,
                      Wall const& wall = {}) {
  auto const moving = detail::moving_through_first_slab(mesh, section, velocities);
  auto const guess = [&](Index node) { return moving(1, node); };
  auto const momentum = [&](Index node) { return detail::momentum_of_velocity(density, mesh, moving, node); };
  return detail::append_level(density, mesh, section, wall, guess, momentum);
}

}  // namespace actio::media
