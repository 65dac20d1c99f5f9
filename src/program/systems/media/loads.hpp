// What acts on a medium of a scene from outside, and where its sides are moved: formulas with their exact
// derivatives.
#pragma once

#include "actio/formula/tape.hpp"
#include "actio/media_on_meshes/body_loads.hpp"
#include "program/systems/media/input.hpp"

namespace actio::scene {

/// Whether the scene has loads, an obstacle or moved sides.
bool has_loads(SceneFile const& file);

/// A load that depends on time.
struct LoadInTime {
  std::string key;  ///< for messages: "pressure.right"
  Tape second;  ///< value, first and second derivative by the time, its last input; the others are X, Y, Z
};

/// What the sides of a body do, those that are moved among them, and its loads.
template <int d>
struct MediumLoads {
  media::BodySides<d> sides;             ///< by their names
  media::BodyLoads<d> loads;             ///< what acts on it
  bool gravity = false;                  ///< whether the first potential is that of gravity
  std::vector<LoadInTime> in_time = {};  ///< those that depend on time

  /// Where gravity pulls at a place, in words: "gravity pulls along (0, -1) with 9.81 ..."; empty without it.
  /// @param steepest  the largest slope in the body: 1e-12 of that is rounding
  std::string pull_of_gravity(std::array<double, d> const& x, double steepest) const;
  /// How fast gravity changes at a place, acceleration; zero without it.
  double slope_of_gravity(std::array<double, d> const& x) const;
};

/// The largest frequency of loads that depend on time: each is looked at over all times
/// (\ref change_in_time), at three points of the body, in its reference space; 1/time.
/// @param remarks  are told what was not found out
double frequency_of(std::vector<LoadInTime> const& loads, std::vector<std::array<double, 3>> const& points,
                    double until, std::vector<std::string>& remarks);

/// `[system.load]`, `[system.obstacle]` and what the mesh says of sides.
/// @throws SceneError  where a side is unknown, or a formula is none
template <int d>
MediumLoads<d> read_medium_loads(SceneFile const& file, MediumMesh const& mesh);

}  // namespace actio::scene
