// Everything that has a name: what `actio list` lists and `actio show` tells of.
#pragma once

#include <string>
#include <vector>

#include "program/registry/system.hpp"

namespace actio::app {

/// A method and a system that is stepped by it.
struct MethodOf {
  scene::Method const* method;
  scene::System const* system;
};
/// A quantity and a system that has it.
struct QuantityOf {
  scene::Quantity const* quantity;
  scene::System const* system;
};
std::vector<MethodOf> all_methods();
std::vector<QuantityOf> all_quantities();

/// What can be listed: `systems`, `groups`, ...
std::vector<std::string> const& kinds_of_lists();
/// The names in one of the lists, in its order, each once.
std::vector<std::string> names_in(std::string const& list);
/// The names in all of them.
std::vector<std::string> all_names();

/// Names with commas between; `all` where these are all systems.
std::string names_of(std::vector<scene::System const*> const& of);

/// A statement of the thesis with what it is about, where `statement` is the id of one; otherwise as it is.
std::string statement_in_words(std::string const& statement);

}  // namespace actio::app
