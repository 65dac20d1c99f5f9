// The files of a run that are made of its plain ones for other programs: HDF5, NetCDF, grids for ParaView.
//
// While a run goes on, rows and snapshots are appended to plain files and to nothing else. What other formats
// hold is made of these, whole, from time to time and at the end, and at any time by `actio export`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/registry/scene.hpp"

namespace actio::scene {

/// The formats in which a run of the scene can be had besides csv.
std::vector<std::string> formats_of_exports(Scene const& scene);
/// The files that a format leaves.
/// @param taken  how many snapshots there are
std::vector<std::string> files_of_export(Scene const& scene, std::string const& format, long taken);

/// How files are made.
struct Exporting {
  bool durable = true;  ///< they are on the disk afterwards
  bool wait = true;     ///< until no other process makes any in the folder; otherwise none are made meanwhile
  /// Told how much of the rows is in them, from 0 to 1; may be empty.
  std::function<void(double)> see = {};
};
/// Makes the files of these formats in the folder of a run out of its rows and snapshots.
/// @return false where another process makes some, and is not waited for
/// @throws FileError  where one cannot be made; the one that was there is then as it was
bool make_exports(Scene const& scene, std::string const& folder, std::vector<std::string> const& formats,
                  Exporting const& how = {});

}  // namespace actio::scene
