// A scene, read: what is simulated, and what is wanted from it.
#pragma once

#include "actio/scene/system.hpp"

namespace actio::scene {

/// A scene that is in order.
struct Scene {
  SceneFile file;
  System const* system;
  std::string title;
  long seed;
  Schedule schedule;
  std::vector<std::string> quantities;
  std::vector<std::string> formats;  ///< of the series: "csv", "hdf5"
  bool plots;
  Simulation simulation;

  /// @throws SceneError, NumericsError, FileError
  static Scene read(SceneFile file);
};

}  // namespace actio::scene
