// The mark with which spreadsheets begin a text in UTF-8: it is no part of a table.
#pragma once

#include <istream>
#include <string_view>

namespace actio::scene {

/// Goes past the mark, where the stream, which is at its beginning, has one.
inline void skip_byte_order_mark(std::istream& in) {
  if (in.peek() != 0xEF) return;
  char begin[3] = {};
  in.read(begin, 3);
  if (std::string_view(begin, 3) != "\xEF\xBB\xBF") in.clear(), in.seekg(0);
}

}  // namespace actio::scene
