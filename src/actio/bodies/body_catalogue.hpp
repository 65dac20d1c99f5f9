// The catalogue of bodies: data/bodies.toml, read and checked.
//
// A body gives its inertia as principal moments, as a tensor, as point masses or as solid cylinders, from
// which it is computed. The reader is compiled once: who includes this reads no TOML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "actio/bodies/body.hpp"

namespace actio {

/// An entry of a catalogue that cannot be used: says which file, body and key.
struct CatalogueError : Error {
  /// @param what  what is wrong; `body` and `key` may be empty
  CatalogueError(std::string const& file, std::string const& body, std::string const& key,
                 std::string const& what)
      : Error(file + (body.empty() ? "" : ": [" + body + "]") + (key.empty() ? "" : " " + key) + ": " +
              what) {}
};

/// All bodies of a catalogue that is in a text, in the order of their names.
/// @param file  what it is called in messages
/// @throws CatalogueError  where the text is no TOML or holds no body, or an entry is missing, unknown, no
///                         number, or no inertia of a body
std::vector<Body> parse_bodies(std::string_view text, std::string const& file);
/// The same from a file.
/// @throws CatalogueError  where it cannot be read, too
std::vector<Body> read_bodies(std::string const& file);
/// The body with that name.
///
/// \snippet bodies.cpp read_body
/// @throws CatalogueError  where there is none, with the names there are
Body read_body(std::string const& file, std::string const& name);

}  // namespace actio
