// The canonical forms of the dual jet bundle and the Cartan form of a density (sections 6.1 and 6.2 of the
// thesis).
//
// With d^{n+1}x = dx^0 ^ dx^1 ^ ... ^ dx^n and d^n x_mu its contraction with d/dx^mu, they are sums of
// products dy^a ^ d^n x_mu and of d^{n+1}x. Forms take coordinates as `coordinates(jet)` orders them: x, y,
// then the rest.
#pragma once

#include "actio/forms/wedge.hpp"
#include "actio/jets/density.hpp"

namespace actio {

/// The volume form \f$d^{n+1}x = dx^0\wedge\dots\wedge dx^n\f$ of space-time, on a bundle whose first
/// coordinates are those of space-time.
template <int n>
auto volume_form() {
  return []<class S, int D>(Matrix<S, D, 1> const&, Tangents<S, D, n + 1> const& V) -> S {
    return determinant(Matrix<S, n + 1, n + 1>(V.template topRows<n + 1>()));
  };
}

/// The n-form \f$d^nx_\mu = \frac{\partial}{\partial x^\mu}\lrcorner\,d^{n+1}x\f$.
template <int n>
auto volume_form(int mu) {
  auto const d_mu = [mu]<class S, int D>(Matrix<S, D, 1> const&) {
    return Matrix<S, D, 1>(Matrix<S, D, 1>::Unit(mu));
  };
  // [claim_6_1_contracted_volume]
  return contract(d_mu, volume_form<n>());
  // [claim_6_1_contracted_volume]
}

/// The form \f$p_a{}^\mu\,dy^a\wedge d^nx_\mu + \Pi\,d^{n+1}x\f$ of momenta at a point, on n + 1 tangent
/// vectors there.
///
/// \implements{eq_6_10}
/// @param p, Pi  momenta, a row for each a, and the affine component
/// @param at     point of a bundle whose first coordinates are x and y
template <int n, int N, class S, int D>
S affine_form(Matrix<S, N, n + 1> const& p, S const& Pi, Matrix<S, D, 1> const& at,
              Tangents<S, D, n + 1> const& V) {
  auto const p_dy = [&p](int mu) {
    return
        [&p, mu](auto const&, auto const& v) -> S { return p.col(mu).dot(v.template block<N, 1>(n + 1, 0)); };
  };
  // [eq_6_10]
  S Theta = Pi * volume_form<n>()(at, V);
  for (int mu = 0; mu <= n; ++mu) Theta += wedge(p_dy(mu), volume_form<n>(mu))(at, V);
  // [eq_6_10]
  return Theta;
}

/// The canonical (n+1)-form \f$\Theta = p_a{}^\mu\,dy^a\wedge d^nx_\mu + \Pi\,d^{n+1}x\f$ of the dual jet
/// bundle.
///
/// \implements{claim_6_1_canonical_forms}
template <int n, int N>
auto canonical_form() {
  return []<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, n + 1> const& V) -> S {
    // [claim_6_1_canonical_forms]
    auto const z = dual_jet_at<n, N>(at);
    return affine_form<n, N>(z.p, z.Pi, at, V);
    // [claim_6_1_canonical_forms]
  };
}

/// \f$\Omega = -d\Theta\f$ on the dual jet bundle, an (n+2)-form.
template <int n, int N>
auto canonical_two_form() {
  return [d = exterior_derivative(canonical_form<n, N>())]<class S, int D>(
             Matrix<S, D, 1> const& at, Tangents<S, D, n + 2> const& V) -> S { return -d(at, V); };
}

/// The Cartan form \f$\Theta_L = p_a{}^\mu\,dy^a\wedge d^nx_\mu + (L - p_a{}^\mu v^a{}_\mu)\,d^{n+1}x\f$ on
/// the jet bundle (6.10): the canonical form pulled back by the Legendre transformation.
///
/// \implements{eq_6_10,eq_6_6}
/// @return  a callable on coordinates of a jet and n + 1 tangent vectors
template <int n, int N, class L>
auto cartan_form(L const& density) {
  return [density]<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, n + 1> const& V) -> S {
    static_assert(D == Jet<S, n, N>::dimension, "the Cartan form takes coordinates of the first jet bundle");
    // The dual bundle has the same x and y, and they are all that the vectors meet there.
    // [eq_6_6]
    auto const z = legendre(density, jet_at<n, N>(at));
    return affine_form<n, N>(z.p, z.Pi, at, V);
    // [eq_6_6]
  };
}

/// The multisymplectic form \f$\Omega_L = -d\Theta_L\f$, an (n+2)-form on the jet bundle.
template <int n, int N, class L>
auto multisymplectic_form(L const& density) {
  return [d = exterior_derivative(cartan_form<n, N>(density))]<class S, int D>(
             Matrix<S, D, 1> const& at, Tangents<S, D, n + 2> const& V) -> S { return -d(at, V); };
}

/// The first jet of a section as a map between coordinates, for pull-backs.
template <class Phi>
auto jet_extension(Phi const& phi) {
  return [phi]<class S, int rows>(Matrix<S, rows, 1> const& x) { return coordinates(first_jet(phi, x)); };
}

}  // namespace actio
