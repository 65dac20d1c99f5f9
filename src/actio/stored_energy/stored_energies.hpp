// Stored energies of media as a body of any mesh needs them: W(F) in one, two or three dimensions, its first
// derivative and the change of that, for the media of the optimised implementation and for a reader's own.
//
//     auto const rubber = stored_energy<3>(per_volume(neo_hookean(2, 1)));
//     auto const air    = stored_energy<2>(isentropic_gas(1, 1.4));
//     auto const own    = stored_energy<2>([](auto const& F) { return ...; });   // per mass, any scalar
#pragma once

#include <memory>

#include "actio/stored_energy/strain_energies.hpp"

namespace actio::media {

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

/// The stored energy of a medium: one of the optimised implementation, of this file, or a callable W(F) per
/// mass on `Matrix<T, d, d>` over any scalar T. With `conserve = energy` W must be the same for F and QF, Q a
/// turn.
///
/// \snippet media.cpp own_energy
template <int d, class Medium>
std::shared_ptr<StoredEnergy<d> const> stored_energy(Medium const& medium) {
  return std::make_shared<detail::StoredEnergyOf<d, Medium>>(medium);
}

}  // namespace actio::media
