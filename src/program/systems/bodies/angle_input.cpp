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
  auto const degrees = attitude_keys.degrees.find(turn), radians = attitude_keys.radians.find(turn);
  if (degrees && radians) turn.fail("degrees", "attitude: degrees and radians exclude each other");
  if (degrees) return direction(*degrees / 2);
  if (radians) return {std::cos(*radians / 2), std::sin(*radians / 2)};
  throw SceneError(turn.place(),
                   "attitude: a turn needs 'degrees' or 'radians' beside its axis, for example { "
                   "axis = [0, 0, 1], degrees = 30 }");
}

}  // namespace

std::vector<double> AngleKeys::read(SceneTable const& initial, long size) const {
  std::string const key = AnyKey(name()).name();
  if (!initial.is_table(key)) return initial.numbers(key, size);
  auto values = degrees.read(initial.inside(key), numbers("", size));
  for (double& value : values) value *= degree;
  return values;
}

Eigen::Vector4d read_turn(SceneTable const& turn) {
  auto const& key = attitude_keys.axis;
  if (!key.given(turn))
    throw SceneError(turn.place(),
                     "attitude: a turn needs 'axis', for example { axis = [0, 0, 1], degrees = 30 }");
  Eigen::Vector3d const axis = key.read(turn);
  if (!(axis.cwiseAbs().maxCoeff() > 0)) key.fail(turn, "a direction is expected, found one of length 0");
  auto const [cosine, sine] = half_of(turn);
  // Divided by its largest component first, it is neither too long nor too short for its norm.
  Eigen::Vector3d const unit = (axis / axis.cwiseAbs().maxCoeff()).normalized();
  // Zero is added, so that no zero has a minus.
  return Eigen::Vector4d(cosine, sine * unit[0], sine * unit[1], sine * unit[2]).array() + 0.0;
}

}  // namespace actio::scene
