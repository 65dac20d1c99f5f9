// Flows that a scene names, with their parameters: [initial.random], [initial.zonal_jet], ...
#pragma once

#include "program/systems/sphere/hamiltonian.hpp"

namespace actio::scene {

/// What a named state is made of.
struct StateRequest {
  SceneFile file;                 ///< with its parameters in [initial.NAME]
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

/// What excludes a named state.
inline LeftOut const other_start{"or initial.harmonics or initial.file"};

/// `rossby_haurwitz`, `random`, ...
std::vector<std::string> names_of_states();
/// The records of their parameters.
std::vector<Parameter> parameters_of_states();

/// Reads the parameters of one of them, and writes defaults back.
/// @throws SceneError  where one of them is wrong
NamedFlow read_named_state(std::string const& name, StateRequest const& in);

}  // namespace actio::scene
