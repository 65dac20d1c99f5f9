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
/// What is seen of a flow on a grid, with the curl of its velocity, which for Euler's fluid is the vorticity.
struct SphereFields : sphere::FlowFields {
  sphere::GridField curl;  ///< 1/time
};
/// How matrices become fields.
struct SymbolKeys : KeyTable {
  Key<std::string> symbol = key(
      "symbol", one_of("symbol", {"berezin", "weyl"}), "berezin",
      "How matrices become fields in snapshots, on N parallels at Gauss's latitudes and 2N meridians, in "
      "radians: berezin, whose values never leave the interval of the eigenvalues of -iW, or weyl, with "
      "the coefficients of the matrix, which does. The files snapshots/000000.harmonics.csv, ... with rows "
      "l,m,re,im, m >= 0, from which initial.file begins a run, hold those of the matrix.",
      "\"weyl\"");
};
inline SymbolKeys const symbol_keys{{"output"}};  ///< its key

/// What writes them: the vorticity relative to the sphere, in its frame.
/// @param motion  outlives the writer
/// @return null where the scene asks for none
/// @throws SceneError  where [output] is wrong
std::unique_ptr<SnapshotWriter> write_vorticity(Request const& request, int n,
                                                SphereHamiltonian const& hamiltonian,
                                                VorticityMotion const& motion);

/// Maps of some snapshots of a run: the whole sphere in the projection of Mollweide, with the north above and
/// the longitude pi in the middle.
/// @throws FileError, SceneError  where the coefficients of one cannot be read
std::string vorticity_map(Scene const& scene, std::string const& folder, double width);
/// Values on a grid of equal angles for the page of the run.
/// @throws FileError, SceneError  as above
std::string vorticity_maps_json(Scene const& scene, std::string const& folder);

/// Fields as NetCDF-4, after the conventions CF-1.10.
struct FieldsFile {
  /// What belongs to one time.
  struct Frame {
    SphereFields fields;                ///< on the grid
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
