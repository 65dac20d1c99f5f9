// The Lie algebroid of a groupoid and the Poisson structure on its dual, computed from the multiplication
// alone.
//
// A vector v over x gives each arrow that ends at x a direction, g near_unit(x, v). The commutators of
// these fields are the bracket of the algebroid, and how they move the target is its anchor. Nothing is typed
// in by hand: the bracket of a group comes out as the commutator, that of pairs as the bracket of vector
// fields.
#pragma once

#include "actio/groupoid/groupoid.hpp"

namespace actio {

namespace detail {
/// An infinitesimal v of one direction.
template <class Gamma, class S>
Fibre<Gamma, Dual<S>> infinitesimal_along(Gamma const& gamma, int a) {
  return moved_along(Fibre<Gamma, S>(Fibre<Gamma, S>::Zero(gamma.dimension())),
                     Fibre<Gamma, S>(Fibre<Gamma, S>::Unit(gamma.dimension(), a)));
}
/// g moved at its free end along the a-th direction of the algebroid.
template <class Gamma, class A>
auto moved_at_target(Gamma const& gamma, A const& g, int a) {
  using S = typename A::Scalar;
  auto const wide = gamma.template over<Dual<S>>(g);
  return gamma.compose(wide, gamma.near_unit(gamma.target(wide), infinitesimal_along<Gamma, S>(gamma, a)));
}
}  // namespace detail

/// The anchor over the target of g: how the target moves along each direction of the algebroid.
/// base_dimension() rows, dimension() columns.
template <MovableGroupoid Gamma, class A>
auto anchor(Gamma const& gamma, A const& g) {
  using S = typename A::Scalar;
  actio::Matrix<S, Dynamic, Dynamic> rho(gamma.base_dimension(), gamma.dimension());
  for (int a = 0; a < gamma.dimension(); ++a)
    rho.col(a) = gamma.base_rate(gamma.target(detail::moved_at_target(gamma, g, a)));
  return rho;
}

/// The bracket of the frame of the algebroid over the target of g: column b of the a-th matrix holds the
/// components of \f$[e_a, e_b]\f$.
///
/// Solves \f$[X_a, X_b] = C^c_{ab}X_c\f$ for the left-invariant fields \f$X_a\f$ on arrows, applied to the
/// entries of g.
/// @throws Singular  where the entries do not tell the directions apart
template <MovableGroupoid Gamma, class A>
auto algebroid_bracket(Gamma const& gamma, A const& g) {
  using S = typename A::Scalar;
  using Matrix = actio::Matrix<S, Dynamic, Dynamic>;
  int const n = gamma.dimension();
  auto const first_rate = [&](int a) {
    auto const moved = gamma.entries(detail::moved_at_target(gamma, g, a));
    actio::Matrix<S, Dynamic, 1> rate(moved.size());
    for (Index i = 0; i < moved.size(); ++i) rate[i] = moved[i].part[0];
    return rate;
  };
  // X_a X_b: move along a, then along b from there.
  auto const second_rate = [&](int a, int b) {
    auto const moved = gamma.entries(detail::moved_at_target(gamma, detail::moved_at_target(gamma, g, a), b));
    actio::Matrix<S, Dynamic, 1> rate(moved.size());
    for (Index i = 0; i < moved.size(); ++i) rate[i] = moved[i].part[0].part[0];
    return rate;
  };
  Matrix fields(gamma.entries(g).size(), n);
  for (int a = 0; a < n; ++a) fields.col(a) = first_rate(a);
  Matrix const transposed = fields.transpose(), gram = transposed * fields;
  std::vector<Matrix> bracket(n, Matrix::Zero(n, n));
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) {
      actio::Matrix<S, Dynamic, 1> const commutator = second_rate(a, b) - second_rate(b, a);
      bracket[a].col(b) = solve_linear(gram, actio::Matrix<S, Dynamic, 1>(transposed * commutator),
                                       "algebroid_bracket: entries");
      bracket[b].col(a) = -bracket[a].col(b);
    }
  return bracket;
}

/// The matrix of the Poisson structure on the dual of the algebroid at the covector p over the target of g:
/// base coordinates first, then the components of p.
///
/// \f[ \{p_a, p_b\} = C^c_{ab}\,p_c, \qquad \{p_a, f\} = \rho_a(f), \qquad \{f, f'\} = 0 \f]
/// On the dual of TG it is minus the canonical bracket with \f$\{q, p\} = 1\f$, on the dual of an algebra the
/// plus Lie-Poisson bracket.
/// \implements{claim_4_1_dual_poisson}
template <MovableGroupoid Gamma, class A>
auto dual_bivector(Gamma const& gamma, A const& g, Fibre<Gamma, typename A::Scalar> const& p) {
  using S = typename A::Scalar;
  int const m = gamma.base_dimension(), n = gamma.dimension();
  actio::Matrix<S, Dynamic, Dynamic> pi = actio::Matrix<S, Dynamic, Dynamic>::Zero(m + n, m + n);
  auto const rho = anchor(gamma, g);
  auto const bracket = algebroid_bracket(gamma, g);
  // [claim_4_1_dual_poisson]
  pi.topRightCorner(m, n) = -rho;
  pi.bottomLeftCorner(n, m) = rho.transpose();
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) pi(m + a, m + b) = bracket[a].col(b).dot(p);
  // [claim_4_1_dual_poisson]
  return pi;
}

}  // namespace actio
