// The groupoid (M x M)/K of n copies of a group, M = K^n, which K moves all together from the left: what n
// bodies do in a step, in the frame of one of them.
//
// The copies are g_1, ..., g_n. A point of the base is where the others are in the frame of the first, x_i =
// g_1^-1 g_i for i > 1; an arrow is (x, y, k), from x to y, with the motion k = g_1^-1 g_1' of the first. For
// n = 1 it is the group. Unlike that of gauge_groupoid.hpp its base is no vector space, but K^(n-1).
#pragma once

#include <array>

#include "actio/groupoid/groupoid.hpp"
#include "actio/variational/curves.hpp"

namespace actio {

/// Relative configurations: of copies 2 to n in the frame of the first, \f$x_i = g_1^{-1}g_i\f$.
template <Group K, int n, Scalar S>
struct SeenFromFirst {
  using Scalar = S;
  std::array<Element<K, S>, n - 1> others;  ///< \f$x_2, \dots, x_n\f$
};
/// From x to y, while the first copy moves by k.
template <Group K, int n, Scalar S>
struct QuotientArrow {
  using Scalar = S;
  std::array<Element<K, S>, n - 1> from;  ///< x
  std::array<Element<K, S>, n - 1> to;    ///< y
  Element<K, S> element;                  ///< k

  /// \f$g_i^{-1}g_i' = x_i^{-1}ky_i\f$: how the i-th copy moves in its own frame; i = 0 is the first.
  Element<K, S> motion(int i) const { return i == 0 ? element : inverse(from[i - 1]) * element * to[i - 1]; }
};

/// \f$(K^n\times K^n)/K\f$ over \f$K^{n-1}\f$, \f$n \ge 2\f$:
/// \f$(x, y, k)(y, z, l) = (x, z, kl)\f$.
///
/// A vector of the algebroid is \f$(g_1^{-1}\delta g_1, \dots, g_n^{-1}\delta g_n)\f$, the velocity of each
/// copy in its own frame.
template <Group K, int n>
struct DiagonalQuotient {
  static_assert(n >= 2, "a single copy is GroupAsGroupoid");
  static constexpr int dim = K::dim == Dynamic ? Dynamic : n * K::dim;
  template <class S>
  using ArrowOver = QuotientArrow<K, n, S>;
  template <class S>
  using PointOver = SeenFromFirst<K, n, S>;
  template <class S>
  using Column = Matrix<S, Dynamic, 1>;
  [[no_unique_address]] K group;

  int dimension() const { return n * group.dimension(); }
  int base_dimension() const { return (n - 1) * group.dimension(); }

  template <class S>
  static SeenFromFirst<K, n, S> source(QuotientArrow<K, n, S> const& g) { return {g.from}; }
  template <class S>
  static SeenFromFirst<K, n, S> target(QuotientArrow<K, n, S> const& g) { return {g.to}; }
  template <class S>
  static QuotientArrow<K, n, S> compose(QuotientArrow<K, n, S> const& g, QuotientArrow<K, n, S> const& h) {
    // [diagonal_quotient_product]
    return {g.from, h.to, g.element * h.element};
    // [diagonal_quotient_product]
  }
  template <class S>
  static QuotientArrow<K, n, S> inverse(QuotientArrow<K, n, S> const& g) {
    return {g.to, g.from, actio::inverse(g.element)};
  }
  template <class S>
  QuotientArrow<K, n, S> unit(SeenFromFirst<K, n, S> const& x) const {
    return {x.others, x.others, identity<S>(group)};
  }
  /// The arrow from x along which each copy makes its own motion, \f$g_i\to g_if_i\f$:
  /// \f$(x, f_1^{-1}x_if_i, f_1)\f$.
  template <class S>
  static QuotientArrow<K, n, S> moving(SeenFromFirst<K, n, S> const& x,
                                       std::array<Element<K, S>, n> const& f) {
    // [diagonal_quotient_arrow]
    QuotientArrow<K, n, S> g{x.others, x.others, f[0]};
    for (int i = 1; i < n; ++i) g.to[i - 1] = actio::inverse(f[0]) * x.others[i - 1] * f[i];
    // [diagonal_quotient_arrow]
    return g;
  }
  template <class S>
  QuotientArrow<K, n, S> near_unit(SeenFromFirst<K, n, S> const& x, Matrix<S, dim, 1> const& v) const {
    return moving(x, each_copy<S>([&](int i) {
                    return Element<K, S>{group, primitive::near_identity(group, part<S>(v, i))};
                  }));
  }
  template <Real S>
  QuotientArrow<K, n, S> leave(SeenFromFirst<K, n, S> const& x, Matrix<S, dim, 1> const& v) const {
    return moving(x, each_copy<S>([&](int i) { return exp(Velocity<K, S>{group, part<S>(v, i)}); }));
  }
  template <class T, class S>
  static QuotientArrow<K, n, T> over(QuotientArrow<K, n, S> const& g) {
    return {over<T>(g.from), over<T>(g.to), actio::over<T>(g.element)};
  }

  /// The arrow of a pair of configurations \f$(g_1,\dots,g_n)\f$, \f$(g_1',\dots,g_n')\f$.
  template <class S>
  static QuotientArrow<K, n, S> reduced(std::array<Element<K, S>, n> const& g,
                                        std::array<Element<K, S>, n> const& later) {
    return {seen_from_first(g).others, seen_from_first(later).others, actio::inverse(g[0]) * later[0]};
  }
  /// The point of a configuration.
  template <class S>
  static SeenFromFirst<K, n, S> seen_from_first(std::array<Element<K, S>, n> const& g) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return SeenFromFirst<K, n, S>{{actio::inverse(g[0]) * g[i + 1]...}};
    }(std::make_index_sequence<n - 1>());
  }

  template <class S>
  static Column<S> entries(QuotientArrow<K, n, S> const& g) {
    Index const size = g.element.value.size();
    Column<S> all((2 * n - 1) * size);
    auto const put = [&](int at, Element<K, S> const& of) {
      for (Index i = 0; i < size; ++i) all[at * size + i] = of.value(i);
    };
    for (int i = 0; i < n - 1; ++i) put(i, g.from[i]), put(n - 1 + i, g.to[i]);
    put(2 * n - 2, g.element);
    return all;
  }
  template <class S>
  QuotientArrow<K, n, S> moved(QuotientArrow<K, n, S> const& g, Column<S> const& w) const {
    auto const near = [&](int i, Element<K, S> const& of) {
      return Element<K, S>{group, primitive::near_identity(group, part<S>(w, i))} * of;
    };
    QuotientArrow<K, n, S> all = g;
    for (int i = 0; i < n - 1; ++i) all.from[i] = near(i, g.from[i]), all.to[i] = near(n - 1 + i, g.to[i]);
    all.element = near(2 * n - 2, g.element);
    return all;
  }
  template <class S>
  Column<S> base_rate(SeenFromFirst<K, n, Dual<S>> const& x) const {
    Column<S> rates(base_dimension());
    for (int i = 0; i < n - 1; ++i)
      rates.segment(i * group.dimension(), group.dimension()) = rate_right(x.others[i]).coordinates;
    return rates;
  }

 private:
  template <class S, class V>
  Coordinates<K, S> part(V const& v, int i) const {
    return v.segment(i * group.dimension(), group.dimension());
  }
  template <class S, class F>
  static std::array<Element<K, S>, n> each_copy(F const& f) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return std::array<Element<K, S>, n>{f(static_cast<int>(i))...};
    }(std::make_index_sequence<n>());
  }
  template <class T, class S>
  static auto over(std::array<Element<K, S>, n - 1> const& x) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return std::array<Element<K, T>, n - 1>{actio::over<T>(x[i])...};
    }(std::make_index_sequence<n - 1>());
  }
};

}  // namespace actio
