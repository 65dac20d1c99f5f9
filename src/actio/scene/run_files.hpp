// The files that a run leaves in its folder.
#pragma once

#include <string>
#include <vector>

#include "actio/scene/scene.hpp"

namespace actio::scene {

/// The table of the times of the snapshots.
inline constexpr char const* times_of_snapshots = "snapshots/times.csv";
/// The files of the snapshots, as the writer names them.
std::vector<std::string> files_of_snapshots(Scene const& scene);
/// Which files of the first snapshots are not in the folder of a run any more, in words; empty where all are.
/// @param taken  how many snapshots were taken
std::string missing_snapshots(Scene const& scene, std::string const& folder, long taken);

}  // namespace actio::scene
