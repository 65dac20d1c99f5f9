// What snapshots of a flow on the torus hold, and their files: fields on a regular grid, the coefficients
// that they are made of, and all of them in one file of NetCDF.
#pragma once

#include "actio/quantized_torus/torus_invariants.hpp"
#include "program/registry/system.hpp"
#include "program/systems/torus/motion.hpp"

namespace actio::scene {

/// What they can hold.
SnapshotKind torus_snapshots();
/// What writes them.
/// @param motion  outlives the writer
/// @return null where the scene asks for none
std::unique_ptr<SnapshotWriter> write_torus(Request const& request, double gamma, int n,
                                            TorusMotion const& motion);

/// Some snapshots of a run as a picture; empty where it has none.
/// @throws FileError, SceneError  where the coefficients of one cannot be read
std::string torus_map(Scene const& scene, std::string const& folder, double width);
/// All of them, or a hundred, for the page of the run: in JSON their times, and their values as pictures in
/// shades of grey; `null` where there are fewer than two.
/// @throws FileError, SceneError  as above
std::string torus_maps_json(Scene const& scene, std::string const& folder);

}  // namespace actio::scene
