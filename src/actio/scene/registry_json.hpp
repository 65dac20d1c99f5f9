// The registry of systems for other programs: the book's reference pages are made from it.
#pragma once

#include <string>

namespace actio::scene {

/// All systems with their parameters, methods and quantities, as JSON.
std::string registry_json();

}  // namespace actio::scene
