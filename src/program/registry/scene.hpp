// A scene, read: what is simulated, and what is wanted from it.
#pragma once

#include "program/registry/pilot.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A scene that is in order.
struct Scene {
  SceneFile file;                          ///< as written, with its defaults
  System const* system;                    ///< its kind of system
  std::string title;                       ///< for people
  long seed;                               ///< not negative
  Schedule schedule;                       ///< when there are rows
  std::vector<std::string> quantities;     ///< names of those that the rows hold
  std::vector<std::string> formats;        ///< of the series: "csv", "hdf5"; and of snapshots: "netcdf"
  bool plots;                              ///< whether its pictures are drawn
  Simulation simulation;                   ///< ready to run
  std::optional<Schedule> snapshots = {};  ///< when there are snapshots; none: never

  std::optional<double> accuracy = {};  ///< that steps were chosen by; none: the scene asks for none

  /// @param pilots  by which steps are chosen, where it asks for an accuracy
  /// @throws SceneError, NumericsError, FileError, Stopped
  static Scene read(SceneFile file, Pilots const& pilots = {});
};

}  // namespace actio::scene
