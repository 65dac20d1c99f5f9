// What is wrong with a scene, and where: file, line, column, what was found, what is allowed. Each complaint
// is one line that a terminal may show, whatever the file holds.
#pragma once

#include <string>
#include <string_view>

#include "actio/numbers/errors.hpp"
#include "program/base/printable.hpp"

namespace actio::scene {

/// A place in a scene file, or in an argument of the command line that overrides it. Lines and columns count
/// from 1, columns in characters; zero is unknown.
struct Place {
  std::string file;   ///< path, or the argument
  unsigned line = 0,  ///< from 1; 0: unknown
      column = 0;     ///< in characters, from 1; 0: unknown

  /// File, line and column, with colons between them.
  std::string text() const {
    return line == 0 ? file : file + ":" + std::to_string(line) + ":" + std::to_string(column);
  }
};

/// The scene is wrong. Status 2 of the command.
struct SceneError : Error {
  Place place;  ///< where
  /// @param what  was found, and what is allowed
  SceneError(Place where, std::string const& what)
      : Error(printable(where.text() + ": " + what)), place(std::move(where)) {}
};

/// Where a text stands, so that a complaint can point into it.
struct TextPlace {
  Place begin;         ///< of the text with its quotes
  bool plain = false;  ///< whether it stands there as it is, one character for each, after one quote

  /// @throws SceneError  at the character so many bytes into the text; where it does not stand there as it
  ///                     is, at its beginning, with that number in words
  [[noreturn]] void fail(std::string_view text, std::size_t offset, std::string const& what) const;
};

/// The numerics failed: a step too long for its scheme, no convergence. Status 3 of the command.
struct NumericsError : Error {
  /// @param what  failed
  explicit NumericsError(std::string const& what) : Error(printable(what)) {}
};

/// A disk or a file failed: full, not there, not permitted. Status 4 of the command.
struct FileError : Error {
  /// @param what  failed, and the path
  explicit FileError(std::string const& what) : Error(printable(what)) {}
};

}  // namespace actio::scene
