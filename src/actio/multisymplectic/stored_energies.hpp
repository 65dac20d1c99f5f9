// Stored energies of media as a body of any mesh needs them: W(F) in one, two or three dimensions, its first
// derivative and the change of that, for the media of the fast road and for a reader's own.
//
//     auto const rubber = stored_energy<3>(per_volume(neo_hookean(2, 1)));
//     auto const air    = stored_energy<2>(isentropic_gas(1, 1.4));
//     auto const own    = stored_energy<2>([](auto const& F) { return ...; });   // per mass, any scalar
//
// Formulas are those of fast_cell_2d.hpp without its edges: a medium is one struct on both roads.
#pragma once

#include <cmath>
#include <memory>

#include "actio/multisymplectic/fast_cell_2d.hpp"
#include "actio/multisymplectic/small_strains.hpp"
#include "actio/numbers/derivative.hpp"
#include "actio/numbers/linear.hpp"

namespace actio {

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

// W and 2 dW/dC as functions of Green's strain E, of the media that know them without subtracting one.

/// W of a fluid whose law knows the change of the volume.
template <class Volume, int d>
  requires requires(Volume const& law) { law.energy_beyond(0.0); }
double strain_energy(FastFluid<Volume> const& medium, Matrix<double, d, d> const& E) {
  return medium.volume.energy_beyond(StrainMeasures<d>(E).logarithm);
}
/// \f$2\,\partial W/\partial C = U'J\,C^{-1}\f$.
template <class Volume, int d>
  requires requires(Volume const& law) { law.energy_beyond(0.0); }
Matrix<double, d, d> strain_stress(FastFluid<Volume> const& medium, Matrix<double, d, d> const& E) {
  double const log = StrainMeasures<d>(E).logarithm;
  return cofactors(beyond_identity<d>(E * 2)) * (medium.volume.slope_beyond(log) * std::exp(-log));
}
/// W of a neo-Hookean solid: \f$\mu(\Tr E-\log J)+(U+\mu\log J)\f$.
template <class Volume, int d>
  requires requires(Volume const& law) { law.energy_beyond(0.0, 0.0, 0.0); }
double strain_energy(FastNeoHookean<Volume> const& medium, Matrix<double, d, d> const& E) {
  StrainMeasures<d> const of(E);
  return medium.mu * of.distortion + medium.volume.energy_beyond(medium.mu, of.volume, of.logarithm);
}
/// \f$2\,\partial W/\partial C = (2\mu E+JU'+\mu)\,C^{-1}\f$.
template <class Volume, int d>
  requires requires(Volume const& law) { law.energy_beyond(0.0, 0.0, 0.0); }
Matrix<double, d, d> strain_stress(FastNeoHookean<Volume> const& medium, Matrix<double, d, d> const& E) {
  StrainMeasures<d> const of(E);
  double const J = 1 + of.volume, beyond = medium.volume.slope_beyond(medium.mu, of.volume, of.logarithm);
  Matrix<double, d, d> left = E * (2 * medium.mu);
  for (int i = 0; i < d; ++i) left(i, i) += beyond;
  return left * cofactors(beyond_identity<d>(E * 2)) * (1 / (J * J));
}
/// W of St Venant and Kirchhoff's solid.
template <int d>
double strain_energy(FastStVenantKirchhoff const& medium, Matrix<double, d, d> const& E) {
  double const trace = E.trace();
  double square = 0;
  for (int k = 0; k < d * d; ++k) square += E.data()[k] * E.data()[k];
  return medium.lambda / 2 * trace * trace + medium.mu * square;
}
/// \f$2\,\partial W/\partial C = \lambda\Tr E+2\mu E\f$.
template <int d>
Matrix<double, d, d> strain_stress(FastStVenantKirchhoff const& medium, Matrix<double, d, d> const& E) {
  Matrix<double, d, d> S = E * (2 * medium.mu);
  for (int i = 0; i < d; ++i) S(i, i) += medium.lambda * E.trace();
  return S;
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
T energy_of(Law const& law, Matrix<T, d, d> const& F) {
  return law(F);
}
/// \f$\partial W/\partial F\f$ of a reader's own law, by dual numbers.
template <class Law, class T, int d>
  requires std::invocable<Law const&, Matrix<T, d, d> const&>
Matrix<T, d, d> stress_of(Law const& law, Matrix<T, d, d> const& F) {
  return derivative(law, F).gradient();
}

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
  Medium medium;  ///< W
  double power;   ///< p
};
template <class Medium>
Weighed(Medium, double) -> Weighed<Medium>;
/// W of the medium.
template <class Medium, class T, int d>
T energy_of(Weighed<Medium> const& weighed, Matrix<T, d, d> const& F) {
  return energy_of(weighed.medium, F);
}
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
/// W of the medium, where it knows that of a strain.
template <class Medium, int d>
auto strain_energy(Weighed<Medium> const& weighed, Matrix<double, d, d> const& E)
    -> decltype(strain_energy(weighed.medium, E)) {
  return strain_energy(weighed.medium, E);
}
/// \f$2\,\partial W/\partial C\f$ of the medium, likewise.
template <class Medium, int d>
auto strain_stress(Weighed<Medium> const& weighed, Matrix<double, d, d> const& E)
    -> decltype(strain_stress(weighed.medium, E)) {
  return strain_stress(weighed.medium, E);
}
/// A gas with pressure \f$K(\rho/J)^\gamma\f$: \f$\rho^\gamma\tfrac K{\gamma-1}J^{1-\gamma}\f$ per reference
/// volume, of one entropy wherever its density varies.
inline Weighed<FastFluid<PolytropicGas>> isentropic_gas(double K, double gamma) {
  return {{{K, gamma}}, gamma};
}
/// A medium whose moduli are given per reference volume, not per mass.
template <class Medium>
Weighed<Medium> per_volume(Medium const& medium) {
  return {medium, 0};
}

/// The volume part \f$U = -\mu\log J+\tfrac\kappa2(J-1)^2\f$ of a neo-Hookean solid, free of stress at rest.
struct QuadraticLaw {
  double mu;     ///< shear modulus of the solid
  double kappa;  ///< modulus of the volume
  /// U.
  template <class T>
  T energy(T const& J) const {
    using std::log;
    return (J - 1.0) * (J - 1.0) * (kappa / 2) - log(J) * mu;
  }
  /// \f$U'\f$.
  template <class T>
  T slope(T const& J) const {
    return (J - 1.0) * kappa - mu / J;
  }
  /// \f$U+m\log J\f$ from \f$J-1\f$ and \f$\log J\f$, without loss where these are small and m is \f$\mu\f$.
  double energy_beyond(double m, double j, double log) const { return kappa / 2 * j * j + (m - mu) * log; }
  /// \f$JU'+m\f$, likewise.
  double slope_beyond(double m, double j, double) const { return (1 + j) * kappa * j + (m - mu); }
};

/// A medium that knows its energy as a function of strains.
template <class Medium, int d>
concept InStrains = requires(Medium const& medium, Matrix<double, d, d> const& E) {
  strain_energy(medium, E);
  strain_stress(medium, E);
};
/// Whether a matrix is so small that what one more has is best known from it.
template <int d>
bool is_small(Matrix<double, d, d> const& A) {
  for (int k = 0; k < d * d; ++k)
    if (!(std::abs(A.data()[k]) < 0.125)) return false;
  return true;
}
/// W from \f$H = F-1\f$.
template <class Medium, int d>
double energy_from(Medium const& medium, Matrix<double, d, d> const& H) {
  if constexpr (InStrains<Medium, d>)
    if (is_small(H)) return strain_energy(medium, green_strain(H));
  return energy_of(medium, beyond_identity(H));
}
/// \f$\partial W/\partial F\f$ from H.
template <class Medium, int d>
Matrix<double, d, d> stress_from(Medium const& medium, Matrix<double, d, d> const& H) {
  if constexpr (InStrains<Medium, d>)
    if (is_small(H)) return beyond_identity(H) * strain_stress(medium, green_strain(H));
  return stress_of(medium, beyond_identity(H));
}
/// \f$2\,\partial W/\partial C\f$ from Green's strain.
template <class Medium, int d>
Matrix<double, d, d> green_stress_from(Medium const& medium, Matrix<double, d, d> const& E) {
  if constexpr (InStrains<Medium, d>)
    if (is_small(E)) return strain_stress(medium, E);
  return green_stress_of(medium, beyond_identity<d>(E * 2));
}

/// A stored energy in d dimensions, whatever its medium.
template <int d>
struct StoredEnergy {
  using Gradient = Matrix<double, d, d>;  ///< a deformation gradient, or a stress
  /// Held by \ref stored_energy.
  virtual ~StoredEnergy() = default;
  /// What W is multiplied by to be energy per reference volume, given the mass density.
  virtual double weight(double density) const = 0;
  /// W from \f$H = F-1\f$, where det F is positive. Of the solids of the library, and of Tait's liquid, it is
  /// known to some units in the last place, however small H is.
  virtual double energy_beyond(Gradient const& H) const = 0;
  /// \f$\partial W/\partial F\f$ from H, likewise.
  virtual Gradient stress_beyond(Gradient const& H) const = 0;
  /// \f$2\,\partial W/\partial C\f$ from Green's strain, likewise.
  virtual Gradient green_stress_beyond(Gradient const& E) const = 0;
  /// W(F).
  double energy(Gradient const& F) const { return energy_beyond(without_identity<d>(F)); }
  /// \f$\partial W/\partial F\f$.
  Gradient stress(Gradient const& F) const { return stress_beyond(without_identity<d>(F)); }
  /// \f$2\,\partial W/\partial C\f$, given \f$C = F^TF\f$, whose determinant is positive.
  Gradient green_stress(Gradient const& C) const { return green_stress_beyond(without_identity<d>(C) * 0.5); }
  /// The rate of \f$\partial W/\partial F\f$ along a change of F.
  virtual Gradient stress_rate(Gradient const& F, Gradient const& change) const = 0;
};

namespace detail {
template <int d, class Medium>
struct StoredEnergyOf final : StoredEnergy<d> {
  using typename StoredEnergy<d>::Gradient;
  Medium medium;
  explicit StoredEnergyOf(Medium given) : medium(std::move(given)) {}
  double weight(double density) const override {
    if constexpr (requires { medium.power; })
      return medium.power == 0 ? 1 : medium.power == 1 ? density : std::pow(density, medium.power);
    else
      return density;
  }
  double energy_beyond(Gradient const& H) const override { return energy_from(medium, H); }
  Gradient stress_beyond(Gradient const& H) const override { return stress_from(medium, H); }
  Gradient green_stress_beyond(Gradient const& E) const override { return green_stress_from(medium, E); }
  Gradient stress_rate(Gradient const& F, Gradient const& change) const override {
    return derivative_along([&](auto const& moved) { return stress_of(medium, moved); }, F, change).rate;
  }
};
}  // namespace detail

/// The stored energy of a medium: one of the fast road, of this file, or a callable W(F) per mass on
/// `Matrix<T, d, d>` over any scalar T. With `conserve = energy` W must be the same for F and QF, Q a turn.
template <int d, class Medium>
std::shared_ptr<StoredEnergy<d> const> stored_energy(Medium const& medium) {
  return std::make_shared<detail::StoredEnergyOf<d, Medium>>(medium);
}

}  // namespace actio
