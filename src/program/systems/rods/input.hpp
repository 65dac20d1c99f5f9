// What a scene says of a rod: [system], [initial] and [method].
#pragma once

#include <set>

#include "actio/rods/rod.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/method_input.hpp"
#include "program/systems/rods/shape_input.hpp"

namespace actio::scene {

/// A scene of a rod.
struct RodScene {
  std::vector<std::string> remarks;     ///< on what was read
  rods::RodSection section{};           ///< of the rod
  SceneRodShape rest;                   ///< the shape without stresses
  rods::RodStart start;                 ///< at the time 0
  rods::RodLoads loads;                 ///< supports and loads
  rods::RodOptions options{.step = 0};  ///< the step, and whether it can stretch and shear
  double longest_step = 0;              ///< that is stable, time
  std::set<Feature> features;           ///< that end what is conserved

  /// Reads it; defaults are written back.
  /// @param methods  of the system
  /// @throws SceneError     where a value is missing or wrong, with its place
  /// @throws NumericsError  where the step is not stable
  RodScene(Request const& request, std::vector<Method> const& methods);
  /// The rod with steps of this length.
  /// @throws Error  where it cannot start
  rods::Rod with_step(double step) const;

 private:
  void read_velocities(SceneFile const& file, SharedNames& shared);
  void read_steps(Request const& request);
  void hold_ends();
};

/// The records of [system], [initial] and [method].
std::vector<Parameter> rod_parameters();

}  // namespace actio::scene
