// Angles in a scene. A number or a list is in radians; a table says its unit: { degrees = 30 }.
#pragma once

#include <Eigen/Core>

#include "program/registry/system.hpp"

namespace actio::scene {

/// Angles, or angular velocities: a list in radians; or a table with the same in degrees.
struct AngleKeys : KeyTable {
  std::string expects, example;  ///< of the list in degrees
  Key<std::vector<double>> degrees =
      key("degrees", numbers(expects).in("degrees/time"), LeftOut{"needed where " + name() + " is a table"},
          "The same in degrees instead of radians: " + AnyKey(name()).name() + " = { degrees = " + example +
              " }.",
          example);

  /// In radians; `size` numbers, or any number where it is negative.
  /// @throws SceneError  where they are of another length, not finite, or in an unknown unit
  std::vector<double> read(SceneTable const& initial, long size) const;
};

/// A turn in space.
struct AttitudeKeys : KeyTable {
  Key<Eigen::Vector3d> axis = key(
      "axis", vector.called("three numbers, not all zero"), LeftOut{"needed where " + name() + " is a table"},
      "The axis of a turn, of any length, which has the same components in the body and in space: "
      "attitude = { axis = [0, 0, 1], degrees = 30 }.",
      "[0, 0, 1]");
  Key<double> degrees =
      key("degrees", number.in("degrees"), LeftOut{"or " + name() + ".radians"},
          "How far the body is turned about the axis, counter-clockwise as seen from its tip.", "30");
  Key<double> radians = key("radians", number.in("radians"), LeftOut{"or " + name() + ".degrees"},
                            "The same in radians.", "0.5");
};
/// An attitude in space, or its table.
inline AttitudeKeys const attitude_keys{
    {"initial.attitude", LeftOut{"[1, 0, 0, 0]"},
     "The rotation that takes the body to space. A quaternion off unit length, or a matrix off a "
     "rotation, by at most 1e-9 is normalised, and said; the quaternion of a matrix is the one with a "
     "scalar part that is not negative. The copy of the scene has it as it was given.",
     "[1, 0, 0, 0]",
     "a unit quaternion, scalar first; or a 3 by 3 rotation matrix, a list of rows; or a table "
     "with axis and degrees or radians"}};

/// An attitude as a turn about an axis, a table with `axis`, of any length, and the angle in `degrees` or
/// `radians`: the unit quaternion \f$(\cos\tfrac\theta2, \sin\tfrac\theta2\, a/|a|)\f$, up to rounding; for
/// quarter turns in degrees it is exact.
/// @throws SceneError  where there is no axis, or not one angle
Eigen::Vector4d read_turn(SceneTable const& turn);

}  // namespace actio::scene
