// Names and units of quantities, for people who look at a picture.
#pragma once

#include "actio/scene/scene.hpp"

namespace actio::scene {

/// `angular velocity` for `angular_velocity`.
std::string words(std::string name);
/// The unit of time: "h", "d", ... of a body of the catalogue; empty where the scene has units of its own.
std::string time_unit(Scene const& scene);
/// The unit of a quantity, with that of time where it is known: "1/h", "energy × h", "1".
std::string unit_of(Scene const& scene, Quantity const& quantity);

}  // namespace actio::scene
