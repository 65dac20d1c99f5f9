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

}  // namespace actio::scene
