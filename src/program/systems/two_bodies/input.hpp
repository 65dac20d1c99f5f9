// What a scene says of two bodies that attract each other: [system], [initial] and [method].
#pragma once

#include <Eigen/Core>

#include "actio/two_bodies/two_bodies.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {

/// A scene of two bodies.
struct PairScene {
  std::vector<std::string> remarks;  ///< on what was read
  bodies::ExtendedBody primary,      ///< the first body
      secondary;                     ///< the second body
  std::array<double, 2> densities;   ///< mass/length^3; zero where the scene does not tell one
  bodies::TwoBodyOptions options;    ///< order, method, step, G, third body, tides
  bodies::TwoBodyState start;        ///< at the time 0
  MethodChoice choice;               ///< of the method and its order
  double fastest_turn = 0,           ///< the larger one of both angular velocities, 1/time
      fastest_orbit = 0;             ///< angular velocity in the pericentre, 1/time

  /// Reads it; defaults are written back.
  /// @param methods  of the system
  /// @throws SceneError  where a value is missing or wrong, with its place: a body that is none, an order
  ///                     that the moments do not have, bodies so near that the series need not converge
  PairScene(Request const& request, std::vector<Method> const& methods);

 private:
  double mass() const { return primary.mass() + secondary.mass(); }
  void read_bodies(SceneFile const& file);        // and the order and the constant of their potential
  void read_surroundings(SceneFile const& file);  // a third body, and tides
  void read_start(SceneFile const& file);
  void require_apart(SceneTable const& initial);
  void read_steps(Request const& request, std::vector<Method> const& methods);
};

/// The records of [system], [initial] and [method].
std::vector<Parameter> pair_parameters();

}  // namespace actio::scene
