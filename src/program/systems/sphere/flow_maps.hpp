// Maps of the snapshots of a flow: some beside one another in a picture, each with its time, the scale of
// colours below; and in shades of grey for the page of a run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/registry/scene.hpp"

namespace actio::scene {

/// How the snapshots of a run become maps.
struct FlowMaps {
  /// Values on a grid.
  struct Values {
    int rows;                    ///< of the grid
    int columns;                 ///< of each of them
    std::vector<double> values;  ///< row by row, as `book::flat_map` and `book::SphereField` have them
  };
  bool flat;                                              ///< a square; otherwise the whole sphere
  std::function<Values(std::string const& path)> values;  ///< of the coefficients in a file

  /// What `SnapshotMaps` has of them.
  /// @throws FileError, SceneError  where the coefficients of one cannot be read
  std::string picture(Scene const& scene, std::string const& folder, double width) const;
  /// As above.
  std::string json(Scene const& scene, std::string const& folder) const;
};

}  // namespace actio::scene
