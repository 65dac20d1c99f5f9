// Flows on the torus that a scene names.
#pragma once

#include "program/systems/torus/input.hpp"

namespace actio::scene {

/// What a named state is made from.
struct TorusStateRequest {
  SceneFile const& file;  ///< of the scene
  int n;                  ///< N
  double gamma;           ///< of the flow
  long seed;              ///< of the scene
};

/// What excludes a named state.
inline LeftOut const other_torus_start{"or initial.vorticity or initial.file"};

/// Their names.
std::vector<std::string> names_of_torus_states();
/// The records of their keys.
std::vector<Parameter> parameters_of_torus_states();
/// The vorticity of one; in a layer the potential one.
/// @throws SceneError  where its parameters are wrong
torus::TorusHarmonics read_torus_state(std::string const& name, TorusStateRequest const& in);

}  // namespace actio::scene
