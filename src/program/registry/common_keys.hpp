// The keys that every scene has, whatever its system.
#pragma once

#include <string>
#include <vector>

#include "program/registry/system.hpp"

namespace actio::scene {

/// Those of [scene], [system], [method], [run] and [output]; what a system has of its own is not among them.
std::vector<Parameter> common_keys(System const& system);

/// What method.name may be.
std::vector<std::string> names_of_methods(System const& system);
/// What output.quantities may hold, but for what a scene names itself.
std::vector<std::string> names_of_quantities(System const& system);

}  // namespace actio::scene
