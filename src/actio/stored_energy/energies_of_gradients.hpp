// What media have stored, as functions of the deformation gradient F over any scalar, and of Green's tensor
// \f$C = F^TF\f$ in numbers: W, its first derivative, and \f$2\,\partial W/\partial C\f$.
//
// Formulas are those of fast_cell_2d.hpp without its edges: a medium is one struct on both ways.
#pragma once

#include <cmath>

#include "actio/linear_algebra/linear.hpp"
#include "actio/numbers/derivative.hpp"
#include "actio/stored_energy/fast_cell_2d.hpp"

namespace actio::media {

/// The cofactors of a matrix with up to three rows: its determinant's derivative.
template <class T, int d>
Matrix<T, d, d> cofactors(Matrix<T, d, d> const& F) {
  Matrix<T, d, d> c;
  if constexpr (d == 1) {
    c(0, 0) = T(1);
  } else if constexpr (d == 2) {
    c(0, 0) = F(1, 1), c(0, 1) = -F(1, 0), c(1, 0) = -F(0, 1), c(1, 1) = F(0, 0);
  } else {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        int const a = (i + 1) % 3, b = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
        c(i, j) = F(a, p) * F(b, q) - F(a, q) * F(b, p);
      }
  }
  return c;
}
/// The determinant of a matrix with up to three rows, along its first column.
template <class T, int d>
T small_determinant(Matrix<T, d, d> const& F) {
  if constexpr (d == 1)
    return F(0, 0);
  else if constexpr (d == 2)
    return F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
  else
    return F(0, 0) * (F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)) +
           F(1, 0) * (F(2, 1) * F(0, 2) - F(2, 2) * F(0, 1)) +
           F(2, 0) * (F(0, 1) * F(1, 2) - F(0, 2) * F(1, 1));
}

/// \f$W\f$ of a barotropic fluid: \f$U(J)\f$, speed squared.
template <class Volume, class T, int d>
T energy_of(FastFluid<Volume> const& medium, Matrix<T, d, d> const& F) {
  return medium.volume.energy(small_determinant(F));
}
/// \f$\partial W/\partial F = U'\,\mathrm{cof}\,F\f$.
template <class Volume, class T, int d>
Matrix<T, d, d> stress_of(FastFluid<Volume> const& medium, Matrix<T, d, d> const& F) {
  T const slope = medium.volume.slope(small_determinant(F));
  Matrix<T, d, d> P = cofactors(F);
  for (int k = 0; k < d * d; ++k) P.data()[k] = P.data()[k] * slope;
  return P;
}
/// \f$W\f$ of a neo-Hookean solid: \f$\tfrac\mu2(\Tr C-d)+U(J)\f$, speed squared.
template <class Volume, class T, int d>
T energy_of(FastNeoHookean<Volume> const& medium, Matrix<T, d, d> const& F) {
  T trace(-double(d));
  for (int k = 0; k < d * d; ++k) trace = trace + F.data()[k] * F.data()[k];
  return trace * (medium.mu / 2) + medium.volume.energy(small_determinant(F));
}
/// \f$\partial W/\partial F = \mu F+U'\,\mathrm{cof}\,F\f$.
template <class Volume, class T, int d>
Matrix<T, d, d> stress_of(FastNeoHookean<Volume> const& medium, Matrix<T, d, d> const& F) {
  T const slope = medium.volume.slope(small_determinant(F));
  Matrix<T, d, d> P = cofactors(F);
  for (int k = 0; k < d * d; ++k) P.data()[k] = P.data()[k] * slope + F.data()[k] * medium.mu;
  return P;
}

namespace detail {
/// \f$E = \tfrac12(F^TF-1)\f$.
template <class T, int d>
Matrix<T, d, d> green_strain(Matrix<T, d, d> const& F) {
  Matrix<T, d, d> E;
  for (int i = 0; i < d; ++i)
    for (int j = 0; j <= i; ++j) {
      T sum(i == j ? -1.0 : 0.0);
      for (int a = 0; a < d; ++a) sum = sum + F(a, i) * F(a, j);
      E(i, j) = E(j, i) = sum * 0.5;
    }
  return E;
}
}  // namespace detail

/// \f$W\f$ of St Venant and Kirchhoff's solid: \f$\tfrac\lambda2(\Tr E)^2+\mu\Tr E^2\f$, speed squared.
template <class T, int d>
T energy_of(FastStVenantKirchhoff const& medium, Matrix<T, d, d> const& F) {
  auto const E = detail::green_strain(F);
  T trace(0.0), square(0.0);
  for (int i = 0; i < d; ++i) trace = trace + E(i, i);
  for (int k = 0; k < d * d; ++k) square = square + E.data()[k] * E.data()[k];
  return trace * trace * (medium.lambda / 2) + square * medium.mu;
}
/// \f$\partial W/\partial F = F(\lambda\Tr E+2\mu E)\f$.
template <class T, int d>
Matrix<T, d, d> stress_of(FastStVenantKirchhoff const& medium, Matrix<T, d, d> const& F) {
  auto S = detail::green_strain(F);
  T trace(0.0);
  for (int i = 0; i < d; ++i) trace = trace + S(i, i);
  for (int k = 0; k < d * d; ++k) S.data()[k] = S.data()[k] * (2 * medium.mu);
  for (int i = 0; i < d; ++i) S(i, i) = S(i, i) + trace * medium.lambda;
  return F * S;
}

/// \f$2\,\partial W/\partial C = U'J\,C^{-1}\f$ of a fluid, given \f$C = F^TF\f$.
template <class Volume, int d>
Matrix<double, d, d> green_stress_of(FastFluid<Volume> const& medium, Matrix<double, d, d> const& C) {
  double const J = std::sqrt(small_determinant(C));
  return cofactors(C) * (medium.volume.slope(J) / J);
}

/// \f$2\,\partial W/\partial C = \mu+U'J\,C^{-1}\f$ of a neo-Hookean solid.
template <class Volume, int d>
Matrix<double, d, d> green_stress_of(FastNeoHookean<Volume> const& medium, Matrix<double, d, d> const& C) {
  double const J = std::sqrt(small_determinant(C));
  Matrix<double, d, d> S = cofactors(C) * (medium.volume.slope(J) / J);
  for (int i = 0; i < d; ++i) S(i, i) += medium.mu;
  return S;
}

/// \f$W\f$ of a reader's own law: a callable on deformation gradients over any scalar.
template <class Law, class T, int d>
  requires std::invocable<Law const&, Matrix<T, d, d> const&>
T energy_of(Law const& law, Matrix<T, d, d> const& F) { return law(F); }
/// \f$\partial W/\partial F\f$ of a reader's own law, by dual numbers.
template <class Law, class T, int d>
  requires std::invocable<Law const&, Matrix<T, d, d> const&>
Matrix<T, d, d> stress_of(Law const& law, Matrix<T, d, d> const& F) { return derivative(law, F).gradient(); }

namespace detail {
/// The upper triangle R with positive diagonal and \f$R^TR = C\f$.
template <int d>
Matrix<double, d, d> cholesky_upper(Matrix<double, d, d> const& C) {
  auto R = Matrix<double, d, d>::Zero();
  for (int j = 0; j < d; ++j)
    for (int i = 0; i <= j; ++i) {
      double sum = C(i, j);
      for (int k = 0; k < i; ++k) sum -= R(k, i) * R(k, j);
      R(i, j) = i == j ? std::sqrt(sum) : sum / R(i, i);
    }
  return R;
}
/// \f$R^{-1}P\f$ for an upper triangle R.
template <int d>
Matrix<double, d, d> upper_solved(Matrix<double, d, d> const& R, Matrix<double, d, d> P) {
  for (int j = 0; j < d; ++j)
    for (int i = d - 1; i >= 0; --i) {
      for (int k = i + 1; k < d; ++k) P(i, j) -= R(i, k) * P(k, j);
      P(i, j) /= R(i, i);
    }
  return P;
}
}  // namespace detail

/// \f$2\,\partial W/\partial C\f$ of any law that turns do not change: the symmetric part of
/// \f$R^{-1}\,\partial W/\partial F(R)\f$, where R is the upper triangle with \f$R^TR = C\f$.
template <class Medium, int d>
Matrix<double, d, d> green_stress_of(Medium const& medium, Matrix<double, d, d> const& C) {
  auto const R = detail::cholesky_upper(C), half = detail::upper_solved(R, stress_of(medium, R));
  return (half + half.transpose()) * 0.5;
}

/// A medium whose stored energy per reference volume is \f$\rho^pW(F)\f$, where its mass density is
/// \f$\rho\f$. Media without it have p = 1: W is energy per mass.
template <class Medium>
struct Weighed {
  Medium medium;  ///< W, in the unit that makes \f$\rho^pW\f$ a pressure
  double power;   ///< p: 1 for energy per mass, 0 for energy per reference volume
};
template <class Medium>
Weighed(Medium, double) -> Weighed<Medium>;
/// W of the medium.
template <class Medium, class T, int d>
T energy_of(Weighed<Medium> const& weighed, Matrix<T, d, d> const& F) { return energy_of(weighed.medium, F); }
/// \f$\partial W/\partial F\f$ of the medium.
template <class Medium, class T, int d>
Matrix<T, d, d> stress_of(Weighed<Medium> const& weighed, Matrix<T, d, d> const& F) {
  return stress_of(weighed.medium, F);
}
/// \f$2\,\partial W/\partial C\f$ of the medium.
template <class Medium, int d>
Matrix<double, d, d> green_stress_of(Weighed<Medium> const& weighed, Matrix<double, d, d> const& C) {
  return green_stress_of(weighed.medium, C);
}
/// A gas with pressure \f$K(\rho/J)^\gamma\f$: \f$\rho^\gamma\tfrac K{\gamma-1}J^{1-\gamma}\f$ per reference
/// volume, of one entropy wherever its density varies.
///
/// \snippet media.cpp isentropic_gas
/// @param K      pressure over \f$\rho^\gamma\f$ at J = 1, pressure x (volume/mass)^gamma; positive
/// @param gamma  exponent, the ratio of the specific heats, above 1; 1.4 for air
inline Weighed<FastFluid<PolytropicGas>> isentropic_gas(double K, double gamma) {
  return {{{K, gamma}}, gamma};
}
/// A medium whose moduli are given per reference volume, not per mass: as pressures, in pascal for instance.
template <class Medium>
Weighed<Medium> per_volume(Medium const& medium) { return {medium, 0}; }

/// The volume part \f$U = -\mu\log J+\tfrac\kappa2(J-1)^2\f$ of a neo-Hookean solid, free of stress at rest.
struct QuadraticLaw {
  double mu;     ///< shear modulus of the solid over the mass density, speed squared; that of its solid
  double kappa;  ///< modulus of the volume over the mass density, speed squared; positive
  /// U, speed squared.
  template <class T>
  T energy(T const& J) const {
    using std::log;
    return (J - 1.0) * (J - 1.0) * (kappa / 2) - log(J) * mu;
  }
  /// \f$U'\f$.
  template <class T>
  T slope(T const& J) const { return (J - 1.0) * kappa - mu / J; }
  /// \f$U+m\log J\f$ from \f$J-1\f$ and \f$\log J\f$, without loss where these are small and m is \f$\mu\f$.
  double energy_beyond(double m, double j, double log) const { return kappa / 2 * j * j + (m - mu) * log; }
  /// \f$JU'+m\f$, likewise.
  double slope_beyond(double m, double j, double) const { return (1 + j) * kappa * j + (m - mu); }
};

}  // namespace actio::media
