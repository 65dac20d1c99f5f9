// The materials that media of scenes are made of. Each is a struct in fluids.hpp, solids.hpp or a file of its
// own, and a line in the list here. It tells of itself:
//
//     static constexpr bool fluid;                     it is one of fluids, if not of elastic bodies
//     static constexpr char const *name, *meaning, *formula;           for scenes, for lists, in TeX
//     static Constants<M> constants();                 its numbers: name, meaning, bound, example, unit
//     auto stored() const;                             W(F) in one to three dimensions (stored_energies.hpp)
//     static constexpr bool pressure_of_density;       of a fluid: its pressure is a function of the density
//     void require_stable(SceneTable const&, int d) const;             of a solid: refuses one that is not
//     auto fast(auto const& forms) const;              its optimised form, where it has one (fast_media.hpp)
//     static M read(SceneTable const&, int d);         instead of constants(), where it is more than numbers,
//     static std::vector<MaterialConstant> said();     and what lists say of its keys
//     std::vector<std::string> remarks(int d) const;   what a run tells of it, where it has something to tell
#pragma once

#include <memory>
#include <variant>

#include "actio/stored_energy/stored_energies.hpp"
#include "program/systems/media/energy_formula.hpp"
#include "program/systems/media/fluids.hpp"
#include "program/systems/media/solids.hpp"

namespace actio::scene {

/// A material with its numbers: one of this list.
using Material = std::variant<materials::PolytropicGas,         //
                              materials::ShallowWater,          //
                              materials::Tait,                  //
                              materials::SaintVenantKirchhoff,  //
                              materials::NeoHookean,            //
                              materials::MooneyRivlin,          //
                              materials::EnergyFormula>;

/// `[system.material]`.
/// @param d  dimension of the body
/// @throws SceneError  where it is missing, no material of this kind of system, or a number is not as it
///   should be; where a body of it is not stable at rest, with the modulus and the bound
Material read_material(SceneTable const& system, bool fluid, int d);
/// What a run tells of it.
std::vector<std::string> remarks_on(Material const& material, int d);

/// Whether it is one of fluids.
bool is_fluid(Material const& material);
/// Whether the pressure of a fluid is a function of its density alone, so that it is barotropic where its
/// reference density varies, too. That of Tait's liquid is one of the Jacobian.
bool pressure_is_of_density(Material const& material);

/// Its stored energy in d dimensions, 1, 2 or 3.
template <int d>
std::shared_ptr<media::StoredEnergy<d> const> stored_energy_of(Material const& material) {
  return std::visit([](auto const& own) { return media::stored_energy<d>(own.stored()); }, material);
}

}  // namespace actio::scene
