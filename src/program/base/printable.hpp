// Text of anybody's making, as a terminal and a log may show it.
#pragma once

#include <string>
#include <string_view>

namespace actio::scene {

/// The text in one line of UTF-8: what would command a terminal, break the line or turn the direction of
/// writing is told as `\u001b`, a byte that is no UTF-8 as `\xff`.
std::string printable(std::string_view text);

/// The same, and after so many characters `...`.
std::string shown(std::string_view text, std::size_t longest = 60);

/// As a word of the shell, between quotes where it needs them.
std::string in_shell(std::string const& word);

/// The bytes before the first that is no UTF-8.
std::size_t length_in_utf8(std::string_view text);

}  // namespace actio::scene
