// A medium out of its snapshots, as the pictures of a run show it (played_medium.hpp). Places, velocities and
// the multipliers of volumes that are kept are read; all fields follow from them.
#pragma once

#include <functional>

#include "program/medium_output/fields.hpp"
#include "program/pictures/played_medium.hpp"

namespace actio::scene {

/// A medium at one time.
template <int d>
struct MediumFrame {
  std::vector<std::array<double, d>> places;      ///< of the nodes, length
  std::vector<std::array<double, d>> velocities;  ///< of the nodes, length/time
  std::vector<double> multipliers;                ///< of the cells, where their volumes are kept
};

/// What is shown of snapshots at these times.
/// @param read  one of them
/// @return null where there are none
template <int d>
std::shared_ptr<PlayedMedium const> play_medium(MediumView<d> const& medium, std::span<double const> times,
                                                std::function<MediumFrame<d>(std::size_t)> const& read);

}  // namespace actio::scene
