// How the command writes: columns, headings, formulas.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace actio::app {

/// Rows of cells with their columns aligned, two spaces between; nothing after the last. `indent` stands
/// before each row.
std::string aligned(std::vector<std::vector<std::string>> const& rows, std::string const& indent = "");

/// Text whose lines hold at most `width` letters, broken between words; lines after the first begin with
/// `indent` spaces.
std::string wrapped(std::string const& text, std::size_t width, std::size_t indent);

/// A name as a shell takes it: `apophis`, `'my run'`, `./-n`; with control characters as $'a\nb'.
std::string in_shell(std::string const& name);

/// Bold where `stream` is a terminal and NO_COLOR is not set.
std::string heading(std::string const& text, std::FILE* stream = stdout);

/// A TeX formula in plain letters: `H = \tfrac12\langle M, I^{-1}M\rangle` is `H = 1/2 <M, I^-1 M>`.
std::string plain_formula(std::string_view tex);

}  // namespace actio::app
