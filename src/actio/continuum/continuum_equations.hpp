// The field equations of a continuous medium as chapter 6 of the thesis writes them: (6.13), (6.18), (6.20),
// (6.21).
//
// Each function is left side minus right side. The first three are -E_a / sqrt(det G) with E = euler_lagrange
// of the medium's density, the last the same with its index raised: forces per volume of the body.
// `euler_lagrange` needs none of this; these forms have fewer derivatives, and stresses and pressures in
// them.
#pragma once

#include "actio/continuum/two_point_divergence.hpp"

namespace actio {

/// \f$\rho\,g_{ab}\,(D_g\dot\phi/Dt)^b\f$: mass times acceleration, a covector of space per volume of the
/// body.
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, 1> inertial_force(Medium const& medium, SecondJet<S, n, N> const& j) {
  return lowered(medium.g(j.y), material_acceleration(medium.g, j)) * S(medium.rho(j.particle()));
}

/// \f$-\rho\,\frac{\partial W}{\partial g_{bc}}\,\frac{\partial g_{bc}}{\partial y^a}\f$: the right side of
/// (6.13), zero where g is constant.
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, 1> metric_force(Medium const& medium, Jet<S, n, N> const& j) {
  Matrix<S, N, 1> force = Matrix<S, N, 1>::Zero();
  if constexpr (!is_constant_metric<std::remove_cvref_t<decltype(medium.g)>>) {
    auto const dg = metric_derivatives(medium.g, j.y);
    Matrix<S, N, N> const by_metric = partial_g(medium, j) * S(medium.rho(j.particle()));
    for (int a = 0; a < N; ++a) force[a] = -by_metric.cwiseProduct(dg[a]).sum();
  }
  return force;
}

/// The equation of motion of any medium (6.13),
/// \f$\rho\,g_{ab}\bigl(\tfrac{D_g\dot\phi}{Dt}\bigr)^b - \tfrac1{\sqrt{\det
/// G}}\,\partial_k\bigl(\rho\,\tfrac{\partial W}{\partial v^a{}_k}\sqrt{\det G}\bigr) + \rho\,\tfrac{\partial
/// W}{\partial g_{bc}}\tfrac{\partial g_{bc}}{\partial y^a}\f$.
///
/// \implements{eq_6_13}
/// @param j  second jet of a section
/// @throws NoDerivative  where W has no second derivative; and what the medium refuses
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, 1> medium_equation(Medium const& medium, SecondJet<S, n, N> const& j) {
  Jet<S, n, N> const& first = j;
  examine(medium, first);
  auto const rho_W_v_sqrt_det_G = [&]<class T>(Jet<T, n, N> const& jet) {
    T const weight = medium.rho(jet.particle()) * volume<T>(medium.G(jet.particle()));
    return partial_F(medium, jet) * weight;
  };
  S const sqrt_det_G = volume<S>(medium.G(j.particle()));
  // [eq_6_13]
  Matrix<S, N, 1> const r = inertial_force(medium, j) - total_divergence(rho_W_v_sqrt_det_G, j) / sqrt_det_G -
                            metric_force(medium, first);
  // [eq_6_13]
  require_derivative(r, first, "medium_equation");
  return r;
}

/// The equation of motion of a barotropic fluid (6.18),
/// \f$\rho\,g_{ab}\bigl(\tfrac{D_g\dot\phi}{Dt}\bigr)^b + \partial_kP\,J\,(F^{-1})^k{}_a\f$.
///
/// \implements{eq_6_18}
/// @throws NotOrientationPreserving  where J is not positive; and what else the medium refuses
template <class Medium, class S, int n>
  requires MediumOver<Medium, S, n, n> && FluidMedium<Medium>
Matrix<S, n, 1> fluid_equation(Medium const& medium, SecondJet<S, n, n> const& j) {
  Jet<S, n, n> const& first = j;
  examine(medium, first);
  auto const P = [&](auto const& jet) { return material_pressure(medium, jet); };
  // [eq_6_18]
  Matrix<S, n, 1> dP;
  for (int k = 0; k < n; ++k) dP[k] = total_derivative(k + 1, P, j);
  Matrix<S, n, 1> const r = inertial_force(medium, j) +
                            area_transformation(medium.G(j.particle()), medium.g(j.y), j.gradient()) * dP;
  // [eq_6_18]
  require_derivative(r, first, "fluid_equation");
  return r;
}

/// The covariant divergence of the medium's first Piola-Kirchhoff stress, \f$\mathrm{DIV}\,\mathcal P\f$.
/// @throws NoDerivative  where W has no second derivative; and what the medium refuses
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, 1> stress_divergence(Medium const& medium, SecondJet<S, n, N> const& j) {
  Jet<S, n, N> const& first = j;
  examine(medium, first);
  Matrix<S, N, 1> const r = two_point_divergence(
      medium.G, medium.g, j, [&](auto const& jet) { return first_piola_kirchhoff_stress(medium, jet); });
  require_derivative(r, first, "stress_divergence");
  return r;
}

/// The equation of motion with stresses (6.20),
/// \f$\rho\,g_{ab}\bigl(\tfrac{D_g\dot\phi}{Dt}\bigr)^b - \mathcal P_a{}^i{}_{|i} - \gamma^b_{ac}\,(\mathcal
/// P_b{}^jF^c{}_j - J\,g_{bd}\,\sigma^{dc})\f$. Where the metrics are constant, the last term is zero.
///
/// \implements{eq_6_20,claim_6_2_euclidean_elasticity}
/// @throws NoDerivative  where W has no second derivative; and what the medium refuses
template <class Medium, class S, int n>
  requires MediumOver<Medium, S, n, n>
Matrix<S, n, 1> stress_equation(Medium const& medium, SecondJet<S, n, n> const& j) {
  Jet<S, n, n> const& first = j;
  // [eq_6_20]
  Matrix<S, n, 1> r = inertial_force(medium, j) - stress_divergence(medium, j);
  if constexpr (!is_constant_metric<std::remove_cvref_t<decltype(medium.g)>>) {
    auto const g = medium.g(j.y);
    S const J = jacobian(medium.G(j.particle()), g, j.gradient());
    auto const gamma = christoffel(medium.g, j.y);
    Matrix<S, n, n> const excess = first_piola_kirchhoff_stress(medium, first) * j.gradient().transpose() -
                                   lowered(g, cauchy_stress(medium, first)) * J;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < n; ++c) r[a] -= gamma[b](a, c) * excess(b, c);
  }
  // [eq_6_20]
  return r;
}

/// The equation of motion of an elastic body (6.21),
/// \f$\rho\,\bigl(\tfrac{D_gV}{Dt}\bigr)^a - g^{ab}\,\mathcal P_b{}^i{}_{|i}\f$, where W is a function of the
/// Green tensor.
///
/// \snippet fields.cpp solid_equation
///
/// \implements{eq_6_21}
/// @return  a vector of space
/// @throws NoDerivative  where W has no second derivative; and what the medium refuses
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, 1> solid_equation(Medium const& medium, SecondJet<S, n, N> const& j) {
  // [eq_6_21]
  return material_acceleration(medium.g, j) * S(medium.rho(j.particle())) -
         raised(medium.g(j.y), stress_divergence(medium, j));
  // [eq_6_21]
}

}  // namespace actio
