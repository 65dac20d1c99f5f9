// What is drawn of a run, however long it is: outlines of its columns, of the drift of what it conserves, and
// rows to play it from.
#pragma once

#include <cmath>

#include "program/pictures/envelope.hpp"
#include "program/pictures/key_frames.hpp"
#include "program/registry/scene.hpp"

namespace actio::scene {

/// A run, in bounded memory.
struct Overview {
  /// A quantity that was asked for.
  struct Drawn {
    Quantity quantity;                 ///< what is drawn
    std::size_t first,                 ///< its first column in a row without the time
        size;                          ///< how many columns it has
    std::vector<std::string> ends;     ///< of the names of its columns: "_x", or "" of a scalar
    std::vector<Envelope> components;  ///< the first `most_components` of them
  };
  /// How far a conserved quantity is from where it began.
  struct Drifting {
    std::string name;     ///< of the quantity
    Envelope difference;  ///< |Q(t) - Q(0)|
    /// what the difference is relative to: that of summary.json; where there is none |Q(0)|, or the largest
    /// |Q|
    double unit = 0;
  };
  /// A picture with more curves tells nothing.
  static constexpr std::size_t most_components = 12;

  std::vector<Drawn> quantities;    ///< that were asked for, in that order
  std::vector<Drifting> drifts;     ///< of what is conserved
  std::vector<std::string> motion;  ///< columns of `key_frames` after the time
  KeyFrames key_frames;             ///< rows to play the run from
  long rows = 0;                    ///< of the run

  /// The quantity of that name; null where it was not asked for.
  Drawn const* find(std::string const& name) const;
};

/// Reads the rows of a run from the disk, once.
/// @param quiet  nothing on standard error, even where it takes long
/// @throws FileError  where the table is not there, or is not that of the scene
Overview read_overview(Scene const& scene, std::string const& folder, bool quiet);

}  // namespace actio::scene
