// The files that a scene reads besides itself: a mesh, a table of coefficients. What is in them determines
// the numbers of a run as the scene does: a run that goes on has the files that it began with, or stops.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "program/base/checkpoint_stream.hpp"
#include "program/base/error.hpp"

namespace actio::scene {

/// A file, and by what it is known again.
struct InputFile {
  std::string path;               ///< the whole of it
  std::uint64_t bytes = 0;        ///< its length
  std::uint64_t fingerprint = 0;  ///< \ref fingerprint_of what is in it
};
/// Those of one scene, in the order in which they were read.
using InputFiles = std::vector<InputFile>;

/// A sum over bytes (FNV-1a, eight of them at a time): enough to see that others are in their place.
std::uint64_t fingerprint_of(std::string_view bytes);

/// A file is not what it was, or not there any more.
struct InputChanged : SceneError {
  using SceneError::SceneError;
};
/// Refuses files that are not what they were. They are read for it.
/// @throws InputChanged  with the path of the first one
void refuse_changed(InputFiles const& before);
/// The same of files that were read a second time; those that were not are left alone.
void refuse_changed(InputFiles const& before, InputFiles const& now);

/// Saves, or restores, what they are known by.
void remember(CheckpointStream& stream, InputFiles& files);
/// The same of a text.
void remember(CheckpointStream& stream, std::string& text);

}  // namespace actio::scene
