// The equations of a step with multipliers, and their derivative (chapters 7, 8 and 10 of the thesis).
#pragma once

#include "actio/constraints_on_meshes/cell_volumes.hpp"
#include "actio/constraints_on_meshes/extended_field_equations.hpp"

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
      auto const below = cell_of(mesh_, section_.phi, now(), cells_[K]);
      bool const free = Index(K) != pinned_.cell;
      for (int b = 0; b < below.corners; ++b) {
        // [step_with_multipliers]
        for (int c = 0; c < below.corners; ++c)
          add(A, node_row(cells_[K], b), node_row(cells_[K], c),
              discrete_mixed_derivative(density_.density, below, b, c + below.corners));
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
                                    "the constraints of the others imply its own, which needs CellVolumes "
                                    "for hexahedra; what is missing",
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
    for (int b = 0; b < here.corners; ++b)
      E[mesh_.node(cell, b)].add(cartan_form_with_reaction(density_, here, node_of_corner<n>(b, level)));
  }
  /// The constraint, and what the rounding of the values makes of it: the size of the slopes times the
  /// values.
  SumOfTerms<Matrix<S, k, 1>, Base<S>> constraint_at_next(GridIndex<n> const& cell) const {
    auto const below = cell_of(mesh_, section_.phi, now(), cell);
    SumOfTerms<Matrix<S, k, 1>, Base<S>> C{constraint_of_cell(density_.constraint, below, 1)};
    for (int b = 0; b < below.corners; ++b)
      C.terms += magnitude(constraint_slope(density_.constraint, below, 1, b)) *
                 magnitude(below.y.col(node_of_corner<n>(b, 1)));
    return C;
  }
  void add(Matrix<S, Dynamic, Dynamic>& A, std::size_t row, std::size_t column,
           Matrix<S, N, N> const& block) const {
    for (int a = 0; a < N; ++a)
      for (int c = 0; c < N; ++c)
        if (unknown_[row + a] >= 0 && unknown_[column + c] >= 0)
          A(unknown_[row + a], unknown_[column + c]) += block(a, c);
  }
};

}  // namespace detail
}  // namespace actio::media
