// The Poisson structures that a discrete Lagrangian puts on G x G and, where it is invariant, on G.
#pragma once

#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/relative_motion.hpp"

namespace actio {

/// The matrix of \f$\omega_L\f$ at (g0, g1) on (theta0, theta1):
/// \f$\omega_L(w_1, w_2) = w_1^T\,\Omega\,w_2\f$.
template <Group G, Scalar S, class L>
auto discrete_two_form_matrix(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  int const n = g0.group.dimension();
  auto const m = mixed_derivative(lagrangian, g0, g1);
  Matrix<S, Dynamic, Dynamic> omega = Matrix<S, Dynamic, Dynamic>::Zero(2 * n, 2 * n);
  omega.topRightCorner(n, n) = -m;
  omega.bottomLeftCorner(n, n) = m.transpose();
  return omega;
}

/// The matrix of the bracket (3.12) on G x G: \f$\{F, H\} = dF^T\,\Pi\,dH\f$ with \f$\Pi = \Omega^{-T}\f$.
///
/// From \f$X_F\lrcorner\omega_L = dF\f$ and \f$\{F, H\} = \omega_L(X_F, X_H)\f$; differentials on (theta0,
/// theta1).
/// \implements{eq_3_12}
/// @throws Singular  where L is not regular at (g0, g1)
template <Group G, Scalar S, class L>
auto discrete_bivector(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  auto const omega = discrete_two_form_matrix(lagrangian, g0, g1);
  // [eq_3_12]
  return inverse_matrix(omega.transpose().eval(), "discrete Poisson structure: omega_L");
  // [eq_3_12]
}

/// The matrix P of the bracket (3.13) on G of a right-invariant discrete Lagrangian:
/// \f$\{a, b\}_G(f) = (R_f^*a')^T\,P\,(R_f^*b')\f$.
///
/// Functions on G are lifted by \f$f = g_0g_1^{-1}\f$; a lifted function changes by \f$R_f^*a'\f$ with
/// \f$g_0\f$ and by \f$-L_f^*a' = -\mathrm{Ad}_f^*R_f^*a'\f$ with \f$g_1\f$.
/// \implements{eq_3_13}
/// @throws Singular  where l is not regular at f
template <Group G, Scalar S, class F>
auto reduced_bivector_right(F const& l, Element<G, S> const& f) {
  int const n = f.group.dimension();
  auto const pi = discrete_bivector(lift_right(l), f, identity<S>(f.group));
  // The tangent of the quotient map at (f, 1).
  Matrix<S, G::dim, Dynamic> tangent(n, 2 * n);
  tangent.leftCols(n).setIdentity();
  tangent.rightCols(n) = -Ad_matrix(f);
  // [eq_3_13]
  return Matrix<S, G::dim, G::dim>(tangent * pi * tangent.transpose());
  // [eq_3_13]
}

/// The same for a left-invariant discrete Lagrangian, a function of \f$f = g_1^{-1}g_0\f$.
template <Group G, Scalar S, class F>
auto reduced_bivector_left(F const& l, Element<G, S> const& f) {
  int const n = f.group.dimension();
  auto const pi = discrete_bivector(lift_left(l), f, identity<S>(f.group));
  // At (f, 1): f changes by theta0 with g0 and by -theta1 with g1, both from the left.
  Matrix<S, G::dim, Dynamic> tangent(n, 2 * n);
  tangent.leftCols(n).setIdentity();
  tangent.rightCols(n) = -Matrix<S, Dynamic, Dynamic>::Identity(n, n);
  return Matrix<S, G::dim, G::dim>(tangent * pi * tangent.transpose());
}

}  // namespace actio
