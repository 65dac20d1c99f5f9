// What snapshots of a flow on the sphere hold, and their files: fields on a grid, the harmonics that they are
// made of, and all of them in one file for who works with fields of the atmosphere.
#pragma once

#include <functional>
#include <memory>

#include "actio/sphere_fields/sphere_flow.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "program/registry/system.hpp"
#include "program/systems/sphere/hamiltonian.hpp"
#include "program/systems/sphere/motion.hpp"

namespace actio::scene {

/// What they can hold.
SnapshotKind vorticity_snapshots();
/// The key that says how matrices become fields, `output.symbol`.
Parameter symbol_parameter();

/// What writes them: the vorticity relative to the sphere, in its frame.
/// @param motion  outlives the writer
/// @return null where the scene asks for none
/// @throws SceneError  where [output] is wrong
std::unique_ptr<SnapshotWriter> write_vorticity(Request const& request, int n,
                                                SphereHamiltonian const& hamiltonian,
                                                VorticityMotion const& motion);

/// Fields as NetCDF-4, after the conventions CF-1.10.
struct FieldsFile {
  /// What belongs to one time.
  struct Frame {
    sphere::FlowFields fields;          ///< on the grid
    sphere::SphereHarmonics harmonics;  ///< of the matrix
  };
  std::string title;              ///< of the scene
  std::string time_unit;          ///< "s", "h", ...; empty where it is not known
  sphere::Symbol symbol;          ///< of the fields
  SphereHamiltonian hamiltonian;  ///< by which a vorticity has a stream function

  /// Makes the file, whole.
  /// @param degrees  of the harmonics
  /// @param frame    what belongs to the time with a number
  /// @throws FileError
  void make(std::string const& path, sphere::SphereGrid const& grid, int degrees,
            std::span<double const> times, std::function<Frame(long)> const& frame, bool durable) const;
};

}  // namespace actio::scene
