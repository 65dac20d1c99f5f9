// A folder that a test reads its files from.
#pragma once

#include <string>

#include "command.hpp"

namespace actio::scene {

/// A folder of its own, gone afterwards, that reads its files.
struct ReadableFolder : command::Folder {
  std::string const path = *this / "";
  std::string operator()(std::string const& name) const { return command::contents(*this / name); }
};

}  // namespace actio::scene
