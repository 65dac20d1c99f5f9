// The argument SCENE: a file, or `-` for standard input.
#pragma once

#include <string>
#include <vector>

#include "program/document/file.hpp"

namespace actio::app {

/// The scene of an argument, called `standard input` in messages and by default in its title where it is `-`;
/// a file of that name is `./-`.
/// @throws SceneError, FileError  as `SceneFile::read`
scene::SceneFile scene_of(std::string const& argument, std::vector<std::string> const& overrides);
/// The folder for its run where none is named: the scene's name beside it.
/// @param plan  whether it is only told, not made
/// @throws SceneError  where the scene has no name
std::string folder_beside(std::string const& argument, bool plan);

}  // namespace actio::app
