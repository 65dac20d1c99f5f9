// What is wrong with a scene, and where: file, line, column, what was found, what is allowed.
#pragma once

#include <string>

#include "actio/foundations/errors.hpp"

namespace actio::scene {

/// A place in a scene file, or in an argument of the command line that overrides it. Lines and columns count from 1; zero is unknown.
struct Place {
  std::string file;         ///< path, or the argument
  unsigned line = 0, column = 0;

  /// `file:line:column`
  std::string text() const { return line == 0 ? file : file + ":" + std::to_string(line) + ":" + std::to_string(column); }
};

/// The scene is wrong. Status 2 of the command.
struct SceneError : Error {
  Place place;  ///< where
  SceneError(Place where, std::string const& what) : Error(where.text() + ": " + what), place(std::move(where)) {}
};

/// The numerics failed: a step too long for its scheme, no convergence. Status 3 of the command.
struct NumericsError : Error {
  using Error::Error;
};

/// A disk or a file failed: full, not there, not permitted. Status 4 of the command.
struct FileError : Error {
  using Error::Error;
};

}  // namespace actio::scene
