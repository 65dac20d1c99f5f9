// The files that a run leaves in its folder.
#pragma once

#include <string>
#include <vector>

#include "program/registry/scene.hpp"

namespace actio::scene {

/// The table of the times of the snapshots.
inline constexpr char const* times_of_snapshots = "snapshots/times.csv";
/// The files of the snapshots, as the writer names them.
std::vector<std::string> files_of_snapshots(Scene const& scene);
/// Files that are not in a folder any more.
struct Missing {
  std::size_t count = 0;  ///< how many
  std::string told;       ///< which, in words
};
/// Those of the first snapshots of a run.
/// @param taken  how many snapshots were taken
Missing missing_snapshots(Scene const& scene, std::string const& folder, long taken);

}  // namespace actio::scene
