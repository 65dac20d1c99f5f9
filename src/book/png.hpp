// A picture of coloured cells, small enough to stand within a text: PNG with a palette, not compressed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace book {

/// A colour: red, green, blue.
using Colour = std::array<unsigned char, 3>;

namespace detail {

inline void append_number(std::string& out, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xff);
}
/// The checksum of a piece of PNG.
inline std::uint32_t crc32(std::string const& bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (unsigned char const byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  return ~crc;
}
inline void append_piece(std::string& out, std::string const& kind, std::string const& content) {
  append_number(out, static_cast<std::uint32_t>(content.size()));
  out += kind + content;
  append_number(out, crc32(kind + content));
}
/// As zlib has it, in blocks that are stored as they are.
inline std::string stored(std::string const& bytes) {
  constexpr std::size_t most = 65535;
  std::string out = "\x78\x01";
  for (std::size_t at = 0; at == 0 || at < bytes.size(); at += most) {
    std::size_t const size = std::min(most, bytes.size() - at);
    out += at + size == bytes.size() ? '\1' : '\0';
    for (std::size_t const n : {size, ~size})
      out += static_cast<char>(n & 0xff), out += static_cast<char>(n >> 8 & 0xff);
    out += bytes.substr(at, size);
  }
  std::uint32_t a = 1, b = 0;
  for (unsigned char const byte : bytes) a = (a + byte) % 65521, b = (b + a) % 65521;
  append_number(out, b << 16 | a);
  return out;
}

}  // namespace detail

/// The bytes of a picture.
/// @param cells    the number of the colour of each, row by row from above
/// @param palette  at most 256 colours
inline std::string png(int width, int height, std::span<unsigned char const> cells,
                       std::vector<Colour> const& palette) {
  std::string head, colours, rows;
  detail::append_number(head, static_cast<std::uint32_t>(width));
  detail::append_number(head, static_cast<std::uint32_t>(height));
  head += std::string("\x08\x03\0\0\0", 5);  // a byte for each cell, by a palette
  for (auto const& colour : palette)
    for (unsigned char const part : colour) colours += static_cast<char>(part);
  for (int row = 0; row < height; ++row) {
    rows += '\0';
    for (int column = 0; column < width; ++column)
      rows += static_cast<char>(cells[static_cast<std::size_t>(row * width + column)]);
  }
  std::string out = "\x89PNG\r\n\x1a\n";
  detail::append_piece(out, "IHDR", head);
  detail::append_piece(out, "PLTE", colours);
  detail::append_piece(out, "IDAT", detail::stored(rows));
  detail::append_piece(out, "IEND", "");
  return out;
}

/// Bytes as text, in the letters of base 64.
inline std::string base64(std::string const& bytes) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::size_t const there = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8 | (i < there ? static_cast<unsigned char>(bytes[at + i]) : 0);
    for (std::size_t i = 0; i < 4; ++i) out += i <= there ? letters[three >> (18 - 6 * i) & 63] : '=';
  }
  return out;
}

}  // namespace book
