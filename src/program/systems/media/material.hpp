// The material of a medium of a scene, with its numbers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "actio/multisymplectic/stored_energies.hpp"
#include "program/catalogue/materials.hpp"
#include "program/document/file.hpp"

namespace actio::scene {

/// A material with its numbers.
struct Material {
  NamedMaterial const* record = nullptr;  ///< which one
  std::vector<double> constants;          ///< in the order of the record
};

/// `[system.material]`.
/// @throws SceneError  where it is missing, no material of this kind of system, or a number is not as it
///   should be
Material read_material(SceneTable const& system, bool fluid);

/// That a body of d dimensions at rest is stable: the shear modulus \f$\mu\f$ of a solid is positive, and
/// Lame's first one more than \f$-2\mu/d\f$, so that a change of volume takes energy.
/// @throws SceneError  where it is not, with the modulus and the bound
void require_stable_material(SceneTable const& system, Material const& material, int d);

/// Whether the pressure of a fluid is a function of its density alone, so that it is barotropic where its
/// reference density varies, too. That of Tait's liquid is one of the Jacobian.
bool pressure_is_of_density(Material const& material);

/// Its stored energy in d dimensions, 1, 2 or 3.
template <int d>
std::shared_ptr<media::StoredEnergy<d> const> stored_energy_of(Material const& material);

}  // namespace actio::scene
