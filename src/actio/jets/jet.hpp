// Sections and their jets (section 6.1 of the thesis).
//
// Space-time X = B x R has coordinates x^0 = t and x^1, ..., x^n; the fibre M has y^1, ..., y^N. A section is
// a callable, written once for every scalar: it takes a point of X and returns one of M. Its first jet
// at x is (x, phi(x), d_mu phi^a), its second jet has d_mu d_nu phi^a as well.
#pragma once

#include <concepts>
#include <type_traits>

#include "actio/numbers/derivative.hpp"
#include "actio/numbers/second_order.hpp"
#include "actio/numbers/square_root.hpp"

namespace actio {

/// A point of space-time, (t, x^1, ..., x^n): `Event<double, 2>(t, x1, x2)`, a column of n + 1 numbers.
template <class S, int n>
using Event = Matrix<S, n + 1, 1>;

/// A point of the first jet bundle \f$J^1Y\f$ over an n-dimensional body in an N-dimensional space.
template <class S, int n, int N>
struct Jet {
  using Scalar = S;
  static constexpr int base = n;                             ///< dimension of the body B
  static constexpr int fibre = N;                            ///< dimension of the space M
  static constexpr int dimension = n + 1 + N + N * (n + 1);  ///< of the jet bundle

  Event<S, n> x;      ///< point of space-time, t first
  Matrix<S, N, 1> y;  ///< point of space \f$y^a\f$
  /// \f$v^a{}_\mu\f$: column 0 is the velocity, the others the deformation gradient
  Matrix<S, N, n + 1> v;

  /// \f$v^a{}_0\f$.
  Matrix<S, N, 1> velocity() const { return v.col(0); }
  /// The deformation gradient \f$F^a{}_i = v^a{}_i\f$.
  Matrix<S, N, n> gradient() const { return v.template rightCols<n>(); }
  /// The point of the body, \f$x^1,\dots,x^n\f$.
  Matrix<S, n, 1> particle() const { return x.template tail<n>(); }

  /// The same jet over a scalar that extends S.
  template <class T>
  Jet<T, n, N> cast() const { return {x.template cast<T>(), y.template cast<T>(), v.template cast<T>()}; }
};

/// A point of the second jets \f$Y''\f$: a first jet and \f$w^a{}_{\mu\nu} = w^a{}_{\nu\mu}\f$.
template <class S, int n, int N>
struct SecondJet : Jet<S, n, N> {
  /// `w[mu]` holds \f$w^a{}_{\mu\nu}\f$ with a row for each a and a column for each nu.
  std::array<Matrix<S, N, n + 1>, n + 1> w;

  /// The acceleration \f$w^a{}_{00}\f$.
  Matrix<S, N, 1> acceleration() const { return w[0].col(0); }
};

/// What may be called a section over points of space-time with n space dimensions.
template <class Phi, class S, int n>
concept SectionOver = requires(Phi const& phi, Event<S, n> const& x) {
  { phi(x)[0] } -> std::convertible_to<S>;
};

namespace detail {
/// n of a point with n + 1 coordinates.
template <class X>
inline constexpr int space_dimension = X::RowsAtCompileTime - 1;
template <class Phi, class S, int n>
inline constexpr int fibre_dimension = std::remove_cvref_t<decltype(std::declval<Phi const&>()(
    std::declval<Event<S, n> const&>()))>::RowsAtCompileTime;
}  // namespace detail

/// The first jet \f$j^1\phi(x) = (x^\mu, \phi^a(x), \partial_\mu\phi^a(x))\f$ of a section.
///
/// \snippet fields.cpp first_jet
///
/// \implements{claim_6_1_jet_bundle}
/// @param phi  section: a callable from points of space-time to points of space, over any scalar
/// @param x    point of space-time, (t, x^1, ..., x^n)
/// Accuracy: exact but for the rounding of phi itself.
template <class S, int rows, class Phi>
  requires SectionOver<Phi, S, rows - 1>
auto first_jet(Phi const& phi, Matrix<S, rows, 1> const& x) {
  constexpr int n = rows - 1, N = detail::fibre_dimension<Phi, S, n>;
  static_assert(N > 0,
                "a section returns a point with as many coordinates as the fibre has "
                "dimensions, known when it is compiled");
  auto const d = derivative(phi, x);
  // [claim_6_1_jet_bundle]
  return Jet<S, n, N>{x, d.value, d.matrix};
  // [claim_6_1_jet_bundle]
}

/// The second jet \f$j^2\phi(x)\f$ of a section: \ref first_jet and \f$\partial_\mu\partial_\nu\phi^a(x)\f$,
/// from one evaluation on truncated polynomials.
template <class S, int rows, class Phi>
  requires SectionOver<Phi, S, rows - 1>
auto second_jet(Phi const& phi, Matrix<S, rows, 1> const& x) {
  constexpr int n = rows - 1, N = detail::fibre_dimension<Phi, S, n>;
  static_assert(N > 0,
                "a section returns a point with as many coordinates as the fibre has "
                "dimensions, known when it is compiled");
  using D = SecondOrder<S, rows>;
  Event<D, n> moved;
  for (int mu = 0; mu <= n; ++mu) moved[mu] = D::variable(x[mu], mu);
  Matrix<D, N, 1> const place = phi(moved);
  SecondJet<S, n, N> jet;
  jet.x = x;
  for (int a = 0; a < N; ++a) {
    jet.y[a] = place[a].value;
    for (int mu = 0; mu <= n; ++mu) {
      jet.v(a, mu) = place[a].first[mu];
      for (int nu = 0; nu <= n; ++nu) jet.w[mu](a, nu) = place[a].second[D::at(mu, nu)];
    }
  }
  return jet;
}

/// The first jets of a section on the way from x along \f$x^\mu\f$, to first order:
/// \f$(x + \epsilon\,\partial_\mu,\ y + \epsilon\,v_\mu,\ v + \epsilon\,w_\mu)\f$.
///
/// What a function of jets is along a section, differentiated in \f$x^\mu\f$, is its value here:
/// \ref total_derivative.
template <class S, int n, int N>
Jet<Dual<S>, n, N> along(SecondJet<S, n, N> const& j, int mu) {
  // [eq_6_9]
  return {moved_along(j.x, Event<S, n>::Unit(mu)), moved_along(j.y, Matrix<S, N, 1>(j.v.col(mu))),
          moved_along(j.v, j.w[mu])};
  // [eq_6_9]
}

/// A function of first jets along a section: its value and its \ref total_derivative in \f$x^\mu\f$, from one
/// evaluation.
template <class F, class S, int n, int N>
auto along_section(int mu, F const& f, SecondJet<S, n, N> const& j) {
  return detail::value_and_rate<Dual<S>>(f(along(j, mu)));
}

/// The total derivative \f$D_\mu f\f$ of a function of first jets along a section:
/// \f$\frac{\partial}{\partial x^\mu}f(j^1\phi(x))\f$.
/// @param f  a callable on first jets, over any scalar; its values are numbers, vectors or matrices
/// @param j  second jet of the section
/// @return   a number, a vector or a matrix, as f
/// Accuracy: exact but for the rounding of f.
template <class F, class S, int n, int N>
auto total_derivative(int mu, F const& f, SecondJet<S, n, N> const& j) {
  return along_section(mu, f, j).rate;
}

/// The coordinates of a jet in one column: \f$x^\mu\f$, then \f$y^a\f$, then \f$v^a{}_\mu\f$ with \f$\mu\f$
/// slowest. Forms on the jet bundle take these.
template <class S, int n, int N>
Matrix<S, Jet<S, n, N>::dimension, 1> coordinates(Jet<S, n, N> const& j) {
  Matrix<S, Jet<S, n, N>::dimension, 1> c;
  c.template head<n + 1>() = j.x;
  c.template segment<N>(n + 1) = j.y;
  for (int mu = 0; mu <= n; ++mu) c.template segment<N>(n + 1 + N + N * mu) = j.v.col(mu);
  return c;
}

/// The jet with these \ref coordinates.
template <int n, int N, MatrixLike C>
Jet<typename C::Scalar, n, N> jet_at(C const& c) {
  Jet<typename C::Scalar, n, N> j;
  j.x = c.template head<n + 1>();
  j.y = c.template segment<N>(n + 1);
  for (int mu = 0; mu <= n; ++mu) j.v.col(mu) = c.template segment<N>(n + 1 + N + N * mu);
  return j;
}

}  // namespace actio
