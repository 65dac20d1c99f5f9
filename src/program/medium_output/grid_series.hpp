// The snapshots of a run as grids for ParaView: a .vtu file of each, and snapshots/series.pvd, which lists
// them with their times.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace actio::scene {

/// The files that so many snapshots leave.
std::vector<std::string> grid_series_files(long taken);
/// Writes them. Grids that are there, and made of what their tables hold, stay as they are.
/// @param folder  of the run
/// @param times   of the snapshots
/// @param write   one grid, under this path
/// @throws FileError
void write_grid_series(std::string const& folder, std::span<double const> times,
                       std::function<void(std::string const& path, long number)> const& write, bool durable);

}  // namespace actio::scene
