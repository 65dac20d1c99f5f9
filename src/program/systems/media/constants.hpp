// The constants of a material of scenes: which of its numbers each is, and what scenes and lists say of it.
#pragma once

#include "program/catalogue/materials.hpp"
#include "program/document/file.hpp"

namespace actio::scene::materials {

/// One of the numbers of a material.
template <class Material>
struct Constant {
  double Material::*number;  ///< which one
  MaterialConstant said;     ///< its name, meaning, bound, example and unit
};
/// All of them, in the order in which lists have them.
template <class Material>
using Constants = std::vector<Constant<Material>>;

/// That a change of volume of a solid at rest takes energy: Lame's first modulus is more than
/// \f$-2\mu/d\f$.
/// @param key   of the constant that is to be changed
/// @param mu    the shear modulus at rest
/// @param more  what Lame's first modulus has besides the constant, and what it is then called
/// @throws SceneError  where it takes none, with the modulus and the bound
void require_volume_modulus(SceneTable const& table, std::string const& key, double constant, double mu,
                            int d, double more = 0, std::string const& sum = "");

}  // namespace actio::scene::materials
