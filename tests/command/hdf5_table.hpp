// A table in HDF5, read by the library itself.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "command.hpp"

namespace command {

/// A table in HDF5, and what it says of itself.
struct Hdf5Table : Table {
  std::map<std::string, std::vector<unsigned long long>> extents;  ///< of each data set
  /// of each data set, and of the file under ""
  std::map<std::string, std::map<std::string, std::string>> attributes;
};
/// Reads it strictly, as any ordinary reader does: opened for reading and nothing else.
/// @throws std::runtime_error  where it cannot be read, or its data sets differ in length
Hdf5Table read_hdf5(std::string const& path);
/// The numbers of one data set, the last index first.
/// @param extent  where its extent is written; null: nowhere
/// @throws std::runtime_error  where it cannot be read
std::vector<double> read_hdf5_numbers(std::string const& path, std::string const& name,
                                      std::vector<unsigned long long>* extent = nullptr);

}  // namespace command
