// What a scene says of a medium besides its material: its cells, its sides, and how it begins.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "actio/meshes/body_mesh.hpp"
#include "actio/meshes/side.hpp"
#include "program/registry/system.hpp"
#include "program/systems/media/keys.hpp"
#include "program/systems/media/place_formula.hpp"

namespace actio::scene {

/// `[system.mesh]`: a body in its reference space.
struct MediumMesh {
  std::string shape;           ///< box, disc, annulus, ball, shell or file
  int dimension = 2;           ///< of the body
  std::vector<double> lower;   ///< corner of a box, length
  std::vector<double> upper;   ///< the corner across, length
  std::vector<int> cells;      ///< of a box along each direction; of the others across and along
  std::vector<bool> periodic;  ///< of a box, along each direction
  double inner = 0;            ///< radius of an annulus or a shell inside, length
  double outer = 0;            ///< radius of a round body outside, length
  std::shared_ptr<media::BodyMesh const> read;  ///< from a file; null of the others
  std::map<std::string, media::Side> sides;     ///< what each does: it is free, fixed or sliding

  /// How many cells there will be, and nodes, those of round bodies from above.
  double cell_count() const;
  double node_count() const;  ///< \copydoc cell_count
  /// The mesh, checked.
  media::BodyMesh make() const;
};

/// Reads them, and writes defaults back. A file is read; of the others nothing is made.
/// @throws SceneError  where they are none
MediumMesh read_medium_mesh(SceneFile const& file);

/// A medium at the start, as formulas.
struct MediumStart {
  PlaceFormula placement;  ///< \f$\phi\f$, length
  PlaceFormula velocity;   ///< \f$\dot\phi\f$, length/time
  PlaceFormula density;    ///< mass per reference volume
  bool uniform = true;     ///< the density is a number
};
/// `[initial]` and `system.density`.
MediumStart read_medium_start(SceneFile const& file, int dimension);

}  // namespace actio::scene
