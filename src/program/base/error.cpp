#include "program/base/error.hpp"

#include <algorithm>

namespace actio::scene {

void TextPlace::fail(std::string_view text, std::size_t offset, std::string const& what) const {
  auto const is_first_byte = [](char c) { return (c & 0xC0) != 0x80; };
  auto const before = static_cast<unsigned>(
      std::count_if(text.begin(), text.begin() + static_cast<long>(offset), is_first_byte));
  if (!plain || begin.line == 0)
    throw SceneError(begin, "at character " + std::to_string(before + 1) + " of the text: " + what);
  throw SceneError({begin.file, begin.line, begin.column + 1 + before}, what);
}

}  // namespace actio::scene
