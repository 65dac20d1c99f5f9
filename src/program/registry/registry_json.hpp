// The registry of systems for other programs: the book's reference pages are made from it.
#pragma once

#include <string>

namespace actio::scene {

/// All systems with their keys, methods and quantities, as JSON.
std::string registry_json();

/// All keys of scenes with the systems that have them, as JSON.
std::string keys_json();

}  // namespace actio::scene
