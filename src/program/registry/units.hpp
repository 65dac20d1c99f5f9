// Names and units of quantities, for people who look at a picture.
#pragma once

#include "program/catalogue/bodies.hpp"
#include "program/registry/scene.hpp"

namespace actio::scene {

/// The units of a scene, as far as they are known: those that it names in [scene], or those of its body of
/// the catalogue. Empty where they are not.
struct Units {
  std::string time,  ///< "h"
      moment,        ///< of moments of inertia, "kg m^2"; "ratio" where only their ratios are known
      energy,        ///< "J", "kg m^2/h^2", "ratio/d^2"
      mass,          ///< "kg"
      length;        ///< "m"

  /// Of a unit in words: "energy x time" is "kg m^2/s".
  std::string in(std::string unit) const;
};

/// Of a scene.
/// @throws SceneError  where the names are no names, or where a body of the catalogue has units of its own
Units read_units(SceneFile const& file);
/// Of a scene with this body.
Units units_of(Body const& body);

/// `angular velocity` for `angular_velocity`.
std::string words(std::string name);
/// The unit of time: "h", "d", ...; empty where it is not known.
std::string time_unit(Scene const& scene);
/// The unit of a quantity, as far as it is known: "1/h", "kg m²/s", "energy × time", "1".
std::string unit_of(Scene const& scene, Quantity const& quantity);
/// The same in the letters of ASCII, for files: "kg m^2/s".
std::string plain_unit_of(Scene const& scene, Quantity const& quantity);

}  // namespace actio::scene
