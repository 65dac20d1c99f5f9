// Pictures of coloured cells, small enough to stand within a text: PNG with a palette or in shades of grey.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace book {

/// A colour: red, green, blue.
using Colour = std::array<unsigned char, 3>;

/// The bytes of a picture, compressed.
/// @param cells    the number of the colour of each, row by row from above
/// @param palette  at most 256 colours; where there are fewer, a cell with the number after the last one is
///                 not painted
/// @throws std::runtime_error  where zlib has no memory
std::string png(int width, int height, std::span<unsigned char const> cells,
                std::vector<Colour> const& palette);
/// The same in shades of grey, from 0, black, to 255, white.
std::string grey_png(int width, int height, std::span<unsigned char const> cells);

/// Bytes as text, in the letters of base 64.
std::string base64(std::string const& bytes);

}  // namespace book
