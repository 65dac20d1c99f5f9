// What media have stored, as functions of small strains: W and \f$2\,\partial W/\partial C\f$ of Green's
// strain E, by which nothing subtracts one; and from the gradient of the displacement \f$H = F-1\f$ of any
// medium.
#pragma once

#include "actio/stored_energy/energies_of_gradients.hpp"
#include "actio/stored_energy/small_strains.hpp"

namespace actio::media {

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

}  // namespace actio::media
