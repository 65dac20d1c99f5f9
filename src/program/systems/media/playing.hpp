// A medium out of its snapshots, as the pictures of a run show it (played_medium.hpp). Places and velocities
// are read; all fields follow from them.
#pragma once

#include <functional>

#include "program/output/hdf5_frames.hpp"
#include "program/pictures/played_medium.hpp"
#include "program/systems/media/fields.hpp"

namespace actio::scene {

/// A medium at one time.
template <int d>
struct MediumFrame {
  std::vector<std::array<double, d>> places;      ///< of the nodes, length
  std::vector<std::array<double, d>> velocities;  ///< of the nodes, length/time

  /// One of the frames in HDF5.
  static MediumFrame in_hdf5(Hdf5Frames const& frames, std::size_t number);
  /// A snapshot that is a table.
  /// @param asked  its columns besides places and velocities
  static MediumFrame in_table(std::string const& file, MediumFields<d> const& asked);
};

/// What is shown of snapshots at these times.
/// @param read  one of them
/// @return null where there are none
template <int d>
std::shared_ptr<PlayedMedium const> play_medium(MediumView<d> const& medium, std::span<double const> times,
                                                std::function<MediumFrame<d>(std::size_t)> const& read);

}  // namespace actio::scene
