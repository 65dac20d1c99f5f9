// A place to go on from: the state of a run, written whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace actio::scene {

/// Writes `path` anew: to a file beside it, to the disk, then renamed.
/// @param scene  it belongs to, to the letter
/// @throws FileError
void write_checkpoint(std::string const& path, std::string const& scene, std::string const& state);
/// The state in `path`.
/// @throws FileError  where it cannot be read, is damaged, or belongs to another scene or another version of the program
std::string read_checkpoint(std::string const& path, std::string const& scene);

/// Writes a file whole or not at all, and sees to it that it is on the disk.
/// @throws FileError
void write_whole_file(std::string const& path, std::string_view content);

}  // namespace actio::scene
