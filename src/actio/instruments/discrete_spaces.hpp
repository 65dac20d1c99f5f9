// The spaces that a discrete Lagrangian makes: pairs of configurations with its two-form, relative motions
// with its bracket.
//
// Sizes come from the second derivatives of the Lagrangian: a shift has the size that makes the action change
// as a turn by 1 does.
#pragma once

#include "actio/instruments/spaces.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/discrete_poisson.hpp"

namespace actio {

namespace detail {
/// Sizes of the changes of a configuration that go with a matrix of second derivatives: where a change in the
/// components of one unit, by the size, makes the action change by one unit. Turns, which have no unit, have
/// the size 1.
template <Group G, class M>
auto sizes_from_hessian(G const& group, M const& hessian) {
  using S = typename M::Scalar;
  auto const classes = unit_classes(group);
  AnyVector<S> entries = AnyVector<S>::Zero(static_cast<Index>(classes.has_length.size())),
               sizes = AnyVector<S>::Constant(group.dimension(), S(1));
  S turns(0);
  for (int a = 0; a < group.dimension(); ++a)
    for (int b = 0; b < group.dimension(); ++b) {
      if (classes.of[a] != classes.of[b]) continue;
      S const size = magnitude(S(hessian(a, b)));
      if (size > entries[classes.of[a]]) entries[classes.of[a]] = size;
      if (!classes.has_length[classes.of[a]] && size > turns) turns = size;
    }
  if constexpr (Real<S>) {
    using std::sqrt;
    for (int a = 0; a < group.dimension() && !exact_arithmetic<S>(); ++a)
      if (int const k = classes.of[a]; classes.has_length[k] && entries[k] > S(0))
        sizes[a] = sqrt(S((turns > S(0) ? turns : S(1)) / entries[k]));
  }
  return sizes;
}
}  // namespace detail

/// G x G with the two-form (3.5) of a discrete Lagrangian; coordinates \f$(\vartheta_0, \vartheta_1)\f$.
template <class L>
struct PairsOfConfigurations {
  L lagrangian;  ///< energy x time

  /// Of the space.
  template <Group G, Scalar S>
  static int dimension(PairArrow<G, S> const& x) { return 2 * x.first.group.dimension(); }
  /// A positive number for each coordinate, in its unit.
  template <Group G, Plain S>
  detail::AnyVector<S> sizes(PairArrow<G, S> const& x) const {
    auto const one =
        detail::sizes_from_hessian(x.first.group, mixed_derivative(lagrangian, x.first, x.second));
    return detail::stacked(one, one);
  }
  /// x moved infinitely little along a batch of coordinates, by the size of each.
  template <Group G, Scalar S>
  static PairArrow<G, Moved<S>> moved(PairArrow<G, S> const& x, detail::AnyVector<S> const& sizes,
                                      int first) {
    return {detail::moved_element(x.first, sizes, 0, first),
            detail::moved_element(x.second, sizes, x.first.group.dimension(), first)};
  }
  /// The coordinates of the infinitesimals.
  template <Group G, Scalar S>
  static auto change(PairArrow<G, S> const& x) {
    return detail::stacked(detail::change_of_element(x.first), detail::change_of_element(x.second));
  }
  /// The coordinates that lead from the first point to the second.
  template <Group G, Scalar S>
  static auto difference(PairArrow<G, S> const& x, PairArrow<G, S> const& y) {
    return detail::stacked(detail::difference_of_elements(x.first, y.first),
                           detail::difference_of_elements(x.second, y.second));
  }
  /// @throws Singular  where L is not regular
  template <Group G, Scalar S>
  detail::AnyMatrix<S> bivector(PairArrow<G, S> const& x) const {
    return discrete_bivector(lagrangian, x.first, x.second);
  }
  /// The matrix of the two-form.
  template <Group G, Scalar S>
  detail::AnyMatrix<S> two_form(PairArrow<G, S> const& x) const {
    return discrete_two_form_matrix(lagrangian, x.first, x.second);
  }
  /// Where the momentum of a symmetry is read: the configuration and the momentum at the end of the
  /// step.
  template <Group G, Scalar S>
  Costate<G, S> costate(PairArrow<G, S> const& x) const {
    return {x.second, D2(lagrangian, x.first, x.second)};
  }
};
/// The space of a discrete Lagrangian.
template <class L>
PairsOfConfigurations(L) -> PairsOfConfigurations<L>;

namespace detail {
/// What the two sides of a bracket on G have in common.
struct RelativeMotions {
  /// Of the space.
  template <Group G, Scalar S>
  static int dimension(Element<G, S> const& f) { return f.group.dimension(); }
  /// x moved infinitely little along a batch of coordinates, by the size of each.
  template <Group G, Scalar S>
  static auto moved(Element<G, S> const& f, AnyVector<S> const& sizes, int first) {
    return moved_element(f, sizes, 0, first);
  }
  /// The coordinates of the infinitesimals.
  template <Group G, Scalar S>
  static auto change(Element<G, S> const& f) { return change_of_element(f); }
  /// The coordinates that lead from the first point to the second.
  template <Group G, Scalar S>
  static AnyVector<S> difference(Element<G, S> const& f, Element<G, S> const& k) {
    return difference_of_elements(f, k);
  }
};
}  // namespace detail

/// G with the bracket (3.13) of a right-invariant discrete Lagrangian, \f$\ell(g_0g_1^{-1})\f$.
template <class F>
struct RelativeMotionsRight : detail::RelativeMotions {
  F l;  ///< energy x time
  /// @param reduced  the reduced discrete Lagrangian, energy x time
  explicit RelativeMotionsRight(F reduced) : l(std::move(reduced)) {}

  /// A positive number for each coordinate, in its unit.
  template <Group G, Plain S>
  detail::AnyVector<S> sizes(Element<G, S> const& f) const {
    return detail::sizes_from_hessian(f.group, right_second_differential(l, f));
  }
  /// @throws Singular  where l is not regular
  template <Group G, Scalar S>
  detail::AnyMatrix<S> bivector(Element<G, S> const& f) const { return reduced_bivector_right(l, f); }
};
/// G with the bracket of a left-invariant discrete Lagrangian, \f$\ell(g_1^{-1}g_0)\f$.
template <class F>
struct RelativeMotionsLeft : detail::RelativeMotions {
  F l;  ///< energy x time
  /// @param reduced  the reduced discrete Lagrangian, energy x time
  explicit RelativeMotionsLeft(F reduced) : l(std::move(reduced)) {}

  /// A positive number for each coordinate, in its unit.
  template <Group G, Plain S>
  detail::AnyVector<S> sizes(Element<G, S> const& f) const {
    return detail::sizes_from_hessian(f.group, right_second_differential(l, f));
  }
  /// @throws Singular  where l is not regular
  template <Group G, Scalar S>
  detail::AnyMatrix<S> bivector(Element<G, S> const& f) const { return reduced_bivector_left(l, f); }
};

}  // namespace actio
