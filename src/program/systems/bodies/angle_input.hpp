// Angles in a scene. A number or a list is in radians; a table says its unit: { degrees = 30 }.
#pragma once

#include <Eigen/Core>

#include "program/registry/system.hpp"

namespace actio::scene {

/// Angles, or angular velocities, in radians: `size` numbers, or any number where it is negative; or a table
/// with such a list under `degrees`.
/// @throws SceneError  where they are of another length, not finite, or in an unknown unit
std::vector<double> read_angles(SceneTable const& table, std::string const& key, long size);

/// The records of such a key, and of the key in its table.
/// @param of  the key, with what it expects, what stands where it is left out, its meaning, unit and example,
/// in radians
/// @param degrees  the example in degrees
std::vector<Parameter> angle_parameters(Parameter const& of, std::string const& degrees);

/// An attitude as a turn about an axis, a table with `axis`, of any length, and the angle in `degrees` or
/// `radians`: the unit quaternion \f$(\cos\tfrac\theta2, \sin\tfrac\theta2\, a/|a|)\f$, up to rounding; for
/// quarter turns in degrees it is exact.
/// @throws SceneError  where there is no axis, or not one angle
Eigen::Vector4d read_turn(SceneTable const& turn);

/// The records of an attitude in space and of the keys of its table.
std::vector<Parameter> attitude_parameters();

}  // namespace actio::scene
