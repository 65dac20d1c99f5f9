// How long a run will take and how large its files will be, from a few of its steps and rows.
#pragma once

#include <string>
#include <vector>

#include "program/registry/scene.hpp"

namespace actio::app {

/// What a run will take, as far as that can be seen beforehand.
struct Estimate {
  double seconds = -1;   ///< negative where no step could be made
  double csv = 0;        ///< bytes of series.csv
  double hdf5 = 0;       ///< bytes of series.h5
  double snapshots = 0;  ///< bytes of all snapshots
};

/// Makes steps and rows of a scene, for some seconds at most. The scene is not to be run afterwards.
Estimate estimate(scene::Scene& scene);

}  // namespace actio::app
