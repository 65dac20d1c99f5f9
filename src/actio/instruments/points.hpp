// Points of the spaces that maps are judged on, and what they are at a smaller or a larger scalar.
//
// A point is a momentum (of the dual of an algebra), a costate (of T*G), a pair of configurations (of G x G)
// or a configuration (of G). Each is refused where it is no point: with a number missing, with a NaN.
#pragma once

#include <tuple>

#include "actio/groupoid/pair_groupoid.hpp"
#include "actio/variational/hamilton.hpp"

namespace actio {

/// The same pair over a larger scalar, where it is a constant.
template <Scalar T, Group G, Scalar S>
PairArrow<G, T> over(PairArrow<G, S> const& x) { return {over<T>(x.first), over<T>(x.second)}; }

// The value of a dual number, or of what is made of them: one layer of infinitesimals is dropped.

/// A plain number is its own value.
template <Plain S>
S value_of(S const& x) { return x; }
/// The value of a dual number.
template <class S, int N>
S value_of(Dual<S, N> const& x) { return x.value; }
/// The values of the entries.
template <MatrixLike Derived>
auto value_of(Derived const& m) {
  using S = decltype(value_of(m(0, 0)));
  Matrix<S, Derived::RowsAtCompileTime, Derived::ColsAtCompileTime> values =
      m.unaryExpr([](auto const& x) -> S { return value_of(x); });
  return values;
}
/// The element where it was before it was moved.
template <Group G, Scalar S>
auto value_of(Element<G, S> const& g) {
  return Element<G, decltype(value_of(S()))>{g.group, value_of(g.value)};
}
/// The velocity before it was moved.
template <Group G, Scalar S>
auto value_of(Velocity<G, S> const& xi) {
  return Velocity<G, decltype(value_of(S()))>{xi.group, value_of(xi.coordinates)};
}
/// The momentum before it was moved.
template <Group G, Scalar S>
auto value_of(Momentum<G, S> const& mu) {
  return Momentum<G, decltype(value_of(S()))>{mu.group, value_of(mu.components)};
}
/// The costate before it was moved.
template <Group G, Scalar S>
auto value_of(Costate<G, S> const& p) {
  return Costate<G, decltype(value_of(S()))>{value_of(p.configuration), value_of(p.momentum)};
}
/// The pair before it was moved.
template <Group G, Scalar S>
auto value_of(PairArrow<G, S> const& x) {
  return PairArrow<G, decltype(value_of(S()))>{value_of(x.first), value_of(x.second)};
}
/// Each by itself.
template <class... T>
auto value_of(std::tuple<T...> const& all) {
  return std::apply([](auto const&... x) { return std::make_tuple(value_of(x)...); }, all);
}

namespace detail {
/// Refuses coordinates that are no numbers (infinitesimals included), or too few or too many.
template <class V>
void require_coordinates(V const& v, int dimension, char const* where) {
  if (v.size() != dimension)
    throw OutsideDomain(where, "as many components as the group has dimensions are needed; components",
                        static_cast<double>(v.size()), dimension);
  for (Index i = 0; i < v.size(); ++i)
    if (!is_finite(v[i])) throw NotFinite(where);
}
template <class M>
void require_numbers(M const& m, char const* where) {
  for (Index j = 0; j < m.cols(); ++j)
    for (Index i = 0; i < m.rows(); ++i)
      if (!is_finite(m(i, j))) throw NotFinite(where);
}
}  // namespace detail

// Refusals. An infinitesimal part that is no number is refused as well: there the map has no derivative.

/// @throws NotFinite, OutsideDomain  where a component is no number, or the number of them is wrong
template <Group G, Scalar S>
void require_point(Momentum<G, S> const& mu, char const* where) {
  detail::require_coordinates(mu.components, mu.group.dimension(), where);
}
/// @throws NotFinite, OutsideDomain  where an entry is no number, or the matrix has another size
template <Group G, Scalar S>
void require_point(Element<G, S> const& g, char const* where) {
  if constexpr (MatrixGroup<G>)
    if (g.value.rows() != g.group.matrix_size() || g.value.cols() != g.group.matrix_size())
      throw OutsideDomain(where, "a matrix of the size of the group's is needed; rows",
                          static_cast<double>(g.value.rows()), g.group.matrix_size());
  detail::require_numbers(g.value, where);
}
/// @throws NotFinite, OutsideDomain  where the configuration or the momentum is refused
template <Group G, Scalar S>
void require_point(Costate<G, S> const& p, char const* where) {
  require_point(p.configuration, where);
  require_point(p.momentum, where);
}
/// @throws NotFinite, OutsideDomain  where one of the configurations is refused
template <Group G, Scalar S>
void require_point(PairArrow<G, S> const& x, char const* where) {
  require_point(x.first, where);
  require_point(x.second, where);
}

}  // namespace actio
