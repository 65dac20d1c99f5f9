// Whether a medium of a scene can begin as it is written: its start, its density, its sides and its loads,
// each with the others. What is wrong is told at its key, before anything moves.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "program/medium_output/motion.hpp"
#include "program/systems/media/loads.hpp"

namespace actio::scene {

/// Places and velocities of the nodes at the start, which are where the formulas have them.
template <int d>
struct ExaminedStart {
  std::vector<std::array<double, d>> places;      ///< \f$\phi(X)\f$, length
  std::vector<std::array<double, d>> velocities;  ///< \f$\dot\phi(X)\f$, length/time
};

/// Placement, velocity and density at the nodes.
/// @throws SceneError  where one is not finite, a cell is inside out, a density is negative, or a seam is not
///   closed
template <int d>
ExaminedStart<d> examined_start(SceneFile const& file, MediumStart const& start, MediumCells<d> const& cells,
                                MediumMesh const& mesh);

/// Loads and sides, given the start: potentials have finite gradients at the nodes and close across seams,
/// forces act on sides that they can move, motions begin where the placement is, and sides that share a node
/// agree there.
/// @param until  the end of the run
/// @return what is no fault and still not what one would expect: a motion that begins with a push
/// @throws SceneError  where they are not so, with what was found and what would do
template <int d>
std::vector<std::string> examined_loads(SceneFile const& file, MediumMesh const& mesh,
                                        media::BodyMesh const& body, MediumLoads<d> const& loads,
                                        ExaminedStart<d> const& start, double until);

/// The nodes of a side.
template <int d>
std::vector<std::size_t> nodes_of_side(MediumMesh const& mesh, MediumCells<d> const& cells,
                                       std::string const& side);
/// The sides that are held to a velocity which they have at the start, and how fast each moves: fixed ones
/// with any velocity, sliding ones with one across them. They do work.
template <int d>
std::map<std::string, double> driven_sides(MediumMesh const& mesh, MediumCells<d> const& cells,
                                           ExaminedStart<d> const& start);

/// That the stable step is not so short that the end is out of reach.
/// @param longest  the longest stable step
/// @throws SceneError  with the value and the bound
void require_reachable_end(SceneFile const& file, double longest, double until);
/// That the energies at the start are finite.
/// @throws SceneError  with the value and the bound, at the key that makes it so
void require_finite_energies(SceneFile const& file, media::BodyEnergies const& energies);

}  // namespace actio::scene
