// The snapshots of a medium in one HDF5 file, `snapshots/frames.h5`:
//
//     time (T)    place, velocity (T, nodes, d)    what was asked for (T, nodes)    stress (T, nodes, ...)
//     reference (nodes, d)    cells (cells, corners)
//
// and of a periodic box `periods` (d) and `beyond` (cells, corners, d), the number of periods by which a
// corner lies beyond the place of its node. The numbers are those of the tables, and corners are counted as
// VTK counts them.
#pragma once

#include "program/output/hdf5_frames.hpp"
#include "program/registry/units.hpp"
#include "program/systems/media/fields.hpp"

namespace actio::scene {

/// The file, in the folder of the run.
inline constexpr char const* frames_file = "snapshots/frames.h5";

/// The snapshots of a medium as frames.
template <int d>
struct MediumFrames {
  using Place = std::array<double, d>;  ///< a point, or a vector

  /// The file in the folder of a run.
  /// @param asked  what it holds besides places and velocities
  /// @param units  of the scene
  static Hdf5Frames in(std::string const& folder, MediumCells<d> const& cells, MediumFields<d> const& asked,
                       Units const& units);
  /// What all frames have in common.
  static std::vector<Hdf5Frames::Constant> constants(MediumCells<d> const& cells);
  /// The numbers of one frame, field by field.
  /// @param x, v    of the nodes; they and the fields outlive what is returned
  /// @param fields  of each node, those of one node one after the other
  static std::function<std::span<double const>(std::size_t)> one(std::vector<Place> const& x,
                                                                 std::vector<Place> const& v,
                                                                 MediumFields<d> const& asked,
                                                                 std::vector<double> const& fields);
};

}  // namespace actio::scene
