// A place to go on from: the state of a run, written whole or not at all.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "program/document/file.hpp"

namespace actio::scene {

/// What of a scene determines the numbers of its run, as a text: all but its title, whether there are
/// pictures, and how far it goes where rows are at the multiples of `every`. A checkpoint belongs to it.
std::string what_determines(SceneFile const& scene);

/// Writes `path` anew: to a file beside it, to the disk, then renamed.
/// @param scene    it belongs to: \ref what_determines
/// @param durable  whether to wait until it is on the disk
/// @throws FileError
void write_checkpoint(std::string const& path, std::string const& scene, std::string const& state,
                      bool durable = true);
/// The state in `path`, which begins with the files that the scene was read with.
/// @param scene  it has to belong to; none: whichever it belongs to
/// @throws FileError  where it cannot be read, is damaged, or belongs to another scene or another version of
///                    the program
std::string read_checkpoint(std::string const& path, std::optional<std::string> const& scene);
/// Refuses to go on with the run in a folder where a file that its scene was read with has changed.
/// @throws SceneError  with its name
/// @throws FileError   as \ref read_checkpoint
void refuse_changed_inputs(std::string const& folder);

/// Writes a file whole or not at all, and sees to it that it is on the disk.
/// @param durable  without it, only that it is there for other programs: a process that writes many small
///                 files lets the disk catch up with all of them at once
/// @throws FileError
void write_whole_file(std::string const& path, std::string_view content, bool durable = true);

}  // namespace actio::scene
