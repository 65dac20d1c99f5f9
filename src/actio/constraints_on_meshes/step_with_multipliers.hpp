// A step with multipliers: the discrete field equations of an augmented density solved for the multipliers of
// the last level and the values of the next one (chapters 7, 8 and 10 of the thesis).
//
// The forces of the multipliers act at the last level along the slopes of the constraint there, and the
// constraint holds at the next level: for a medium the scheme of Ryckaert, Ciccotti and Berendsen (SHAKE),
// for any density of first jets. Newton's method with exact derivatives and elimination of full matrices: for
// small meshes.
#pragma once

#include "actio/constraints_on_meshes/extended_field_equations.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"

namespace actio::media {

/// Constraints that have no common solution: the one that should follow from the others does not.
struct InconsistentConstraints : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// The cell whose multipliers are kept as they are and whose constraint follows from the others, or none.
/// Closed walls give the whole volume away: there the multiplier is free up to a constant (section 7.2).
struct Pinned {
  Index cell = -1;  ///< its number, in the order of the mesh; -1 where there is none
};

namespace detail {

/// The equations of a step. The section has the next level already, and a guess in it.
template <class L, class Phi, class S, int n, int N>
class EquationsOfStep {
 public:
  static constexpr int k = Phi::components;
  using Section = DiscreteExtendedSection<S, n, N, k>;
  using Column = Matrix<S, Dynamic, 1>;

  /// @param held     of each node, the components that are given: bit a for component a
  /// @param momenta  at the nodes of the first level; empty where there is a slab before the last level
  EquationsOfStep(AugmentedDensity<L, Phi> const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                  Section& section, std::vector<unsigned> const& held,
                  std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> momenta, Pinned pinned)
      : density_(density), mesh_(mesh), section_(section), momenta_(std::move(momenta)), pinned_(pinned) {
    for (unsigned const bits : held)
      for (int a = 0; a < N; ++a) unknown_.push_back(bits >> a & 1 ? -1 : values_++);
    mesh_.for_cells([&](GridIndex<n> const& cell) { cells_.push_back(cell); });
  }

  /// How many values are unknown.
  int values() const { return values_; }

  /// The equations at the nodes, then the constraints of the cells.
  /// @param worst  becomes the largest of them, over the terms that it is made from
  Column residual(Base<S>& worst) const {
    Column r = Column::Zero(size());
    std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> E = momenta_;
    if (E.empty()) E.assign(mesh_.node_count(), {Matrix<S, N, 1>::Zero()});
    worst = Base<S>(0);
    auto const relative = [&](Base<S> const& found, Base<S> const& terms) {
      if (terms > Base<S>(0)) worst = std::max(worst, Base<S>(found / terms));
    };
    for (std::size_t K = 0; K < cells_.size(); ++K) {
      if (momenta_.empty()) add_forms(E, now() - 1, cells_[K], 1);
      add_forms(E, now(), cells_[K], 0);
      auto const C = constraint_at_next(cells_[K]);
      relative(magnitude(C.sum), C.terms);
      if (Index(K) != pinned_.cell) r.template segment<k>(row_of(K)) = C.sum;
    }
    for (std::size_t node = 0; node < E.size(); ++node)
      for (int a = 0; a < N; ++a)
        if (int const row = unknown_[node * N + a]; row >= 0) {
          r[row] = E[node].sum[a];
          relative(magnitude(E[node].sum[a]), E[node].terms);
        }
    return r;
  }

  /// Their derivative by the values of the next level and the multipliers of the last one.
  Matrix<S, Dynamic, Dynamic> slope() const {
    Matrix<S, Dynamic, Dynamic> A = Matrix<S, Dynamic, Dynamic>::Zero(size(), size());
    Base<S> const before = momenta_.empty() ? mesh_.time(now()) - mesh_.time(now() - 1) : Base<S>(0);
    Base<S> const half = (before + mesh_.time(now() + 1) - mesh_.time(now())) / Base<S>(2);
    for (std::size_t K = 0; K < cells_.size(); ++K) {
      auto const here = cell_of(mesh_, section_, now(), cells_[K]);
      auto const below = configuration<N>(here);
      bool const free = Index(K) != pinned_.cell;
      for (int b = 0; b < here.corners; ++b) {
        // [step_with_multipliers]
        for (int c = 0; c < here.corners; ++c)
          add(A, node_row(cells_[K], b), node_row(cells_[K], c),
              discrete_mixed_derivative(density_, here, b, c + here.corners));
        if (free) {
          auto const reaction = constraint_slope(density_.constraint, below, 0, b);
          auto const at_next = constraint_slope(density_.constraint, below, 1, b);
          // [step_with_multipliers]
          for (int a = 0; a < N; ++a)
            if (int const row = unknown_[node_row(cells_[K], b) + a]; row >= 0)
              for (int i = 0; i < k; ++i) {
                A(row, row_of(K) + i) += reaction(i, a) * half;
                A(row_of(K) + i, row) += at_next(i, a);
              }
        }
      }
      for (int i = 0; !free && i < k; ++i) A(row_of(K) + i, row_of(K) + i) = S(1);
    }
    return A;
  }

  /// Takes a correction off the unknowns.
  void correct(Column const& change) {
    for (std::size_t i = 0; i < unknown_.size(); ++i)
      if (unknown_[i] >= 0) section_.phi(now() + 1, Index(i) / N)[i % N] -= change[unknown_[i]];
    for (std::size_t K = 0; K < cells_.size(); ++K)
      section_.lambda[now()][K] -= Matrix<S, k, 1>(change.template segment<k>(row_of(K)));
  }

  /// Refuses a new level at which density or constraint are not defined, or where the constraint of the
  /// pinned cell does not follow from the others.
  void examine_next() const {
    Base<S> terms(0);
    for (auto const& cell : cells_) {
      auto const here = cell_of(mesh_, section_, now(), cell);
      for (int l = 0; l < here.nodes; ++l) examine(density_, discrete_jet(here, l));
      terms += constraint_at_next(cell).terms;
    }
    if (pinned_.cell < 0) return;
    // The others hold to a few roundings of their terms, and those add up.
    auto const found = magnitude(constraint_at_next(cells_[pinned_.cell]).sum);
    Base<S> const bound = Base<S>(64) * epsilon<S>() * terms;
    if (!(found <= bound))
      throw InconsistentConstraints("step, the cell with the pinned multiplier",
                                    "the constraints of the others imply its own, which those of bent "
                                    "hexahedra by their corners do not; what is missing",
                                    to_double(found), to_double(bound));
  }

 private:
  AugmentedDensity<L, Phi> const& density_;
  SpaceTimeMesh<Base<S>, n> const& mesh_;
  Section& section_;
  std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>> momenta_;
  Pinned pinned_;
  std::vector<int> unknown_;  // of each component of a value: its number among the unknowns, or -1
  std::vector<GridIndex<n>> cells_;
  int values_ = 0;

  int now() const { return section_.last() - 1; }
  int size() const { return values_ + k * int(cells_.size()); }
  int row_of(std::size_t K) const { return values_ + k * int(K); }
  std::size_t node_row(GridIndex<n> const& cell, int b) const {
    return static_cast<std::size_t>(mesh_.node(cell, b)) * N;
  }
  void add_forms(std::vector<SumOfTerms<Matrix<S, N, 1>, Base<S>>>& E, int slab, GridIndex<n> const& cell,
                 int level) const {
    auto const here = cell_of(mesh_, section_, slab, cell);
    for (int b = 0; b < here.corners; ++b) {
      auto const Theta = cartan_form_at_node(density_, here, node_of_corner<n>(b, level));
      E[mesh_.node(cell, b)].add(Matrix<S, N, 1>(Theta.template head<N>()));
    }
  }
  /// The constraint, and what the rounding of the values makes of it: the size of the slopes times the
  /// values.
  SumOfTerms<Matrix<S, k, 1>, Base<S>> constraint_at_next(GridIndex<n> const& cell) const {
    auto const below = configuration<N>(cell_of(mesh_, section_, now(), cell));
    SumOfTerms<Matrix<S, k, 1>, Base<S>> C{constraint_of_cell(density_.constraint, below, 1)};
    for (int b = 0; b < below.corners; ++b)
      C.terms += magnitude(constraint_slope(density_.constraint, below, 1, b)) *
                 magnitude(below.y.col(node_of_corner<n>(b, 1)));
    return C;
  }
  template <int M>
  void add(Matrix<S, Dynamic, Dynamic>& A, std::size_t row, std::size_t column,
           Matrix<S, M, M> const& block) const {
    for (int a = 0; a < N; ++a)
      for (int c = 0; c < N; ++c)
        if (unknown_[row + a] >= 0 && unknown_[column + c] >= 0)
          A(unknown_[row + a], unknown_[column + c]) += block(a, c);
  }
};

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
    mesh.for_cells([&](GridIndex<n> const& cell) {
      require_spatial(density.constraint,
                      discrete_jet(configuration<N>(cell_of(mesh, section, section.last() - 1, cell)), 0));
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
