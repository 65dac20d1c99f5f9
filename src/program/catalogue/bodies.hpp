// The bodies of the catalogue, which the program carries with it.
#pragma once

#include <string>
#include <vector>

#include "actio/bodies/body.hpp"

namespace actio::scene {

/// All of them, in the order of their names.
std::vector<Body> const& library_bodies();
/// Their names.
std::vector<std::string> names_of_bodies();
/// The one of that name; null where there is none.
Body const* find_body(std::string const& name);

}  // namespace actio::scene
