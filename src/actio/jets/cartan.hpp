// The canonical forms of the dual jet bundle and the Cartan form of a density (sections 6.1 and 6.2 of the thesis).
//
// With d^{n+1}x = dx^0 ^ dx^1 ^ ... ^ dx^n and d^n x_mu its contraction with d/dx^mu, the product dy^a ^ d^n x_mu is d^{n+1}x with dx^mu replaced by dy^a: on
// tangent vectors both are determinants. Forms take coordinates as `coordinates(jet)` orders them: x, y, then the rest.
#pragma once

#include "actio/forms/forms.hpp"
#include "actio/jets/density.hpp"

namespace actio {

namespace detail {

/// \f$p_a{}^\mu\,dy^a\wedge d^nx_\mu + \Pi\,d^{n+1}x\f$ on n + 1 vectors whose first n + 1 + N components are those of x and y.
template <int n, int N, class S, int D>
S affine_form(Matrix<S, N, n + 1> const& p, S const& Pi, Tangents<S, D, n + 1> const& V) {
  Matrix<S, n + 1, n + 1> const dx = V.template topRows<n + 1>();
  S sum = Pi * determinant(dx);
  for (int mu = 0; mu <= n; ++mu) {
    // The determinant is linear in the row: one for all a.
    Matrix<S, n + 1, n + 1> replaced = dx;
    for (int c = 0; c <= n; ++c) {
      S entry(0);
      for (int a = 0; a < N; ++a) entry += p(a, mu) * V(n + 1 + a, c);
      replaced(mu, c) = entry;
    }
    sum += determinant(replaced);
  }
  return sum;
}

}  // namespace detail

/// The canonical (n+1)-form \f$\Theta = p_a{}^\mu\,dy^a\wedge d^nx_\mu + \Pi\,d^{n+1}x\f$ of the dual jet bundle.
///
/// \implements{claim_6_1_canonical_forms}
template <int n, int N>
auto canonical_form() {
  return []<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, n + 1> const& V) -> S {
    // [claim_6_1_canonical_forms]
    auto const z = dual_jet_at<n, N>(at);
    return detail::affine_form<n, N>(z.p, z.Pi, V);
    // [claim_6_1_canonical_forms]
  };
}

/// \f$\Omega = -d\Theta\f$ on the dual jet bundle, an (n+2)-form.
template <int n, int N>
auto canonical_two_form() {
  return [d = exterior_derivative(canonical_form<n, N>())]<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, n + 2> const& V) -> S {
    return -d(at, V);
  };
}

/// The Cartan form \f$\Theta_L = p_a{}^\mu\,dy^a\wedge d^nx_\mu + (L - p_a{}^\mu v^a{}_\mu)\,d^{n+1}x\f$ on the jet bundle (6.10): the canonical form
/// pulled back by the Legendre transformation.
///
/// \implements{eq_6_10,eq_6_6}
/// @return  a callable on coordinates of a jet and n + 1 tangent vectors
template <int n, int N, class L>
auto cartan_form(L const& density) {
  return [density]<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, n + 1> const& V) -> S {
    static_assert(D == Jet<S, n, N>::dimension, "the Cartan form takes coordinates of the first jet bundle");
    // The dual bundle has the same x and y, and they are all that the vectors meet there.
    // [eq_6_10]
    auto const z = legendre(density, jet_at<n, N>(at));
    return detail::affine_form<n, N>(z.p, z.Pi, V);
    // [eq_6_10]
  };
}

/// The multisymplectic form \f$\Omega_L = -d\Theta_L\f$, an (n+2)-form on the jet bundle.
template <int n, int N, class L>
auto multisymplectic_form(L const& density) {
  return [d = exterior_derivative(cartan_form<n, N>(density))]<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, n + 2> const& V) -> S {
    return -d(at, V);
  };
}

/// The first jet of a section as a map between coordinates, for pull-backs.
template <class Phi>
auto jet_extension(Phi const& phi) {
  return [phi]<class S, int rows>(Matrix<S, rows, 1> const& x) { return coordinates(first_jet(phi, x)); };
}

}  // namespace actio
