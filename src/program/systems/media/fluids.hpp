// The fluids of scenes, an object each (material.hpp says what it tells of itself).
#pragma once

#include <cmath>

#include "actio/stored_energy/strain_energies.hpp"
#include "program/systems/media/constants.hpp"
#include "program/systems/media/laws.hpp"

namespace actio::scene::materials {
/// \cond

// A gas of one entropy.
struct PolytropicGas {
  double K = 1, gamma = 2;
  static constexpr bool fluid = true, pressure_of_density = true;
  static constexpr char const* name = "polytropic_gas";
  static constexpr char const* meaning =
      "A gas of one entropy everywhere: its pressure is K times the power gamma of its density.";
  static constexpr char const* formula = "p = K\\,(\\rho/J)^\\gamma";
  static Constants<PolytropicGas> constants() {
    return {{&PolytropicGas::K, {"K", "pressure at the density 1", 0, "1", "energy/volume"}},
            {&PolytropicGas::gamma, {"gamma", "exponent, above 1", 1, "2", "1"}}};
  }
  auto stored() const { return media::isentropic_gas(K, gamma); }
  template <class Forms>
  auto fast(Forms const& on) const {
    if (gamma == 2) return on(media::FastFluid{media::PolytropicByRoots<1, 2>{K * on.density}});
    if (!on.has_power(gamma)) return on.none();
    return on(media::FastFluid{GasLaw{K * std::pow(on.density, gamma - 1), gamma, 0}});
  }
};

// Water in a thin layer.
struct ShallowWater {
  double g = 9.81;
  static constexpr bool fluid = true, pressure_of_density = true;
  static constexpr char const* name = "shallow_water";
  static constexpr char const* meaning =
      "Water in a layer that is thin beside its waves: the density is the depth "
      "of the layer times that of water, 1.";
  static constexpr char const* formula = "p = \\tfrac g2\\,(\\rho/J)^2";
  static Constants<ShallowWater> constants() {
    return {{&ShallowWater::g, {"g", "acceleration of gravity", 0, "9.81", "length/time^2"}}};
  }
  auto stored() const { return media::isentropic_gas(g / 2, 2); }
  template <class Forms>
  auto fast(Forms const& on) const {
    return on(media::FastFluid{media::PolytropicByRoots<1, 2>{g / 2 * on.density}});
  }
};

// Tait's liquid.
struct Tait {
  double B = 100, gamma = 7;
  static constexpr bool fluid = true, pressure_of_density = false;
  static constexpr char const* name = "tait";
  static constexpr char const* meaning =
      "Tait's liquid: without pressure at J = 1, where the speed of sound is the root of gamma B over the "
      "density; under J = 1 it withstands a tension less than B.";
  static constexpr char const* formula = "p = B\\,(J^{-\\gamma} - 1)";
  static Constants<Tait> constants() {
    return {{&Tait::B, {"B", "modulus, a pressure", 0, "100", "energy/volume"}},
            {&Tait::gamma, {"gamma", "exponent, above 1; about 7 for water", 1, "7", "1"}}};
  }
  auto stored() const { return media::per_volume(media::FastFluid{GasLaw{B, gamma, B}}); }
  template <class Forms>
  auto fast(Forms const& on) const {
    if (!on.has_power(gamma)) return on.none();
    return on(media::FastFluid{GasLaw{B / on.density, gamma, B / on.density}});
  }
};

/// \endcond
}  // namespace actio::scene::materials
