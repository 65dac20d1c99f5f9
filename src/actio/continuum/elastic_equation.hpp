// The field equations of a homogeneous medium between Euclidean spaces (section 6.2 of the thesis), in as few
// operations as we know.
//
// There the Euler-Lagrange derivative is rho (Div P - acceleration), with the first Piola-Kirchhoff stress
// per mass P = dW/dF. Div P is written out: for the laws of materials.hpp by the derivatives of
// law_derivatives.hpp, for fluids by w'', and for any other law of the Green tensor by one evaluation of the
// law, not of the whole density. `euler_lagrange` computes the same of any density.
#pragma once

#include "actio/continuum/law_derivatives.hpp"
#include "actio/jets/field_equations.hpp"

namespace actio {

namespace detail {

/// \f$w_{\mu\nu}\f$ of the space directions, i and j from 0: \f$\phi^a{}_{,ij}\f$.
template <class S, int n>
S const& bend(SecondJet<S, n, n> const& j, int a, int i, int k) { return j.w[i + 1](a, k + 1); }

/// The cofactors \f$J(F^{-1})^i{}_a\f$, n = 1, 2 or 3: the derivative of det F.
template <class S, int n>
Matrix<S, n, n> cofactors(Matrix<S, n, n> const& F) {
  static_assert(n <= 3);
  Matrix<S, n, n> K;
  if constexpr (n == 1)
    K(0, 0) = S(1);
  else if constexpr (n == 2)
    K << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  else
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a)
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) {
        int const b = (a + 1) % 3, c = (a + 2) % 3, j = (i + 1) % 3, k = (i + 2) % 3;
        K(a, i) = F(b, j) * F(c, k) - F(b, k) * F(c, j);
      }
  return K;
}

/// Adds \f$F^a{}_i d_i\f$ for all a.
template <class S, int n>
[[gnu::always_inline]] inline void add_along(Matrix<S, n, 1>& sum, Matrix<S, n, n> const& F,
                                             Matrix<S, n, 1> const& d) {
#pragma GCC unroll 3
  for (int a = 0; a < n; ++a)
#pragma GCC unroll 3
    for (int i = 0; i < n; ++i) add_product(sum[a], F(a, i), d[i]);
}

/// Adds the divergence of \f$U'(J)\,\mathrm{cof}F\f$: the cofactors times \f$U''\,\partial_iJ\f$.
template <class S, int n, class U>
void add_volume_divergence(Matrix<S, n, 1>& sum, U const& u, Matrix<S, n, n> const& F,
                           SecondJet<S, n, n> const& j) {
  auto const K = cofactors(F);
  S J(0);
  for (int i = 0; i < n; ++i) J += K(0, i) * F(0, i);
  S const curvature = second_derivative(u, J);
  Matrix<S, n, 1> gradient;
#pragma GCC unroll 3
  for (int i = 0; i < n; ++i) {
    S rate(0);
#pragma GCC unroll 3
    for (int b = 0; b < n; ++b)
#pragma GCC unroll 3
      for (int k = 0; k < n; ++k) add_product(rate, K(b, k), bend(j, b, k, i));
    gradient[i] = rate * curvature;
  }
  add_along(sum, K, gradient);
}

/// Div P of a law that \ref split_law knows, which has the stress \f$P = 2f'F + b\,FC + U'\,\mathrm{cof}F\f$.
template <class S, int n, class Law>
  requires requires(Law const& law, S const& trace) { split_law(law, trace, n); }
Matrix<S, n, 1> stress_divergence(OfGreenTensor<Law> const& energy, SecondJet<S, n, n> const& j) {
  Matrix<S, n, n> const F = j.gradient(), C = green_tensor(Kronecker<n>{}, F);
  auto const law = split_law(energy.w, S(C.trace()), n);
  constexpr bool has_square = !std::same_as<decltype(law.square), Absent>,
                 has_volume = !std::same_as<decltype(law.volume), Absent>;
  Base<S> b(0);
  if constexpr (has_square) b = law.square;

  Matrix<S, n, 1> laplacian, d, sum;
#pragma GCC unroll 3
  for (int a = 0; a < n; ++a) {
    laplacian[a] = bend(j, a, 0, 0);
#pragma GCC unroll 3
    for (int i = 1; i < n; ++i) laplacian[a] += bend(j, a, i, i);
    sum[a] = laplacian[a] * law.stretch;
  }
  // d_k = 4f'' F_ci phi^c_,ik + b D_i C_ik, of which F makes what comes from the change of f' and C.
#pragma GCC unroll 3
  for (int k = 0; k < n; ++k) {
    S bending(0), along(0);
#pragma GCC unroll 3
    for (int c = 0; c < n; ++c) {
      if constexpr (has_square) add_product(along, F(c, k), laplacian[c]);
#pragma GCC unroll 3
      for (int i = 0; i < n; ++i) add_product(bending, F(c, i), bend(j, c, i, k));
    }
    d[k] = bending * (law.slope + b);
    if constexpr (has_square) d[k] += along * b;
  }
  add_along(sum, F, d);
  if constexpr (has_square)
#pragma GCC unroll 3
    for (int a = 0; a < n; ++a) {
      S bent(0), crossed(0);
#pragma GCC unroll 3
      for (int i = 0; i < n; ++i) {
        add_product(bent, C(i, i), bend(j, a, i, i));
#pragma GCC unroll 3
        for (int k = 0; k < i; ++k) add_product(crossed, C(i, k), bend(j, a, i, k));
      }
      sum[a] += (bent + crossed + crossed) * b;
    }
  if constexpr (has_volume) add_volume_divergence(sum, law.volume, F, j);
  return sum;
}

/// Div P of any law of the Green tensor: \f$\phi^a{}_{,ij}S_{ij} + F^a{}_j\,\partial_iS_{ij}\f$ with
/// \f$S = 2\,\partial w/\partial C\f$.
template <class S, int n, class Law>
Matrix<S, n, 1> stress_divergence(OfGreenTensor<Law> const& energy, SecondJet<S, n, n> const& j) {
  using T = DivergenceNumber<S, n, n>;
  Matrix<S, n, n> const F = j.gradient(), C = green_tensor(Kronecker<n>{}, F);
  Matrix<T, n, n> moved = C.template cast<T>();
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      for (int mu = 0; mu < n; ++mu) {
        S rate(0);
        for (int b = 0; b < n; ++b) rate += bend(j, b, i, mu) * F(b, k) + F(b, i) * bend(j, b, k, mu);
        moved(i, k).set_rate(mu, rate);
      }
      // S_ik is twice the symmetric derivative: half of it along C_ik, half along C_ki.
      moved(i, k).set_slope(i, k, moved(i, k).slope(i, k) + S(1));
      moved(i, k).set_slope(k, i, moved(i, k).slope(k, i) + S(1));
    }
  T const w = energy.w(moved);
  Matrix<S, n, 1> sum = Matrix<S, n, 1>::Zero(), d;
  for (int k = 0; k < n; ++k) {
    d[k] = w.sum(k);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < n; ++i) add_product(sum[a], w.slope(i, k), bend(j, a, i, k));
  }
  add_along(sum, F, d);
  return sum;
}

/// Div P of a barotropic fluid, where \f$P = w'\,\mathrm{cof}F\f$.
template <class S, int n, class Law>
Matrix<S, n, 1> stress_divergence(Barotropic<Law> const& energy, SecondJet<S, n, n> const& j) {
  Matrix<S, n, 1> sum = Matrix<S, n, 1>::Zero();
  add_volume_divergence(sum, energy.w, Matrix<S, n, n>(j.gradient()), j);
  return sum;
}

}  // namespace detail

/// The Euler-Lagrange derivative \f$\rho\,(\mathrm{Div}\,P - \ddot\phi)\f$ of a homogeneous medium between
/// Euclidean spaces, that of \ref euler_lagrange.
///
/// \implements{claim_6_2_euclidean_elasticity}
/// @param medium  its energy `OfGreenTensor` or `Barotropic`, with any law
/// @param j       second jet of a section, \ref second_jet; n = 1, 2 or 3
/// @throws NotAMassDensity, NotOrientationPreserving, NoDerivative
/// Accuracy: rounding.
template <class S, int n, class R, class Energy>
Matrix<S, n, 1> elastic_equation(Continuum<Euclidean<n>, Euclidean<n>, Homogeneous<R>, Energy> const& medium,
                                 SecondJet<S, n, n> const& j) {
  examine(medium, static_cast<Jet<S, n, n> const&>(j));
  Matrix<S, n, 1> r = detail::stress_divergence(medium.W, j);
#pragma GCC unroll 3
  for (int a = 0; a < n; ++a) r[a] = (r[a] - j.w[0](a, 0)) * Base<S>(medium.rho.value);
  require_derivative(r, static_cast<Jet<S, n, n> const&>(j), "elastic_equation");
  return r;
}

}  // namespace actio
