// The pictures of a run: drawn by one process at a time, and looked for.
#pragma once

#include "program/registry/scene.hpp"

namespace actio::app {

/// Draws the pictures of the run in a folder; while another process does, waits for it.
/// @throws FileError  where the rows cannot be read or the pictures not be written
void draw(scene::Scene const& scene, std::string const& folder, bool quiet);
/// Whether the pictures of the run that has ended in a folder are there: all of them, and not those of an
/// earlier part of it.
bool drawn(std::string const& folder);

}  // namespace actio::app
