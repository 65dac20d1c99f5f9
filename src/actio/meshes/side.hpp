// What a side of a body or of a box does.
#pragma once

#include <array>
#include <string>

namespace actio::media {

/// What a side does. Boxes of cells are not moved, and bodies of a mesh are periodic by their cells.
enum class Side {
  free,      ///< no force acts on it but loads: the section is varied there as anywhere else
  fixed,     ///< its nodes keep the velocity that they have at the start; a section is given and not varied
  sliding,   ///< so does the component across the side, i in direction i; the others are free
  periodic,  ///< it is the opposite side, moved by a period
  moved      ///< its nodes are where a motion has them
};

/// Their names, as scenes and messages write them.
inline constexpr std::array<char const*, 5> names_of_sides{"free", "fixed", "sliding", "periodic", "moved"};
/// The name of one.
inline std::string name_of(Side side) { return names_of_sides[static_cast<std::size_t>(side)]; }

}  // namespace actio::media
