// The table of a run in HDF5, `series.h5`: a data set for each quantity, rows along its first axis, and `t`.
// Attributes tell unit, meaning, formula, statement and the names of the columns, those of the file title,
// system, version and scene.
//
//     h5ls series.h5,   h5py.File("series.h5", "r")
#pragma once

#include <functional>

#include "program/output/series.hpp"

namespace actio::scene {

/// Makes it out of the rows that are in `series.csv`, whole; memory does not grow with their number.
/// @param durable  whether it is on the disk afterwards
/// @param see      told how much of the rows is in it, from 0 to 1; may be empty
/// @throws FileError
void make_hdf5_series(std::string const& folder, SeriesHead const& head, bool durable,
                      std::function<void(double)> const& see = {});

}  // namespace actio::scene
