// The dual of the algebroid of several copies of a group, as a space that maps can be judged on.
//
// It is T*M/K with M = K^n. Its points are `DualPoint`s of the groupoid of diagonal_quotient.hpp; its bracket
// is not typed in, but computed from the multiplication of the groupoid (algebroid.hpp).
#pragma once

#include "actio/groupoid/algebroid.hpp"
#include "actio/groupoid/diagonal_quotient.hpp"
#include "actio/instruments/spaces.hpp"

namespace actio {

/// The same copies over a larger scalar.
template <Scalar T, Group K, int n, Scalar S>
SeenFromFirst<K, n, T> over(SeenFromFirst<K, n, S> const& x) {
  return DiagonalQuotient<K, n>::source(
      DiagonalQuotient<K, n>::template over<T>(DiagonalQuotient<K, n>{x.others[0].group}.unit(x)));
}
/// The copies before they were moved.
template <Group K, int n, Scalar S>
auto value_of(SeenFromFirst<K, n, S> const& x) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return SeenFromFirst<K, n, decltype(value_of(S()))>{{value_of(x.others[i])...}};
  }(std::make_index_sequence<n - 1>());
}
/// The same covector over a larger scalar.
template <Scalar T, Group K, int n, Scalar S>
DualPoint<DiagonalQuotient<K, n>, T> over(DualPoint<DiagonalQuotient<K, n>, S> const& p) {
  return {over<T>(p.base), p.components.template cast<T>()};
}
/// The covector before it was moved.
template <Group K, int n, Scalar S>
auto value_of(DualPoint<DiagonalQuotient<K, n>, S> const& p) {
  return DualPoint<DiagonalQuotient<K, n>, decltype(value_of(S()))>{value_of(p.base), value_of(p.components)};
}
/// @throws NotFinite, OutsideDomain  where a copy or a component is refused
template <Group K, int n, Scalar S>
void require_point(DualPoint<DiagonalQuotient<K, n>, S> const& p, char const* where) {
  for (auto const& x : p.base.others) require_point(x, where);
  detail::require_coordinates(p.components, n * p.base.others[0].group.dimension(), where);
}

/// \f$T^*M/K\f$, \f$M = K^n\f$, with the bracket of \ref dual_bivector ; coordinates \f$(\delta x_ix_i^{-1},
/// \delta p)\f$.
///
/// A shift has the size that makes, with the momentum of shifts, what a turn by 1 makes with that of turns;
/// sizes of momenta are the largest among the copies.
template <Group K, int n>
struct DualOfAlgebroid {
  using Gamma = DiagonalQuotient<K, n>;  ///< the groupoid
  [[no_unique_address]] K group;

  /// Of the space.
  template <Scalar S>
  int dimension(DualPoint<Gamma, S> const&) const { return (2 * n - 1) * group.dimension(); }
  /// A positive number for each coordinate, in its unit.
  template <Plain S>
  detail::AnyVector<S> sizes(DualPoint<Gamma, S> const& p) const {
    int const d = group.dimension();
    detail::AnyVector<S> one = detail::AnyVector<S>::Zero(d), all((2 * n - 1) * d);
    for (int i = 0; i < n; ++i) {
      auto const of_copy = sizes_by_unit(Momentum<K, S>{group, p.components.segment(i * d, d)});
      for (int a = 0; a < d; ++a)
        if (of_copy[a] > one[a]) one[a] = of_copy[a];
    }
    Costate<K, S> const like{identity<S>(group), Momentum<K, S>{group, one}};
    auto const both = CotangentBundle::sizes(like);
    for (int i = 0; i < n - 1; ++i) all.segment(i * d, d) = both.head(d);
    for (int i = n - 1; i < 2 * n - 1; ++i) all.segment(i * d, d) = both.tail(d);
    return all;
  }
  /// x moved infinitely little along a batch of coordinates, by the size of each.
  template <Scalar S>
  DualPoint<Gamma, Moved<S>> moved(DualPoint<Gamma, S> const& p, detail::AnyVector<S> const& sizes,
                                   int first) const {
    auto all = over<Moved<S>>(p);
    int const d = group.dimension();
    for (int i = 0; i < n - 1; ++i) {
      all.base.others[i] = detail::moved_element(p.base.others[i], sizes, i * d, first);
    }
    detail::seed(all.components, sizes, (n - 1) * d, first);
    return all;
  }
  /// The coordinates of the infinitesimals.
  template <Scalar S>
  detail::AnyVector<Moved<S>> change(DualPoint<Gamma, Moved<S>> const& p) const {
    int const d = group.dimension();
    detail::AnyVector<Moved<S>> all((2 * n - 1) * d);
    for (int i = 0; i < n - 1; ++i) all.segment(i * d, d) = detail::change_of_element(p.base.others[i]);
    for (Index a = 0; a < p.components.size(); ++a) all[(n - 1) * d + a] = p.components[a];
    return all;
  }
  /// The matrix of the bracket.
  template <Scalar S>
  detail::AnyMatrix<S> bivector(DualPoint<Gamma, S> const& p) const {
    Gamma const gamma{group};
    return dual_bivector(gamma, gamma.unit(p.base), p.components);
  }
};

}  // namespace actio
