// Flows that a scene names, with their parameters: [initial.random], [initial.zonal_jet], ...
#pragma once

#include "program/systems/sphere/hamiltonian.hpp"

namespace actio::scene {

/// What a named state is made of.
struct StateRequest {
  SceneTable table;               ///< [initial.NAME], with its parameters
  int n;                          ///< N
  SphereHamiltonian hamiltonian;  ///< whose energy, and vorticity, the flow has
  double rotation;                ///< of the sphere, 1/time
  long seed;                      ///< where random numbers begin
};

/// The vorticity relative to the sphere, twice.
struct NamedFlow {
  sphere::SphereHarmonics relative;  ///< its coefficients
  sphere::SkewHermitian<> matrix;    ///< its matrix
};

/// `rossby_haurwitz`, `random`, ...
std::vector<std::string> names_of_states();

/// Reads the parameters of one of them, and writes defaults back.
/// @throws SceneError  where one of them is wrong
NamedFlow read_named_state(std::string const& name, StateRequest request);

}  // namespace actio::scene
