#include <Eigen/Core>

#include "program/systems/bodies/angle_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace actio::scene {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Cosine and sine.
struct Direction {
  double cosine, sine;
};

/// Of an angle in degrees. The quarter turns in it are taken out without rounding.
Direction direction(double degrees) {
  int quarters = 0;
  double const rest = std::remquo(degrees, 90.0, &quarters) * degree, c = std::cos(rest), s = std::sin(rest);
  switch (quarters & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Direction half_of(SceneTable const& turn) {
  bool const degrees = turn.has("degrees"), radians = turn.has("radians");
  if (degrees && radians) turn.fail("degrees", "attitude: degrees and radians exclude each other");
  if (degrees) return direction(turn.number("degrees") / 2);
  if (radians) return {std::cos(turn.number("radians") / 2), std::sin(turn.number("radians") / 2)};
  throw SceneError(turn.place(),
                   "attitude: a turn needs 'degrees' or 'radians' beside its axis, for example { "
                   "axis = [0, 0, 1], degrees = 30 }");
}

}  // namespace

std::vector<double> read_angles(SceneTable const& table, std::string const& key, long size) {
  if (!table.is_table(key)) return table.numbers(key, size);
  auto values = table.inside(key).numbers("degrees", size);
  for (double& value : values) value *= degree;
  return values;
}

std::vector<Parameter> angle_parameters(Parameter const& of, std::string const& degrees) {
  Parameter whole = of, in_degrees = of;
  whole.expects += "; or a table with degrees";
  in_degrees.key += ".degrees";
  in_degrees.fallback = "needed where " + of.key + " is a table";
  in_degrees.meaning = "The same in degrees instead of radians: " + of.key.substr(of.key.find('.') + 1) +
                       " = { degrees = " + degrees + " }.";
  in_degrees.unit = "degrees/time";
  in_degrees.example = degrees;
  return {whole, in_degrees};
}

Eigen::Vector4d read_turn(SceneTable const& turn) {
  if (!turn.has("axis"))
    throw SceneError(turn.place(),
                     "attitude: a turn needs 'axis', for example { axis = [0, 0, 1], degrees = 30 }");
  Eigen::Vector3d const axis = turn.vector("axis");
  if (!(axis.cwiseAbs().maxCoeff() > 0))
    turn.fail("axis", "axis: a direction is expected, found one of length 0");
  auto const [cosine, sine] = half_of(turn);
  // Divided by its largest component first, it is neither too long nor too short for its norm.
  Eigen::Vector3d const unit = (axis / axis.cwiseAbs().maxCoeff()).normalized();
  // Zero is added, so that no zero has a minus.
  return Eigen::Vector4d(cosine, sine * unit[0], sine * unit[1], sine * unit[2]).array() + 0.0;
}

std::vector<Parameter> attitude_parameters() {
  return {
      {"initial.attitude",
       "a unit quaternion, scalar first; or a 3 by 3 rotation matrix, a list of rows; or a table "
       "with axis and degrees or radians",
       "[1, 0, 0, 0]",
       "The rotation that takes the body to space. A quaternion off unit length, or a matrix off a "
       "rotation, by at most 1e-9 is normalised, and said; the quaternion of a matrix is the one with a "
       "scalar part that is not negative. The copy of the scene has it as it was given.",
       "", "[1, 0, 0, 0]"},
      {"initial.attitude.axis", "three numbers, not all zero", "needed where initial.attitude is a table",
       "The axis of a turn, of any length, which has the same components in the body and in space: "
       "attitude = { axis = [0, 0, 1], degrees = 30 }.",
       "", "[0, 0, 1]"},
      {"initial.attitude.degrees", "a number", "or initial.attitude.radians",
       "How far the body is turned about the axis, counter-clockwise as seen from its tip.", "degrees", "30"},
      {"initial.attitude.radians", "a number", "or initial.attitude.degrees", "The same in radians.",
       "radians", "0.5"},
  };
}

}  // namespace actio::scene
