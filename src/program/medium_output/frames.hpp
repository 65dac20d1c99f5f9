// The snapshots of a medium in one HDF5 file, `snapshots/frames.h5`:
//
//     time (T)    position, velocity (T, nodes, d)    what was asked for (T, nodes)    stress (T, nodes, ...)
//     reference (nodes, d)    cells (cells, corners)
//
// and of a periodic box `periods` (d) and `beyond` (cells, corners, d), the number of periods by which a
// corner lies beyond the position of its node. The numbers are those of the tables, and corners are counted
// as VTK counts them. Each frame has chunks of its own, compressed without loss, with a checksum.
#pragma once

#include "program/medium_output/fields.hpp"
#include "program/output/array_file.hpp"
#include "program/registry/snapshots.hpp"
#include "program/registry/units.hpp"

namespace actio::scene {

/// The file, in the folder of the run.
inline constexpr char const* frames_file = "snapshots/frames.h5";

/// What all frames have in common; its numbers are made when they are written.
struct FrameConstant {
  SnapshotArray array;                           ///< without them
  std::function<std::vector<double>()> numbers;  ///< the last axis fastest
  std::vector<ArrayAttribute> more = {};         ///< besides meaning and unit
};
/// Numbers of each field of a frame, those of one node one after the other.
using FrameNumbers = std::vector<std::vector<double>>;

/// What the file tells of a run beside the numbers.
std::vector<ArrayAttribute> frame_texts(SceneFile const& scene);
/// Writes frames of any kind.
/// @param texts   of the file
/// @param fields  of a frame, without their numbers
/// @param times   of the frames
/// @param frame   one of them
/// @throws FileError
void write_frames(std::string const& path, std::vector<ArrayAttribute> const& texts,
                  std::vector<FrameConstant> const& constants, std::vector<SnapshotArray> const& fields,
                  std::string const& time_unit, std::span<double const> times,
                  std::function<FrameNumbers(long)> const& frame, bool durable);

/// The snapshots of a medium as frames.
template <int d>
struct MediumFrames {
  using Place = std::array<double, d>;  ///< a point, or a vector
  using Numbers = FrameNumbers;         ///< of a frame

  /// Of the motion at one time, without their numbers.
  /// @param asked  what a frame holds besides places and velocities
  /// @param units  of the scene
  static std::vector<SnapshotArray> fields(MediumCells<d> const& cells, MediumFields<d> const& asked,
                                           Units const& units);
  static std::vector<FrameConstant> constants(MediumCells<d> const& cells);  ///< of all frames

  /// The numbers of one frame out of its table.
  /// @param columns  that it has
  /// @throws FileError
  static Numbers read(std::string const& table, std::vector<std::string> const& columns,
                      std::vector<SnapshotArray> const& fields);
};

}  // namespace actio::scene
