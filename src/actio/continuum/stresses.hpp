// The stresses of a continuous medium: first Piola and Kirchhoff's, Cauchy's, the pressure of a fluid, and
// Piola's transformation (section 6.2 of the thesis).
//
// All come from the stored energy W(x, G, g, F) per unit mass and the mass rho per volume of the body, so
// they are forces per area, or energies per volume. The derivative in the metric is the symmetric one:
// dW = (dW/dg_ab) h_ab for symmetric h, with dW/dg_ab = dW/dg_ba however W is written.
#pragma once

#include "actio/continuum/materials.hpp"

namespace actio {

namespace detail {

/// The value of a metric over a scalar that extends its own.
template <class T, class S, int n>
Matrix<T, n, n> metric_over(Matrix<S, n, n> const& g) { return g.template cast<T>(); }
template <class T, int n>
Kronecker<n> metric_over(Kronecker<n> g) { return g; }

}  // namespace detail

/// The derivatives \f$\partial W/\partial F^a{}_i\f$ of a medium's stored energy by the deformation gradient:
/// a row for each a, a column for each i.
///
/// \ref first_piola_kirchhoff_stress is this times the mass density, and asks the medium first whether it is
/// defined.
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, n> partial_F(Medium const& medium, Jet<S, n, N> const& j) {
  Matrix<S, n, 1> const x = j.particle();
  auto const G = medium.G(x);
  auto const g = medium.g(j.y);
  auto const W = [&]<class T>(Matrix<T, N, n> const& F) -> T {
    return medium.W(x.template cast<T>(), detail::metric_over<T>(G), detail::metric_over<T>(g), F);
  };
  return derivative(W, j.gradient()).gradient();
}

/// The symmetric derivatives \f$\partial W/\partial g_{ab}\f$ of a medium's stored energy by the metric of
/// space.
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, N> partial_g(Medium const& medium, Jet<S, n, N> const& j) {
  Matrix<S, n, 1> const x = j.particle();
  Matrix<S, N, n> const F = j.gradient();
  auto const G = medium.G(x);
  auto const W = [&]<class T>(Matrix<T, N, N> const& g) -> T {
    return medium.W(x.template cast<T>(), detail::metric_over<T>(G), g, F.template cast<T>());
  };
  Matrix<S, N, N> const d = derivative(W, as_matrix<S>(medium.g(j.y))).gradient();
  // Half of a change of the symmetric matrix goes to g_ab and half to g_ba.
  return (d + d.transpose()) * ratio<S>(1, 2);
}

/// The first Piola-Kirchhoff stress \f$\mathcal P_a{}^i = \rho\,\partial W/\partial F^a{}_i\f$ (6.19): force
/// per area of the body.
///
/// \implements{eq_6_19}
/// @return  a row for each a, a column for each i
/// @throws NoDerivative  where the stored energy has none; and what the medium itself refuses
/// Accuracy: exact but for the rounding of W.
template <class Medium, class S, int n, int N>
  requires MediumOver<Medium, S, n, N>
Matrix<S, N, n> first_piola_kirchhoff_stress(Medium const& medium, Jet<S, n, N> const& j) {
  examine(medium, j);
  // [eq_6_19]
  Matrix<S, N, n> const stress = partial_F(medium, j) * S(medium.rho(j.particle()));
  // [eq_6_19]
  require_derivative(stress, j, "first_piola_kirchhoff_stress");
  return stress;
}

/// The Cauchy stress \f$\sigma^{ab} = \frac{2\rho}{J}\,\frac{\partial W}{\partial g_{ab}}\f$ (6.14), Doyle
/// and Ericksen's formula: force per area of space.
///
/// \snippet fields.cpp cauchy_stress
///
/// \implements{eq_6_14}
/// @return  a symmetric matrix with upper indices
/// @throws NotOrientationPreserving  where J is not positive
/// @throws NoDerivative  where the stored energy has none; and what the medium itself refuses
template <class Medium, class S, int n>
  requires MediumOver<Medium, S, n, n>
Matrix<S, n, n> cauchy_stress(Medium const& medium, Jet<S, n, n> const& j) {
  examine(medium, j);
  Matrix<S, n, 1> const x = j.particle();
  auto const g = medium.g(j.y);
  require_volume(g, j.y, "metric of the space");
  S const J = jacobian(medium.G(x), g, j.gradient());
  require_orientation(J, x, "cauchy_stress");
  // [eq_6_14]
  Matrix<S, n, n> const stress = partial_g(medium, j) * S(S(2) * medium.rho(x) / J);
  // [eq_6_14]
  require_derivative(stress, j, "cauchy_stress");
  return stress;
}

namespace detail {
/// The stored energy of a fluid's particle as a function of J: `W.law_at(x)` where the law differs from
/// particle to particle, else `W.w`.
template <class Energy, class S, int n>
decltype(auto) law_at(Energy const& W, Matrix<S, n, 1> const& x) {
  if constexpr (requires { W.law_at(x); })
    return W.law_at(x);
  else
    return (W.w);
}
}  // namespace detail

/// A medium whose stored energy is a function of the particle and of the Jacobian alone.
///
/// An energy of one's own says so by a specialisation of `is_barotropic`. It has a member `w`, the function
/// of J, or a member function `law_at(x)` that returns one for each particle.
template <class Medium>
concept FluidMedium = is_barotropic<std::remove_cvref_t<decltype(std::declval<Medium const&>().W)>>;

/// The material pressure \f$P = -\rho\,\partial W/\partial J\f$ of a barotropic fluid (6.16), a function on
/// the body.
///
/// \implements{eq_6_16}
/// @throws NotOrientationPreserving  where J is not positive; and what else the medium refuses
template <class Medium, class S, int n>
  requires MediumOver<Medium, S, n, n> && FluidMedium<Medium>
S material_pressure(Medium const& medium, Jet<S, n, n> const& j) {
  examine(medium, j);
  Matrix<S, n, 1> const x = j.particle();
  auto const [W, dW_dJ] =
      derivative(detail::law_at(medium.W, x), jacobian(medium.G(x), medium.g(j.y), j.gradient()));
  // [eq_6_16]
  S const P = -(S(medium.rho(x)) * dW_dJ);
  // [eq_6_16]
  require_derivative(Matrix<S, 1, 1>(P), j, "material_pressure");
  return P;
}

/// \f$J\,(F^{-1})^i{}_a\f$, what carries areas of space to areas of the body: a row for each a, a column for
/// each i, as a Piola-Kirchhoff stress has.
/// @throws Singular  where F has no inverse
template <class BodyMetric, class SpaceMetric, class S, int n>
Matrix<S, n, n> area_transformation(BodyMetric const& G, SpaceMetric const& g, Matrix<S, n, n> const& F) {
  return inverse_matrix(F, "area_transformation").transpose() * jacobian(G, g, F);
}

/// Piola's transformation \f$J\,g_{ab}\,\sigma^{bc}\,(F^{-1})^i{}_c\f$ of a stress on space: the first
/// Piola-Kirchhoff stress where W is a function of the Green tensor.
///
/// \implements{claim_6_2_piola_transform}
/// @param sigma  Cauchy stress with upper indices
/// @throws Singular  where F has no inverse
template <class BodyMetric, class SpaceMetric, class S, int n>
Matrix<S, n, n> piola_transformation(BodyMetric const& G, SpaceMetric const& g, Matrix<S, n, n> const& F,
                                     Matrix<S, n, n> const& sigma) {
  // [claim_6_2_piola_transform]
  return lowered(g, sigma) * area_transformation(G, g, F);
  // [claim_6_2_piola_transform]
}

}  // namespace actio
