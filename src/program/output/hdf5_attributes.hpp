// Texts beside the numbers of an HDF5 file, and how the files of a run are opened for writing.
#pragma once

#include <string>
#include <vector>

#include "program/output/hdf5_library.hpp"

namespace actio::scene::hdf5 {

/// Properties of access to a file that can be read at any instant (hdf5_file.hpp).
/// @throws FileError  where the library refuses them
Handle access_to_growing_file(Session const& h5);

/// An attribute with one text; none where it is empty.
/// @param path  of the file, for the complaint
/// @throws FileError  where it cannot be written
void attach(Session const& h5, std::string const& path, hid_t object, char const* name,
            std::string const& text);
/// An attribute with a list of texts.
/// @throws FileError  where it cannot be written
void attach(Session const& h5, std::string const& path, hid_t object, char const* name,
            std::vector<std::string> const& texts);

}  // namespace actio::scene::hdf5
