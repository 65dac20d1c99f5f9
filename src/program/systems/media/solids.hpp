// The solids of scenes, an object each (material.hpp says what it tells of itself).
#pragma once

#include "actio/continuum/materials.hpp"
#include "actio/stored_energy/strain_energies.hpp"
#include "program/systems/media/constants.hpp"

namespace actio::scene::materials {
/// \cond

inline constexpr double any_number = -1e300;  ///< the bound of a constant without one

// Linear in Green's strain.
struct SaintVenantKirchhoff {
  double lambda = 1, mu = 1;
  static constexpr bool fluid = false;
  static constexpr char const* name = "saint_venant_kirchhoff";
  static constexpr char const* meaning =
      "The solid of St Venant and Kirchhoff: linear in the Green strain E. It "
      "does not resist collapse, and is for small strains at any rotation.";
  static constexpr char const* formula =
      "\\rho W = \\tfrac\\lambda2(\\mathrm{tr}\\,E)^2 + \\mu\\,\\mathrm{tr}\\,E^2";
  static Constants<SaintVenantKirchhoff> constants() {
    return {{&SaintVenantKirchhoff::lambda,
             {"lambda", "Lame's first modulus, more than -2 mu/d", any_number, "1", "energy/volume"}},
            {&SaintVenantKirchhoff::mu, {"mu", "shear modulus", 0, "1", "energy/volume"}}};
  }
  void require_stable(SceneTable const& table, int d) const {
    require_volume_modulus(table, "lambda", lambda, mu, d);
  }
  auto stored() const { return media::per_volume(media::FastStVenantKirchhoff{lambda, mu}); }
  template <class Forms>
  auto fast(Forms const& on) const {
    return on(media::FastStVenantKirchhoff{lambda / on.density, mu / on.density});
  }
};

// Rubber.
struct NeoHookean {
  double mu = 1, kappa = 2;
  static constexpr bool fluid = false;
  static constexpr char const* name = "neo_hookean";
  static constexpr char const* meaning =
      "A neo-Hookean solid of d dimensions, free of stress at rest, with a quadratic energy of the volume; "
      "Lame's first modulus at rest is kappa, more than -2 mu/d.";
  static constexpr char const* formula =
      "\\rho W = \\tfrac\\mu2(\\mathrm{tr}\\,C - d - 2\\ln J) + \\tfrac\\kappa2(J-1)^2";
  static Constants<NeoHookean> constants() {
    return {{&NeoHookean::mu, {"mu", "shear modulus", 0, "1", "energy/volume"}},
            {&NeoHookean::kappa, {"kappa", "modulus of the volume", any_number, "2", "energy/volume"}}};
  }
  void require_stable(SceneTable const& table, int d) const {
    require_volume_modulus(table, "kappa", kappa, mu, d);
  }
  auto stored() const { return media::per_volume(media::FastNeoHookean{mu, media::QuadraticLaw{mu, kappa}}); }
  template <class Forms>
  auto fast(Forms const& on) const {
    double const m = mu / on.density, k = kappa / on.density;
    return on(media::FastNeoHookean{m, media::ReciprocalLaw{m, k, k}});
  }
};

// Rubber with a second invariant: its energy is a function of the deformation gradient.
struct MooneyRivlin {
  double c1 = 0.4, c2 = 0.1, lambda = 1;
  static constexpr bool fluid = false;
  static constexpr char const* name = "mooney_rivlin";
  static constexpr char const* meaning =
      "The solid of Mooney and Rivlin of d dimensions, free of stress at rest, with I_1 = tr C and I_2 = "
      "((tr C)^2 - tr C^2)/2. For d > 1 its shear modulus at rest is mu = 2 (c1 + (d - 2) c2) > 0 and Lame's "
      "first modulus lambda + 4 c2 > -2 mu/d; on a line c2 does nothing, and the modulus is 4 c1 + lambda.";
  static constexpr char const* formula =
      "\\rho W = c_1(I_1-d) + c_2(I_2-\\tfrac{d(d-1)}2) - 2(c_1+(d-1)c_2)\\ln J + \\tfrac\\lambda2(\\ln J)^2";
  static Constants<MooneyRivlin> constants() {
    return {
        {&MooneyRivlin::c1, {"c1", "modulus of the first invariant", 0, "0.4", "energy/volume"}},
        {&MooneyRivlin::c2, {"c2", "modulus of the second invariant", any_number, "0.1", "energy/volume"}},
        {&MooneyRivlin::lambda,
         {"lambda", "modulus of the logarithm of the volume", any_number, "1", "energy/volume"}}};
  }
  void require_stable(SceneTable const& table, int d) const;
  auto stored() const { return media::per_volume(*this); }

  template <class T, int d>
  T operator()(Matrix<T, d, d> const& F) const {
    Matrix<T, d, d> C;
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        C(i, j) = T(0);
        for (int k = 0; k < d; ++k) C(i, j) = C(i, j) + F(k, i) * F(k, j);
      }
    return actio::MooneyRivlin{c1, c2, LogarithmicVolume<double>{lambda}}(C);
  }
};
// Its energy as a function of Green's strain.
template <int d>
double strain_energy(MooneyRivlin const& medium, Matrix<double, d, d> const& E) {
  auto const& [c1, c2, lambda] = medium;
  media::StrainMeasures<d> const of(E);
  return 2 * (c1 + (d - 1) * c2) * of.distortion + 4 * c2 * of.second +
         lambda / 2 * of.logarithm * of.logarithm;
}
// The stress of that: \f$(4(c_1+(d-1)c_2)E+\lambda\log J)\,C^{-1}+4c_2(\Tr E-E)\f$.
template <int d>
Matrix<double, d, d> strain_stress(MooneyRivlin const& medium, Matrix<double, d, d> const& E) {
  auto const& [c1, c2, lambda] = medium;
  media::StrainMeasures<d> const of(E);
  double const J = 1 + of.volume;
  Matrix<double, d, d> left = E * (4 * (c1 + (d - 1) * c2)), rest = E * (-4 * c2);
  for (int i = 0; i < d; ++i) left(i, i) += lambda * of.logarithm, rest(i, i) += 4 * c2 * E.trace();
  return left * media::cofactors(media::beyond_identity<d>(E * 2)) * (1 / (J * J)) + rest;
}

/// \endcond
}  // namespace actio::scene::materials
